// Points on spheres.
//
// [1] Shirley, Wang, Zimmerman 1996, "Monte Carlo Techniques for Direct Lighting Calculations", TOG 15(1)
// [2] Pharr, Jakob, Humphreys 2023, "Physically Based Rendering", 4th ed., section 6.2.4
import package::basis::{frameAround, toWorld};
import package::constants::{NEAR2, NONE, TWO_PI};
import package::directions::{circle, uniformSphere};
import package::lights::area::fromArea;
import package::lights::light::LightSample;
import package::minMax::{greater, lesser};

// Uniform in the cone that the sphere fills. [2]
// Cones are measured by sin², and 1 − cos by sin²/(1 + cos), so that a tiny cone keeps its digits.
fn sampleSphere(p: vec3f, center: vec3f, radius: f32, u: vec2f) -> LightSample {
  let toCenter = center - p;
  let d2 = dot(toCenter, toCenter);
  let sin2Max = radius * radius / greater(d2, NEAR2);
  if (sin2Max >= 1.0) { return LightSample(vec3f(0.0, 0.0, 1.0), 0.0, vec3f(0.0), 0.0, NONE, 0.0); }
  let oneMinusCos = u.x * coneOneMinusCos(sin2Max);
  let cosTheta = 1.0 - oneMinusCos;
  let sin2 = oneMinusCos * (1.0 + cosTheta);
  let d = sqrt(d2);
  let wi = normalize(toWorld(frameAround(toCenter / d), vec3f(sqrt(sin2) * circle(u.y), cosTheta)));
  let distance = d * (cosTheta - sqrt(greater(sin2Max - sin2, 0.0)));
  let solidAngle = TWO_PI * coneOneMinusCos(sin2Max);
  return LightSample(wi, distance, vec3f(solidAngle), 1.0 / solidAngle, NONE, 0.0);
}

fn coneOneMinusCos(sin2Max: f32) -> f32 {
  return sin2Max / (1.0 + sqrt(1.0 - sin2Max));
}

// Density of sampleSphere towards any point of the sphere that p sees.
fn sphereLightPdf(p: vec3f, center: vec3f, radius: f32) -> f32 {
  let toCenter = center - p;
  let sin2Max = radius * radius / greater(dot(toCenter, toCenter), NEAR2);
  return select(0.0, 1.0 / (TWO_PI * coneOneMinusCos(lesser(sin2Max, 1.0))), sin2Max < 1.0);
}

// The baseline's choice: uniform on the whole surface, half of which p cannot see. [1]
fn sampleSphereSurface(p: vec3f, center: vec3f, radius: f32, u: vec2f) -> LightSample {
  let n = uniformSphere(u);
  return fromArea(p, center + radius * n, n, 2.0 * TWO_PI * radius * radius);
}
