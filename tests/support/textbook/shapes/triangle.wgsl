// Möller–Trumbore triangles.
import package::ray::Ray;

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
