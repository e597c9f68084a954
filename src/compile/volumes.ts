// Where solids that absorb light may hold the camera, or each other: the shader looks for what a path is in only then.

import { absorbs, isVolume } from "../lobes/absorption";
import type { Vec3 } from "../scene/schema";
import { kindOf, type Shape } from "../shapes/shapes";
import type { Primitive } from "./primitives";

// More solids than these are taken to meet: looking at all pairs of them would take too long.
const MOST_COMPARED = 64;

const DIRECTIONS: readonly Vec3[] = [
  [1, 0, 0],
  [-1, 0, 0],
  [0, 1, 0],
  [0, -1, 0],
  [0, 0, 1],
  [0, 0, -1],
];
const ORIGIN: Vec3 = [0, 0, 0];

/**
 * Whether rays that start within `reach` of a point may do so in a solid that absorbs: whether the box around one holds the point.
 *
 * @param point - relative to the compiled scene's origin.
 */
export function mayBeIn(primitives: readonly Primitive[], point: Vec3, reach: number): boolean {
  return primitives.some(
    ({ shape, material }) =>
      material !== "black" &&
      absorbs(material) &&
      DIRECTIONS.every((direction) => reachOf(shape, direction, point) >= -reach),
  );
}

/** Whether two solids may touch, or one hold the other, while some absorb. */
export function mayMeet(primitives: readonly Primitive[]): boolean {
  const solids = primitives.filter(({ material }) => material !== "black" && isVolume(material));
  if (!solids.some(({ material }) => material !== "black" && absorbs(material))) return false;
  if (solids.length > MOST_COMPARED) return true;
  return solids.some(({ shape }, i) => solids.slice(i + 1).some((other) => boxesMeet(shape, other.shape)));
}

function boxesMeet(a: Shape, b: Shape): boolean {
  return DIRECTIONS.every((direction) => {
    const [x, y, z] = direction;
    return reachOf(a, direction, ORIGIN) >= -reachOf(b, [-x, -y, -z], ORIGIN);
  });
}

function reachOf(shape: Shape, direction: Vec3, from: Vec3): number {
  return kindOf(shape).reachAlong(shape, direction, from);
}
