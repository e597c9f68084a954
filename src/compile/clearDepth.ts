import type { Vec3 } from "../scene/schema";
import type { Shape } from "./primitives";
import { reachAlong } from "./reach";
import { add, dot, scale, subtract } from "./vec3";

/** A view: the ray through image plane coordinates (x, y) in [-1, 1] runs along forward + x·right + y·up, forward unit. */
export type View = { readonly origin: Vec3; readonly forward: Vec3; readonly right: Vec3; readonly up: Vec3 };

// A little less than what is clear, for f32 may round up.
const MARGIN = 1 - 2 ** -10;

/** A distance along `forward` in front of which a view has no surface; 0 if one may be at the camera. */
export function clearDepth(shapes: readonly Shape[], view: View): number {
  const backward = scale(view.forward, -1);
  let depth = Number.POSITIVE_INFINITY;
  for (const shape of shapes) {
    depth = Math.min(
      depth,
      shape.kind === "plane" ? depthOfPlane(shape, view) : -reachAlong(shape, backward, view.origin),
    );
  }
  return Number.isFinite(depth) ? Math.max(depth, 0) * MARGIN : 0;
}

function depthOfPlane(plane: Shape & { kind: "plane" }, { origin, forward, right, up }: View): number {
  // Along the ray through (x, y) the plane lies at depth height / slope, and the slope is linear in x and y: the nearest
  // point in view is in a corner of the image.
  const height = dot(subtract(plane.point, origin), plane.normal);
  const slopes = [-1, 1].flatMap((x) =>
    [-1, 1].map((y) => dot(add(forward, add(scale(right, x), scale(up, y))), plane.normal)),
  );
  const inverseDepth = Math.max(...slopes.map((slope) => slope / height));
  if (height === 0) return 0;
  return inverseDepth > 0 ? 1 / inverseDepth : Number.POSITIVE_INFINITY;
}
