// Light of three colours, red, green and blue, that is refracted differently. A path goes on with one of them, drawn at random, from where
// they part. KHR_materials_dispersion
import package::sampler::{Sampler, independent};
import package::scene::spreadOf;
import package::surface::spectralShift;

// A decision of its own, once per path: see independent().
const COLOR = 0x0fffffffu;

// Three times the color that the path has or would have, and whether it has it yet.
var<private> color: vec3f;
var<private> isOneColor: bool;

fn drawColor(samples: Sampler) {
  let i = min(u32(3.0 * independent(samples, COLOR)), 2u);
  color = select(vec3f(0.0), vec3f(3.0), vec3u(0u, 1u, 2u) == vec3u(i));
  spectralShift = f32(i) - 1.0;
  isOneColor = false;
}

// What the path's weight is multiplied by where it meets a primitive.
fn disperse(id: u32) -> vec3f {
  if (isOneColor || spreadOf(id) == 0.0) { return vec3f(1.0); }
  isOneColor = true;
  return color;
}
