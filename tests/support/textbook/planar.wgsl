// The textbook's planes, parallelograms without rims, and Möller–Trumbore triangles.
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

struct Shear {
  o: vec3f,
  d: vec3f,
}

fn shearOf(ray: Ray) -> Shear {
  return Shear(ray.o, ray.d);
}

fn triangleIntersect(shear: Shear, v0: vec3f, v1: vec3f, v2: vec3f) -> f32 {
  let edge1 = v1 - v0;
  let edge2 = v2 - v0;
  let h = cross(shear.d, edge2);
  let determinant = dot(edge1, h);
  if (abs(determinant) < 1e-8) { return -1.0; }
  let s = shear.o - v0;
  let u = dot(s, h) / determinant;
  let q = cross(s, edge1);
  let v = dot(shear.d, q) / determinant;
  if (u < 0.0 || v < 0.0 || u + v > 1.0) { return -1.0; }
  return dot(edge2, q) / determinant;
}
