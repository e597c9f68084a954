import { createPrimitives } from "./primitives";
import { createSplitter } from "./split";

/** A binary tree of axis-aligned boxes over primitives. */
export type Bvh = {
  /**
   * Per node `[minX, minY, minZ, maxX, maxY, maxZ]`; depth-first order, root at 0. An inner node's first child is the next
   * node. The one leaf of an empty tree has an inverted box, `[∞, ∞, ∞, −∞, −∞, −∞]`.
   */
  readonly bounds: Float32Array;
  /** Per node: of an inner node the index of its second child; of a leaf its first slot in `order`. */
  readonly links: Uint32Array;
  /** Per node: the axis of an inner node's split, 0 to 2, the first child on its lower side; 3 for a leaf. */
  readonly axes: Uint8Array;
  /** Per node: primitives of a leaf, 0 for an inner node. */
  readonly counts: Uint8Array;
  /** `order[slot]`: the primitive stored at that leaf slot. */
  readonly order: Uint32Array;
  /** Edges from the root to the deepest leaf; 0 for a tree of one leaf. Never above `MAX_DEPTH`. */
  readonly depth: number;
};

export type BuildOptions = {
  /** Most primitives in a leaf, 1 to 255; 4. */
  readonly maxLeaf?: number;
  /** Told now and then which share of the primitives is placed, 0 to 1, growing; at last 1. */
  readonly onProgress?: (fraction: number) => void;
};

/** No tree is deeper, whatever the input: where the SAH would have it so, nodes are halved by count. */
export const MAX_DEPTH = 48;

const DEFAULT_MAX_LEAF = 4;
const LEAF_AXIS = 3;
// Progress is told when this share of the primitives has been placed since the last time.
const PROGRESS_STEP = 1 / 128;

/**
 * Builds a binary BVH with binned SAH (Wald 2007, "On fast Construction of SAH-based Bounding Volume Hierarchies").
 *
 * @param bounds - `[minX, minY, minZ, maxX, maxY, maxZ]` per primitive, world space; length `6 * count`. Not kept, not changed.
 * @throws {RangeError} if a bound is not finite or a minimum lies above its maximum, naming the primitive. An empty input
 *   gives one empty leaf.
 */
export function buildBvh(bounds: Float32Array, { maxLeaf = DEFAULT_MAX_LEAF, onProgress }: BuildOptions = {}): Bvh {
  if (!Number.isInteger(maxLeaf) || maxLeaf < 1 || maxLeaf > 255) {
    throw new RangeError(`maxLeaf: expected an integer from 1 to 255, got ${maxLeaf}`);
  }
  const primitives = createPrimitives(bounds);
  const { count } = primitives;
  const nodes = createNodes(Math.max(2 * count - 1, 1));
  const splitter = createSplitter(primitives, maxLeaf);
  const progressStep = Math.max(Math.ceil(count * PROGRESS_STEP), 1);

  // Second children wait on a stack: [first slot, end, depth, parent] each.
  const pending = new Uint32Array(4 * (MAX_DEPTH + 1));
  let waiting = 0;
  let [first, end, depth, node, deepest, told] = [0, count, 0, 0, 0, 0];
  for (;;) {
    primitives.unite(first, end, nodes.bounds, 6 * node);
    const levelsLeft = MAX_DEPTH - depth;
    const middle = splitter.split(first, end, levelsLeft);
    if (middle > first) {
      nodes.axes[node] = splitter.axis();
      depth += 1;
      pending[waiting++] = middle;
      pending[waiting++] = end;
      pending[waiting++] = depth;
      pending[waiting++] = node;
      end = middle;
    } else {
      nodes.axes[node] = LEAF_AXIS;
      nodes.counts[node] = end - first;
      nodes.links[node] = first;
      if (depth > deepest) deepest = depth;
      if (onProgress !== undefined && end - told >= progressStep && end < count) {
        onProgress(end / count);
        told = end;
      }
      if (waiting === 0) break;
      nodes.links[pending[--waiting]!] = node + 1;
      depth = pending[--waiting]!;
      end = pending[--waiting]!;
      first = pending[--waiting]!;
    }
    node += 1;
  }
  onProgress?.(1);
  return { ...trim(nodes, node + 1), order: primitives.order(), depth: deepest };
}

type Nodes = Pick<Bvh, "bounds" | "links" | "axes" | "counts">;

function createNodes(count: number): Nodes {
  return {
    bounds: new Float32Array(6 * count),
    links: new Uint32Array(count),
    axes: new Uint8Array(count),
    counts: new Uint8Array(count),
  };
}

function trim({ bounds, links, axes, counts }: Nodes, count: number): Nodes {
  return {
    bounds: bounds.slice(0, 6 * count),
    links: links.slice(0, count),
    axes: axes.slice(0, count),
    counts: counts.slice(0, count),
  };
}
