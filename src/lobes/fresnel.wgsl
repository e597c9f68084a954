// Schlick's approximation.
//
// [1] Schlick 1994, "An Inexpensive BRDF Model for Physically-based Rendering", eq. 15
import package::minMax::greater;

// (1 − cos)⁵
fn schlickWeight(cosTheta: f32) -> f32 {
  let m = greater(1.0 - cosTheta, 0.0);
  let m2 = m * m;
  return m2 * m2 * m;
}
