import type { Vec3 } from "../scene/schema";

/** dot(p − from, direction), without a vector in between. */
export function along(p: Vec3, direction: Vec3, from: Vec3): number {
  return (p[0] - from[0]) * direction[0] + (p[1] - from[1]) * direction[1] + (p[2] - from[2]) * direction[2];
}
