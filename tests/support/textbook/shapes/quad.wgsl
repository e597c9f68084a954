// The textbook's parallelograms, without rims.
import package::ray::Ray;
import package::shapes::plane::{planeIntersect, planeIntersectX, planeIntersectY, planeIntersectZ};

fn quadIntersect(ray: Ray, center: vec3f, normal: vec3f, dual1: vec3f, dual2: vec3f, reach: f32) -> f32 {
  let t = planeIntersect(ray, center, normal);
  let q = ray.o + t * ray.d - center;
  return select(-1.0, t, max(abs(dot(q, dual1)), abs(dot(q, dual2))) <= 1.0);
}
fn quadIntersectX(ray: Ray, center: vec3f, halfSize: vec3f) -> f32 {
  let t = planeIntersectX(ray, center.x);
  return select(-1.0, t, all(abs(ray.o.yz + t * ray.d.yz - center.yz) <= halfSize.yz));
}
fn quadIntersectY(ray: Ray, center: vec3f, halfSize: vec3f) -> f32 {
  let t = planeIntersectY(ray, center.y);
  return select(-1.0, t, all(abs(ray.o.xz + t * ray.d.xz - center.xz) <= halfSize.xz));
}
fn quadIntersectZ(ray: Ray, center: vec3f, halfSize: vec3f) -> f32 {
  let t = planeIntersectZ(ray, center.z);
  return select(-1.0, t, all(abs(ray.o.xy + t * ray.d.xy - center.xy) <= halfSize.xy));
}
