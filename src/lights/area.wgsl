// Points on what is flat.
//
// [1] Heitz 2019, "A Low-Distortion Map Between Triangle and Square"
import package::constants::{NEAR2, NONE};
import package::lights::light::{Light, LightSample};
import package::minMax::greater;

// Uniform on a quad or, with u folded, on a triangle.
fn samplePlanar(p: vec3f, light: Light, u: vec2f) -> LightSample {
  return fromArea(p, light.position + u.x * light.edge1 + u.y * light.edge2, light.normal, light.size);
}

// [1]
fn squareToTriangle(u: vec2f) -> vec2f {
  return select(vec2f(0.5 * u.x, u.y - 0.5 * u.x), vec2f(u.x - 0.5 * u.y, 0.5 * u.y), u.x > u.y);
}

// Turns a uniform density on an area into one per solid angle, seen from p. n is the emitting side.
fn fromArea(p: vec3f, q: vec3f, n: vec3f, area: f32) -> LightSample {
  let toLight = q - p;
  let d2 = dot(toLight, toLight);
  let d = sqrt(greater(d2, NEAR2));
  let wi = toLight / d;
  let cosLight = -dot(wi, n);
  if (cosLight <= 0.0 || d2 <= NEAR2) { return LightSample(wi, d, vec3f(0.0), 0.0, NONE, 0.0); }
  let solidAngle = area * cosLight / d2;
  return LightSample(wi, d, vec3f(solidAngle), 1.0 / solidAngle, NONE, 0.0);
}
