/** Boxes of primitives in slots, which a build sorts in place: neighbours in the tree are neighbours in memory. */
export type Primitives = {
  readonly count: number;
  /** Per slot `[minX, minY, minZ, maxX, maxY, maxZ]`. */
  readonly boxes: Float32Array;
  /** Per slot: the primitive there. */
  readonly ids: Uint32Array;
  /** Swaps two slots. */
  swap(a: number, b: number): void;
  /** Writes the union of a range's boxes; an inverted box for none. */
  unite(first: number, end: number, target: Float32Array, offset: number): void;
  order(): Uint32Array;
};

/** @throws {RangeError} if a bound is not finite or a minimum lies above its maximum. */
export function createPrimitives(bounds: Float32Array): Primitives {
  if (bounds.length % 6 !== 0) {
    throw new RangeError(`bounds: expected 6 numbers per primitive, got ${bounds.length} numbers`);
  }
  const count = bounds.length / 6;
  const boxes = bounds.slice();
  const ids = new Uint32Array(count);
  for (let slot = 0; slot < count; slot++) {
    ids[slot] = slot;
    check(bounds, slot);
  }
  return {
    count,
    boxes,
    ids,
    swap(a, b) {
      for (let i = 0; i < 6; i++) {
        const value = boxes[6 * a + i]!;
        boxes[6 * a + i] = boxes[6 * b + i]!;
        boxes[6 * b + i] = value;
      }
      const id = ids[a]!;
      ids[a] = ids[b]!;
      ids[b] = id;
    },
    unite(first, end, target, offset) {
      for (let i = 0; i < 3; i++) {
        let min = Number.POSITIVE_INFINITY;
        let max = Number.NEGATIVE_INFINITY;
        for (let at = 6 * first + i; at < 6 * end; at += 6) {
          const low = boxes[at]!;
          const high = boxes[at + 3]!;
          if (low < min) min = low;
          if (high > max) max = high;
        }
        target[offset + i] = min;
        target[offset + 3 + i] = max;
      }
    },
    order: () => ids,
  };
}

function check(bounds: Float32Array, primitive: number): void {
  for (let i = 6 * primitive; i < 6 * primitive + 3; i++) {
    const min = bounds[i]!;
    const max = bounds[i + 3]!;
    // Only of finite numbers is the difference finite in doubles, and NaN fails the comparison.
    if (max - min >= 0 && max - min < Number.POSITIVE_INFINITY) continue;
    const box = `[${bounds.subarray(6 * primitive, 6 * primitive + 6).join(", ")}]`;
    const expectation = Number.isFinite(max - min) ? "minima not above maxima" : "finite numbers";
    throw new RangeError(`bounds of primitive ${primitive}: expected ${expectation}, got ${box}`);
  }
}
