// What makes shapes that share an edge tight against each other in f32.

import { length, scale } from "../math/vec3";
import type { Vec3 } from "../scene/schema";

/**
 * How far, as a share of the coordinates there, a shape's edge may lie from where it should: centre and size are rounded
 * (half a ULP each), and so are the difference of a hit from the centre and the neighbour's plane; two ULP cover it. Twice
 * that, for a device may round either way.
 */
const RIM = 2 ** -21;

/** The half size of an axis-aligned rectangle, widened by the rounding of its coordinates. */
export function withRim(halfSize: Vec3, center: Vec3): Vec3 {
  const widened = (i: 0 | 1 | 2) => {
    const half = Math.abs(halfSize[i]);
    return half + RIM * (half + Math.abs(center[i]));
  };
  return [widened(0), widened(1), widened(2)];
}

/** The dual vector of a half edge, shortened so that its shape reaches beyond its edges by the rounding of coordinates. */
export function dualWithRim(dual: Vec3, center: Vec3): Vec3 {
  return scale(dual, 1 / (1 + RIM * (1 + length(dual) * length(center))));
}

/**
 * Factor by which points on a flat shape are drawn to its middle, so that those on its edges lie strictly within: four times
 * what the shape reaches beyond its edge here and at distances like its own size in `planar.wgsl`.
 *
 * @param toEdge - distance from the middle to the nearest edge.
 * @param toVertex - distance to the farthest vertex.
 */
export function towardsMiddle(middle: Vec3, toEdge: number, toVertex: number): number {
  const step = (8 * RIM * (toVertex + length(middle))) / toEdge;
  return 1 - Math.min(step, MAX_STEP);
}

// Of a sliver or a far shape: still no more than a 16th of a pixel where it spans 4000.
const MAX_STEP = 2 ** -16;

/**
 * Vertices in lexicographic order, as f32 keeps them. Triangles that share an edge then agree on its direction, whatever
 * their own orientation.
 */
export function inCommonOrder(vertices: readonly Vec3[]): Vec3[] {
  const rounded = ([x, y, z]: Vec3) => [Math.fround(x), Math.fround(y), Math.fround(z)] as const;
  return vertices.toSorted((first, second) => {
    const [a, b] = [rounded(first), rounded(second)];
    return a[0] - b[0] || a[1] - b[1] || a[2] - b[2];
  });
}
