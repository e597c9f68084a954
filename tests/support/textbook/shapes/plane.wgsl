// The textbook's planes.
import package::ray::Ray;

fn planeIntersect(ray: Ray, point: vec3f, normal: vec3f) -> f32 {
  return dot(normal, point - ray.o) / dot(normal, ray.d);
}
fn planeIntersectX(ray: Ray, x: f32) -> f32 {
  return (x - ray.o.x) * ray.inverse.x;
}
fn planeIntersectY(ray: Ray, y: f32) -> f32 {
  return (y - ray.o.y) * ray.inverse.y;
}
fn planeIntersectZ(ray: Ray, z: f32) -> f32 {
  return (z - ray.o.z) * ray.inverse.z;
}
