// The textbook's quadratic formula.
import package::ray::Ray;

fn sphereIntersect(ray: Ray, center: vec3f, radius: f32, id: u32) -> f32 {
  let f = ray.o - center;
  let b = dot(f, ray.d);
  let discriminant = b * b - (dot(f, f) - radius * radius);
  let root = sqrt(max(discriminant, 0.0));
  let t = select(-b + root, -b - root, -b - root > 1e-4);
  return select(-1.0, t, discriminant >= 0.0);
}

// Nothing special about huge ones.
fn hugeSphereIntersect(ray: Ray, foot: vec3f, spoke: vec3f, id: u32) -> f32 {
  return sphereIntersect(ray, foot - spoke, length(spoke), id);
}
