import type { Vec3 } from "../scene/schema";

/** The corners of the box between two opposite ones. */
export function cornersBetween(lower: Vec3, upper: Vec3): Vec3[] {
  const bounds = [lower, upper];
  return bounds.flatMap(([x]) => bounds.flatMap(([, y]) => bounds.map(([, , z]): Vec3 => [x, y, z])));
}
