import type { Vec3 } from "../scene/schema";

export type Axis = "X" | "Y" | "Z";

/** The axis that a direction is parallel to, if any. */
export function axisOf(direction: Vec3): Axis | undefined {
  const [x, y, z] = direction.map((component) => component !== 0);
  if (x && !y && !z) return "X";
  if (!x && y && !z) return "Y";
  if (!x && !y && z) return "Z";
  return undefined;
}
