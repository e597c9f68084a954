// Shapes other than meshes as the tree has them.

import { add, length, scale } from "../math/vec3";
import type { Vec3 } from "../scene/schema";
import type { BoundedShape } from "./boundedShapes";
import { halfEdgeDuals } from "./duals";
import { reachAlong } from "./reach";
import { dualWithRim, inCommonOrder } from "./rims";

/** What the shader's tree can hold, by its number in `wgsl/tree.wgsl`. A triangle of a mesh may be turned round. */
export const ITEM_KINDS = { meshTriangle: 0, turnedTriangle: 1, triangle: 2, sphere: 3, quad: 4, box: 5 } as const;

// What rounding may add to a shape's coordinates and to its rim, in proportion to them.
const WIDENING = 2 ** -19;

/** `[minX, minY, minZ, maxX, maxY, maxZ]` around a shape and its rim. */
export function boundsOfShape(shape: BoundedShape): number[] {
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

/** A shape as an item of the tree: its kind, three vectors and a number. */
export function itemOf(shape: BoundedShape): { kind: number; vectors: readonly [Vec3, Vec3, Vec3]; w: number } {
  const kind = ITEM_KINDS[shape.kind];
  switch (shape.kind) {
    case "sphere":
      return { kind, vectors: [shape.center, [0, 0, 0], [0, 0, 0]], w: shape.radius };
    case "quad": {
      const { corner, edge1, edge2, normal } = shape;
      const middle = add(corner, scale(add(edge1, edge2), 0.5));
      const [dual1, dual2] = halfEdgeDuals(edge1, edge2, normal).map((dual) => dualWithRim(dual, middle)) as [
        Vec3,
        Vec3,
      ];
      return { kind, vectors: [middle, dual1, dual2], w: Math.max(length(dual1), length(dual2)) };
    }
    case "triangle":
      return { kind, vectors: inCommonOrder(shape.vertices) as [Vec3, Vec3, Vec3], w: 0 };
    case "box": {
      const { center, halfSize, turn = 0 } = shape;
      return { kind, vectors: [center, halfSize, [Math.cos(turn), Math.sin(turn), 0]], w: 0 };
    }
  }
}
