// Ray–sphere intersection that stays accurate for spheres that are far away, huge, or left at a grazing angle.
//
// [1] Haines, Günther, Akenine-Möller 2019, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems ch. 7
import package::constants::INSIDE;
import package::ray::Ray;

// Distance to the nearest intersection in front of the origin, <= 0 for a miss.
// A ray that starts on the sphere's inner side has f·f = r² by definition, which leaves only the far root.
fn sphereIntersect(ray: Ray, center: vec3f, radius: f32, id: u32) -> f32 {
  let f = ray.o - center;
  let b = -dot(f, ray.d);
  let chord = f + b * ray.d;
  let discriminant = radius * radius - dot(chord, chord); // [1] eq. 5: no cancellation for distant spheres
  let c = select(dot(f, f) - radius * radius, 0.0, ray.source == (id | INSIDE));
  let root = sqrt(max(discriminant, 0.0));
  let q = b + select(-root, root, b >= 0.0); // [1] eq. 10: both terms have the same sign
  let t = c / select(q, 1.0, q == 0.0);
  let near = min(t, q);
  let far = max(t, q);
  return select(-1.0, select(far, near, near > 0.0), discriminant >= 0.0);
}
