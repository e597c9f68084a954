import { cross, length, scale } from "../math/vec3";
import type { Vec3 } from "../scene/schema";

/** Vectors d1, d2 in the plane of the edges with d·(half edge) = 1 for their own and 0 for the other. */
export function halfEdgeDuals(edge1: Vec3, edge2: Vec3, normal: Vec3): [Vec3, Vec3] {
  const area = length(cross(edge1, edge2));
  return [scale(cross(edge2, normal), 2 / area), scale(cross(normal, edge1), 2 / area)];
}
