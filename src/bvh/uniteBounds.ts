import type { Bvh } from "./bvh";

/**
 * Writes the exact bounds of a tree's nodes, from the leaves up: children come after their parents.
 *
 * @param primitiveBounds - as `buildBvh` takes them.
 */
export function uniteBounds({ bounds, links, axes, counts, order }: Omit<Bvh, "depth">, primitiveBounds: Float32Array) {
  for (let node = axes.length - 1; node >= 0; node--) {
    let minX = Number.POSITIVE_INFINITY;
    let minY = Number.POSITIVE_INFINITY;
    let minZ = Number.POSITIVE_INFINITY;
    let maxX = Number.NEGATIVE_INFINITY;
    let maxY = Number.NEGATIVE_INFINITY;
    let maxZ = Number.NEGATIVE_INFINITY;
    if (axes[node] === 3) {
      const end = links[node]! + counts[node]!;
      for (let slot = links[node]!; slot < end; slot++) {
        const at = 6 * order[slot]!;
        minX = Math.min(minX, primitiveBounds[at]!);
        minY = Math.min(minY, primitiveBounds[at + 1]!);
        minZ = Math.min(minZ, primitiveBounds[at + 2]!);
        maxX = Math.max(maxX, primitiveBounds[at + 3]!);
        maxY = Math.max(maxY, primitiveBounds[at + 4]!);
        maxZ = Math.max(maxZ, primitiveBounds[at + 5]!);
      }
    } else {
      const first = 6 * (node + 1);
      const second = 6 * links[node]!;
      minX = Math.min(bounds[first]!, bounds[second]!);
      minY = Math.min(bounds[first + 1]!, bounds[second + 1]!);
      minZ = Math.min(bounds[first + 2]!, bounds[second + 2]!);
      maxX = Math.max(bounds[first + 3]!, bounds[second + 3]!);
      maxY = Math.max(bounds[first + 4]!, bounds[second + 4]!);
      maxZ = Math.max(bounds[first + 5]!, bounds[second + 5]!);
    }
    const to = 6 * node;
    bounds[to] = minX;
    bounds[to + 1] = minY;
    bounds[to + 2] = minZ;
    bounds[to + 3] = maxX;
    bounds[to + 4] = maxY;
    bounds[to + 5] = maxZ;
  }
}
