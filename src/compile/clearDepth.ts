import type { Ball } from "../lights/light";
import { add, cross, dot, length, scale, subtract } from "../math/vec3";
import type { Flat } from "../shapes/shape";
import { hullOf, kindOf, reachAlong, type Shape } from "../shapes/shapes";
import { isInView } from "./emitterWindow";
import { edgeRays, type Frustum, spreadOf } from "./frustum";

// A little less than what is clear, for f32 may round up.
const MARGIN = 1 - 2 ** -10;

/** A distance along `forward` in front of which a view has no surface; 0 if one may be at the camera. */
export function clearDepth(shapes: readonly Shape[], view: Frustum): number {
  const backward = scale(view.forward, -1);
  let depth = Number.POSITIVE_INFINITY;
  for (const shape of shapes) {
    const nearest = -reachAlong(shape, backward, view.origin);
    if (nearest >= depth) continue;
    const hull = hullOf(shape);
    if (hull === undefined) {
      depth = Math.min(depth, depthOfPlane(kindOf(shape).plane(shape)!, view));
      continue;
    }
    const least = "ball" in hull ? Math.max(nearest, ballDepth(hull.ball, view)) : nearest;
    // Whether a shape is in view takes longer to find out than whether it matters.
    if (least < depth && isInView(hull, view)) depth = least;
  }
  return Number.isFinite(depth) ? Math.max(depth, 0) * MARGIN : 0;
}

function depthOfPlane(plane: Flat, view: Frustum): number {
  // A ray meets the plane at depth height / slope. Where all start on one side, none meets it before those at the edges do.
  const rays = edgeRays(view).map(({ from, along }) => {
    return { height: dot(subtract(plane.point, from), plane.normal), slope: dot(along, plane.normal) };
  });
  const heights = rays.map(({ height }) => height);
  if (Math.min(...heights) <= 0 && Math.max(...heights) >= 0) return 0;
  const inverseDepth = Math.max(...rays.map(({ height, slope }) => slope / height));
  return inverseDepth > 0 ? 1 / inverseDepth : Number.POSITIVE_INFINITY;
}

/**
 * No ray of a view meets a ball at less depth. Of a planet whose horizon is far away the nearest point is not in view: what
 * comes nearest to its centre decides.
 */
function ballDepth({ center, radius }: Ball, view: Frustum): number {
  const { at, slope } = spreadOf(view);
  const toCenter = subtract(center, view.origin);
  if (slope === 0) {
    const passes = Math.max(length(cross(toCenter, view.forward)) - at, 0);
    if (passes >= radius) return Number.POSITIVE_INFINITY;
    return dot(toCenter, view.forward) - Math.sqrt((radius - passes) * (radius + passes));
  }
  // All rays are in a cone, whose tip may lie behind the camera.
  const behind = at / slope;
  const fromTip = add(toCenter, scale(view.forward, behind));
  const distance = length(fromTip);
  if (distance <= radius) return 0;
  const toCorner = Math.atan(slope);
  const angle = Math.max(Math.atan2(length(cross(fromTip, view.forward)), dot(fromTip, view.forward)) - toCorner, 0);
  const passes = distance * Math.sin(angle);
  if (passes >= radius) return Number.POSITIVE_INFINITY;
  const way = distance * Math.cos(angle) - Math.sqrt((radius - passes) * (radius + passes));
  return way * Math.cos(toCorner) - behind;
}
