import type { Vec3 } from "../scene/schema";
import { extent } from "./blockers";
import type { Shape } from "./primitives";
import { add, dot, scale, subtract } from "./vec3";

/** A view: the ray through image plane coordinates (x, y) in [-1, 1] runs along forward + x·right + y·up, forward unit. */
export type View = { readonly origin: Vec3; readonly forward: Vec3; readonly right: Vec3; readonly up: Vec3 };

// A little less than what is clear, for f32 may round up.
const MARGIN = 1 - 2 ** -10;

/** A distance along `forward` in front of which a view has no surface; 0 if one may be at the camera. */
export function clearDepth(shapes: readonly Shape[], view: View): number {
  const depth = Math.min(...shapes.map((shape) => depthOf(shape, view)));
  return Number.isFinite(depth) ? Math.max(depth, 0) * MARGIN : 0;
}

function depthOf(shape: Shape, { origin, forward, right, up }: View): number {
  if (shape.kind !== "plane") {
    return Math.min(...extent(shape, forward).map((point) => dot(subtract(point, origin), forward)));
  }
  // Along the ray through (x, y) the plane lies at depth height / slope, and the slope is linear in x and y: the nearest
  // point in view is in a corner of the image.
  const height = dot(subtract(shape.point, origin), shape.normal);
  const slopes = [-1, 1].flatMap((x) =>
    [-1, 1].map((y) => dot(add(forward, add(scale(right, x), scale(up, y))), shape.normal)),
  );
  const inverseDepth = Math.max(...slopes.map((slope) => slope / height));
  if (height === 0) return 0;
  return inverseDepth > 0 ? 1 / inverseDepth : Number.POSITIVE_INFINITY;
}
