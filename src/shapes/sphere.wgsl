// Ray–sphere intersection that stays accurate for spheres that are far away, huge, or left at a grazing angle.
//
// [1] Haines, Günther, Akenine-Möller 2019, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems ch. 7
import package::constants::{INSIDE, NEAR};
import package::minMax::{greater, lesser};
import package::ray::Ray;

// Distance to the nearest intersection in front of the origin, <= 0 for a miss.
// A ray that starts on the sphere's inner side always hits it: rounding must not let one slip out along the surface.
fn sphereIntersect(ray: Ray, center: vec3f, radius: f32, id: u32) -> f32 {
  let f = ray.o - center;
  let b = -dot(f, ray.d);
  let chord = f + b * ray.d;
  let discriminant = radius * radius - dot(chord, chord); // [1] eq. 5: no cancellation for distant spheres
  let c = dot(f, f) - radius * radius;
  return nearestRoot(b, c, discriminant, ray.source == (id | INSIDE));
}

// The same for a sphere that is huge against what is around it, a planet as a floor, by its point `foot` nearest to the
// scene's origin and the vector `spoke` from its centre to there. Measured from the centre, the origin of a ray would be
// as coarse as the radius: with g = o − foot, |f|² − r² is |g|² + 2·g·spoke, without cancellation.
fn hugeSphereIntersect(ray: Ray, foot: vec3f, spoke: vec3f, id: u32) -> f32 {
  let g = ray.o - foot;
  let b = -dot(g + spoke, ray.d);
  let c = dot(g, g + 2.0 * spoke);
  return nearestRoot(b, c, b * b - c, ray.source == (id | INSIDE));
}

// The least positive t with t² − 2·b·t + c = 0, <= 0 if there is none.
fn nearestRoot(b: f32, c: f32, discriminant: f32, fromInside: bool) -> f32 {
  let root = sqrt(greater(discriminant, 0.0));
  let q = b + select(-root, root, b >= 0.0); // [1] eq. 10: both terms have the same sign
  let other = c / select(q, 1.0, q == 0.0);
  let near = lesser(other, q);
  let far = greater(other, q);
  let t = select(-1.0, select(far, near, near > 0.0), discriminant >= 0.0);
  return select(t, greater(b + root, NEAR), fromInside);
}
