// Parallelograms.
import package::ray::Ray;
import package::shapes::plane::{planeIntersect, planeIntersectX, planeIntersectY, planeIntersectZ};

// Parallelograms that share an edge decide each for itself on which side of it a ray passes, so each reaches a little
// beyond its edge, or a ray could slip through between them: by the rounding of t·d, which is RIM·t, here, and by that of
// the coordinates in its size (see rims.ts).
//
// Rounding of o + t·d as a share of t: 1/d and the four operations each lose half a ULP, 2⁻²⁴, or a little more.
const RIM = 0x1p-21;

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
