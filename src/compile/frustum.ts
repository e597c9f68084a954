import { add, length, scale } from "../math/vec3";
import type { Vec3 } from "../scene/schema";

/** A thin lens. Rays through one point of the picture meet at depth `focus`, wherever on the disk around their origin they start. */
export type Lens = { readonly radius: number; readonly focus: number };

/** What a camera sees, by image plane coordinates (x, y) in [-1, 1]. */
export type Frustum = {
  readonly origin: Vec3;
  /** Unit. */
  readonly forward: Vec3;
  /** The ray through (x, y) runs from the origin along forward + x·right + y·up. */
  readonly right: Vec3;
  readonly up: Vec3;
  /** The ray through (x, y) runs along forward instead, from origin + x·right + y·up. */
  readonly isOrthographic?: boolean;
  /** Without one, these are all rays. */
  readonly lens?: Lens;
};

/** A ray that gets to depth z, along the view's `forward`, at from + z·along. */
export type EdgeRay = { readonly from: Vec3; readonly along: Vec3 };

/** Four rays between which all of a view are, at every depth. */
export function edgeRays({ origin, forward, right, up, isOrthographic = false, lens }: Frustum): EdgeRay[] {
  return [-1, 1].flatMap((x) =>
    [-1, 1].map((y) => {
      const offset = add(scale(right, x), scale(up, y));
      const start = isOrthographic ? add(origin, offset) : origin;
      const way = isOrthographic ? forward : add(forward, offset);
      if (!lens) return { from: start, along: way };
      // Through a point of the lens, to one of the plane of focus, and farther to the side: as if both were moved outwards.
      const edge = add(scale(right, (x * lens.radius) / length(right)), scale(up, (y * lens.radius) / length(up)));
      return { from: add(start, edge), along: add(way, scale(edge, 1 / lens.focus)) };
    }),
  );
}

/** All rays of a view are, at depth z, within this distance of its axis: at + z·slope. */
export function spreadOf({ right, up, isOrthographic = false, lens }: Frustum): { at: number; slope: number } {
  const corner = Math.hypot(length(right), length(up));
  const { radius, focus } = lens ?? { radius: 0, focus: 1 };
  const [at, slope] = isOrthographic ? [corner, 0] : [0, corner];
  return { at: at + radius, slope: slope + radius / focus };
}

/**
 * How far from its place in a picture without a lens something may be seen, in lengths of the image plane: at distance 1 or, of an
 * orthographic view, anywhere.
 *
 * @param nearest - its least depth.
 * @param farthest - its greatest depth, not less than 0.
 */
export function blurOf({ isOrthographic, lens }: Frustum, nearest: number, farthest: number): number {
  if (!lens) return 0;
  const depths = [Math.max(nearest, 0), farthest];
  // Largest at one of the ends: it grows with the distance from the plane of focus.
  const shares = depths.map((z) => Math.abs(isOrthographic ? 1 - z / lens.focus : 1 / z - 1 / lens.focus));
  return BEYOND_ROUNDING * lens.radius * Math.max(...shares);
}

// The shader's points of the lens may lie a few ULP outside of it.
const BEYOND_ROUNDING = 1 + 2 ** -18;
