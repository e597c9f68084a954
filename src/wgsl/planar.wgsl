// Planes, parallelograms and triangles.
import package::ray::Ray;

// Parallelograms that share an edge decide each for itself on which side of it a ray passes, so each reaches a little
// beyond its edge, or a ray could slip through between them: by the rounding of t·d, which is RIM·t, here, and by that of
// the coordinates in its size (see compile/rims.ts).
//
// Rounding of o + t·d as a share of t: 1/d and the four operations each lose half a ULP, 2⁻²⁴, or a little more.
const RIM = 0x1p-21;

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

// Parallelogram by its centre, its normal (any length) and the vectors dual to its half edges: inside is |u|, |v| <= 1.
// `reach` is the length of the longer dual.
fn quadIntersect(ray: Ray, center: vec3f, normal: vec3f, dual1: vec3f, dual2: vec3f, reach: f32) -> f32 {
  let t = planeIntersect(ray, center, normal);
  let q = ray.o + t * ray.d - center;
  let most = 1.0 + RIM * reach * abs(t);
  return select(-1.0, t, (abs(dot(q, dual1)) <= most) & (abs(dot(q, dual2)) <= most));
}

// Rectangles perpendicular to an axis, by centre and half size.
fn quadIntersectX(ray: Ray, center: vec3f, halfSize: vec3f) -> f32 {
  let t = planeIntersectX(ray, center.x);
  let q = abs(ray.o.yz + t * ray.d.yz - center.yz);
  return select(-1.0, t, all(q - halfSize.yz <= vec2f(RIM * abs(t))));
}
fn quadIntersectY(ray: Ray, center: vec3f, halfSize: vec3f) -> f32 {
  let t = planeIntersectY(ray, center.y);
  let q = abs(ray.o.xz + t * ray.d.xz - center.xz);
  return select(-1.0, t, all(q - halfSize.xz <= vec2f(RIM * abs(t))));
}
fn quadIntersectZ(ray: Ray, center: vec3f, halfSize: vec3f) -> f32 {
  let t = planeIntersectZ(ray, center.z);
  let q = abs(ray.o.xy + t * ray.d.xy - center.xy);
  return select(-1.0, t, all(q - halfSize.xy <= vec2f(RIM * abs(t))));
}

// The ray's own part of the triangle test: axes permuted so that z is its largest component, then sheared so that the
// ray runs along +z. Shared by all triangles, so that two of them see a common edge alike.
//
// [1] Woop, Benthin, Wald 2013, "Watertight Ray/Triangle Intersection", JCGT 2(1)
struct Shear {
  o: vec3f,
  // Index of the permutation: 0 takes (y, z, x), 1 (z, x, y), 2 (x, y, z).
  axis: u32,
  s: vec3f,
}

fn permute(v: vec3f, axis: u32) -> vec3f {
  return select(select(v, v.zxy, axis == 1u), v.yzx, axis == 0u);
}

fn shearOf(ray: Ray) -> Shear {
  let size = abs(ray.d);
  let axis = select(select(2u, 1u, size.y > size.z), 0u, (size.x > size.y) & (size.x > size.z));
  let d = permute(ray.d, axis);
  return Shear(ray.o, axis, vec3f(d.x / d.z, d.y / d.z, 1.0 / d.z));
}

// [1] appendix A, without backface culling; -1 for a miss or a triangle without area.
// The vertices come in an order that all triangles agree on, so that two of them evaluate a common edge by the same
// operations on the same numbers, in the same order: whatever a compiler fuses, they see the ray on the same side of it.
fn triangleIntersect(shear: Shear, v0: vec3f, v1: vec3f, v2: vec3f) -> f32 {
  let a = permute(v0 - shear.o, shear.axis);
  let b = permute(v1 - shear.o, shear.axis);
  let c = permute(v2 - shear.o, shear.axis);
  let pa = a.xy - shear.s.xy * a.z;
  let pb = b.xy - shear.s.xy * b.z;
  let pc = c.xy - shear.s.xy * c.z;
  let u = pb.x * pc.y - pb.y * pc.x;
  let v = pa.x * pc.y - pa.y * pc.x; // of the opposite sign
  let w = pa.x * pb.y - pa.y * pb.x;
  let determinant = u - v + w;
  let inside = (((u >= 0.0) & (v <= 0.0) & (w >= 0.0)) | ((u <= 0.0) & (v >= 0.0) & (w <= 0.0))) & (determinant != 0.0);
  let t = (u * a.z - v * b.z + w * c.z) * shear.s.z / select(1.0, determinant, determinant != 0.0);
  return select(-1.0, t, inside);
}
