import type { Bvh } from "./bvh";

type Triple = readonly [number, number, number] | Float32Array | Float64Array;

/** A ray in doubles. The direction needs no unit length, but some length; distances `t` are in units of it. */
export type Ray = {
  readonly origin: Triple;
  readonly direction: Triple;
};

/**
 * Where a ray meets one primitive.
 *
 * @returns the least `t` at which it does so within the range; `Infinity` if it does not.
 */
export type Intersect = (primitive: number, tMin: number, tMax: number) => number;

export type Hit = { readonly primitive: number; readonly t: number };

// The exit of a slab may be rounded down: two operations, each by half an ulp, on either side. [Ize 2013, "Robust BVH Ray
// Traversal", JCGT 2(2), section 3]
const EXIT_PADDING = 1 + 2 * 3 * 2 ** -53;

/**
 * The closest hit within [tMin, tMax]; of several as close, any.
 *
 * @param tMin - 0.
 * @param tMax - Infinity.
 */
export function closestHit(
  bvh: Bvh,
  ray: Ray,
  intersect: Intersect,
  tMin = 0,
  tMax = Number.POSITIVE_INFINITY,
): Hit | undefined {
  let hit: Hit | undefined;
  traverse(bvh, ray, tMin, tMax, (primitive, farthest) => {
    const t = intersect(primitive, tMin, farthest);
    if (!(t >= tMin && t <= farthest) || t === Number.POSITIVE_INFINITY) return farthest;
    if (hit === undefined || t < hit.t) hit = { primitive, t };
    return t;
  });
  return hit;
}

/** Whether anything lies within [tMin, tMax]. */
export function anyHit(bvh: Bvh, ray: Ray, intersect: Intersect, tMin = 0, tMax = Number.POSITIVE_INFINITY): boolean {
  let isHit = false;
  traverse(bvh, ray, tMin, tMax, (primitive, farthest) => {
    const t = intersect(primitive, tMin, farthest);
    if (!(t >= tMin && t <= farthest) || t === Number.POSITIVE_INFINITY) return farthest;
    isHit = true;
    return STOP;
  });
  return isHit;
}

// As the farthest t of interest: no box is met any more.
const STOP = Number.NEGATIVE_INFINITY;

/**
 * Shows every primitive whose leaf's box the ray meets within [tMin, tMax], the nearer of two boxes first.
 *
 * @param visit - returns the new tMax.
 */
function traverse(
  { bounds, links, axes, counts, order, depth }: Bvh,
  ray: Ray,
  tMin: number,
  tMax: number,
  visit: (primitive: number, tMax: number) => number,
): void {
  const meets = createSlabTest(bounds, ray, tMin);
  const stack = new Uint32Array(depth + 1);
  let waiting = 0;
  let node = 0;
  for (;;) {
    if (meets(node, tMax)) {
      const axis = axes[node]!;
      if (axis < 3) {
        const isForwards = ray.direction[axis]! >= 0;
        stack[waiting++] = isForwards ? links[node]! : node + 1;
        node = isForwards ? node + 1 : links[node]!;
        continue;
      }
      const end = links[node]! + counts[node]!;
      for (let slot = links[node]!; slot < end && tMax > STOP; slot++) tMax = visit(order[slot]!, tMax);
    }
    if (waiting === 0 || tMax === STOP) return;
    node = stack[--waiting]!;
  }
}

/**
 * Whether a ray meets a node's box within [tMin, tMax].
 *
 * A zero component of the direction divides to ±∞, and to NaN where the origin lies on a slab's plane. Comparisons are written
 * so that NaN changes nothing: such a ray runs within that slab.
 */
function createSlabTest(bounds: Float32Array, { origin, direction }: Ray, tMin: number) {
  const inverse = [1 / direction[0]!, 1 / direction[1]!, 1 / direction[2]!] as const;
  return (node: number, tMax: number): boolean => {
    let near = tMin;
    let far = tMax;
    for (let axis = 0; axis < 3; axis++) {
      const low = (bounds[6 * node + axis]! - origin[axis]!) * inverse[axis]!;
      const high = (bounds[6 * node + 3 + axis]! - origin[axis]!) * inverse[axis]!;
      const isForwards = inverse[axis]! >= 0;
      const entry = isForwards ? low : high;
      const exit = (isForwards ? high : low) * EXIT_PADDING;
      if (entry > near) near = entry;
      if (exit < far) far = exit;
    }
    return near <= far && near < Number.POSITIVE_INFINITY;
  };
}
