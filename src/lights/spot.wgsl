// Lamps that shine into a cone.
//
// [1] Khronos, KHR_lights_punctual, "Inner and Outer Cone Angles"
import package::basis::frameAround;
import package::directions::circle;
import package::lights::light::{Light, LightSample};
import package::lights::point::samplePosition;

// Uniform on a disk across the axis, or its middle. Of the light, edge1 holds 1 − cos of the outer angle and one over the difference
// of the cosines of both: by 1 − cos = |d − axis|²/2 narrow cones keep their digits. [1]
fn sampleSpot(p: vec3f, light: Light, u: vec2f) -> LightSample {
  let disk = frameAround(light.normal);
  let at = light.size * sqrt(u.x) * circle(u.y);
  var sample = samplePosition(p, light.position + at.x * disk.t + at.y * disk.b);
  let away = sample.wi + light.normal;
  let falloff = clamp((light.edge1.x - 0.5 * dot(away, away)) * light.edge1.y, 0.0, 1.0);
  sample.estimate *= falloff * falloff;
  return sample;
}
