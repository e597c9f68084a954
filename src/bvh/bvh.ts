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
