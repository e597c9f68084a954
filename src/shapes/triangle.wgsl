// Triangles, watertight.
//
// [1] Woop, Benthin, Wald 2013, "Watertight Ray/Triangle Intersection", JCGT 2(1)
import package::ray::Ray;

// The ray's own part of the triangle test: axes permuted so that z is its largest component, then sheared so that the
// ray runs along +z. Shared by all triangles, so that two of them see a common edge alike.
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
