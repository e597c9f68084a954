// Planes.
import package::ray::Ray;

// Distance along the ray to the plane through `point`, -1 when parallel.
fn planeIntersect(ray: Ray, point: vec3f, normal: vec3f) -> f32 {
  let cosine = dot(normal, ray.d);
  let parallel = cosine == 0.0;
  return select(dot(normal, point - ray.o) / select(cosine, 1.0, parallel), -1.0, parallel);
}

// Planes perpendicular to an axis, by the coordinate where they cut it.
fn planeIntersectX(ray: Ray, x: f32) -> f32 {
  return (x - ray.o.x) * ray.inverse.x;
}
fn planeIntersectY(ray: Ray, y: f32) -> f32 {
  return (y - ray.o.y) * ray.inverse.y;
}
fn planeIntersectZ(ray: Ray, z: f32) -> f32 {
  return (z - ray.o.z) * ray.inverse.z;
}
