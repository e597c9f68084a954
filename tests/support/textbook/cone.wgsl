// The textbook's uniform cone: 1 − cos of its half angle by subtraction.
import package::constants::TWO_PI;

fn coneSolidAngle(p: vec3f, center: vec3f, radius: f32) -> f32 {
  let toCenter = center - p;
  let sin2 = radius * radius / dot(toCenter, toCenter);
  return TWO_PI * (1.0 - sqrt(1.0 - sin2));
}
