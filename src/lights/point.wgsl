// Lights without size.
import package::constants::{NEAR2, NONE};
import package::lights::light::LightSample;
import package::minMax::greater;

fn samplePosition(p: vec3f, position: vec3f) -> LightSample {
  let toLight = position - p;
  let d2 = greater(dot(toLight, toLight), NEAR2);
  let d = sqrt(d2);
  return LightSample(toLight / d, d, vec3f(1.0 / d2), 0.0, NONE, 0.0);
}
