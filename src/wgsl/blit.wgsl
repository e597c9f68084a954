// Shows the film: mean radiance, exposed, tone-mapped and encoded. A target of another size gets that picture stretched:
// were radiance interpolated instead, a bright pixel would spread over its neighbours.
import package::tonemap::displayed;

struct View {
  filmSize: vec2u,
  targetSize: vec2u,
  // Factor on radiance.
  exposure: f32,
  // See `displayed`.
  toneMap: u32,
}

@group(0) @binding(0) var<uniform> view: View;
// Radiance sums and sample counts, half 0 then half 1.
@group(0) @binding(1) var<storage, read> film: array<vec4f>;
// What `show` drew, of the film's size.
@group(0) @binding(2) var picture: texture_2d<f32>;
// Clamped to the edge.
@group(0) @binding(3) var bilinear: sampler;

@vertex
fn coverTarget(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
  return vec4f(vec2f(vec2u(index << 1u, index) & vec2u(2u)) * 2.0 - 1.0, 0.0, 1.0);
}

// Pixel by pixel.
@fragment
fn show(@builtin(position) position: vec4f) -> @location(0) vec4f {
  let pixel = vec2u(position.xy);
  let index = pixel.y * view.filmSize.x + pixel.x;
  let sum = film[index] + film[view.filmSize.x * view.filmSize.y + index];
  let radiance = sum.rgb / max(sum.w, 1.0);
  return vec4f(displayed(radiance * view.exposure, view.toneMap), 1.0);
}

@fragment
fn stretch(@builtin(position) position: vec4f) -> @location(0) vec4f {
  return textureSampleLevel(picture, bilinear, position.xy / vec2f(view.targetSize), 0.0);
}
