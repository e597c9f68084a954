// Shapes other than meshes as the tree has them.

import { scale } from "../math/vec3";
import type { Vec3 } from "../scene/schema";
import { reachAlong, type Shape } from "../shapes/shapes";

// What rounding may add to a shape's coordinates and to its rim, in proportion to them.
const WIDENING = 2 ** -19;

/** `[minX, minY, minZ, maxX, maxY, maxZ]` around a shape and its rim. */
export function boundsOfShape(shape: Shape): number[] {
  const box: number[] = [];
  for (const axis of AXES) box.push(-reachAlong(shape, scale(axis, -1), ORIGIN));
  for (const axis of AXES) box.push(reachAlong(shape, axis, ORIGIN));
  let size = 0;
  for (let axis = 0; axis < 3; axis++) {
    const [least, most] = [box[axis]!, box[3 + axis]!];
    size = Math.max(size, Math.abs(least), Math.abs(most), most - least);
  }
  for (let axis = 0; axis < 3; axis++) {
    box[axis]! -= WIDENING * size;
    box[3 + axis]! += WIDENING * size;
  }
  return box;
}

const ORIGIN: Vec3 = [0, 0, 0];
const AXES: readonly Vec3[] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];
