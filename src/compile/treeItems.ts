// Shapes other than meshes as the tree has them.

import type { Vec3 } from "../scene/schema";
import { extent } from "./blockers";
import type { BoundedShape } from "./boundedShapes";
import { halfEdgeDuals } from "./duals";
import { dualWithRim, inCommonOrder } from "./rims";
import { add, length, scale } from "./vec3";

/** What the shader's tree can hold, by its number in `wgsl/tree.wgsl`. A triangle of a mesh may be turned round. */
export const ITEM_KINDS = { meshTriangle: 0, turnedTriangle: 1, triangle: 2, sphere: 3, quad: 4, box: 5 } as const;

// What rounding may add to a shape's coordinates and to its rim, in proportion to them.
const WIDENING = 2 ** -19;

/** `[minX, minY, minZ, maxX, maxY, maxZ]` around a shape and its rim. */
export function boundsOfShape(shape: BoundedShape): number[] {
  const axes: Vec3[] = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  const ranges = axes.map((axis, i) => {
    const coordinates = extent(shape, axis).map((point) => point[i]!);
    return [Math.min(...coordinates), Math.max(...coordinates)] as const;
  });
  const size = Math.max(...ranges.flat().map(Math.abs), ...ranges.map(([least, most]) => most - least));
  return [...ranges.map(([least]) => least - WIDENING * size), ...ranges.map(([, most]) => most + WIDENING * size)];
}

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
