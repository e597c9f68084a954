import type { Bvh } from "./bvh";

/** What one step of traversal costs: the unit of the SAH. */
export const TRAVERSAL_COST = 1;
/** What one primitive's intersection test costs, in steps of traversal: three-mesh-bvh's, so that costs compare. */
export const INTERSECTION_COST = 1.25;

/**
 * Expected cost of a ray that meets the root's box, by the surface area heuristic: the sum, over inner nodes, of
 * `TRAVERSAL_COST` and, over leaves, of `INTERSECTION_COST` per primitive, each weighed by the node's surface area over the
 * root's.
 *
 * @param bvh - any tree in this form, not only of our builder.
 * @returns 0 for an empty tree; where the root has no area, every node counts in full.
 */
export function sahCost({ bounds, counts, axes }: Pick<Bvh, "bounds" | "counts" | "axes">): number {
  const rootArea = halfArea(bounds, 0);
  let cost = 0;
  for (let node = 0; node < axes.length; node++) {
    const own = axes[node] === 3 ? INTERSECTION_COST * counts[node]! : TRAVERSAL_COST;
    if (own === 0) continue; // the empty leaf, whose box has no area
    cost += rootArea > 0 ? own * (halfArea(bounds, node) / rootArea) : own;
  }
  return cost;
}

function halfArea(bounds: Float32Array, node: number): number {
  const x = bounds[6 * node + 3]! - bounds[6 * node]!;
  const y = bounds[6 * node + 4]! - bounds[6 * node + 1]!;
  const z = bounds[6 * node + 5]! - bounds[6 * node + 2]!;
  return x * y + y * z + z * x;
}
