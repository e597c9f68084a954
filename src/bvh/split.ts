import type { Primitives } from "./primitives";
import { INTERSECTION_COST, TRAVERSAL_COST } from "./sahCost";

const BINS = 16;
// Maps the largest centroid into the last bin, not past it, whatever the rounding.
const BIN_SCALE = BINS * (1 - 2 ** -40);

export type Splitter = {
  /**
   * Sorts the slots from `first` to before `end` into two parts, the lower one first.
   *
   * @param levelsLeft - levels of tree there may be under this node.
   * @returns the first slot of the second part; `first` if the primitives are better left together.
   */
  split(first: number, end: number, levelsLeft: number): number;
  /** The axis of the last split. */
  axis(): number;
};

export function createSplitter({ boxes, swap }: Primitives, maxLeaf: number): Splitter {
  const centroids = new Float64Array(6);
  const scales = new Float64Array(3);
  const binBounds = new Float64Array(3 * BINS * 6);
  const binCounts = new Uint32Array(3 * BINS);
  const sweep = new Float64Array(6);
  const lowerCosts = new Float64Array(BINS);
  let axis = 0;
  let lastLowerBin = 0;

  const centroid = (slot: number, i: number) => boxes[6 * slot + i]! + boxes[6 * slot + 3 + i]!;

  function measureCentroids(first: number, end: number): void {
    for (let i = 0; i < 3; i++) {
      let min = Number.POSITIVE_INFINITY;
      let max = Number.NEGATIVE_INFINITY;
      for (let slot = first; slot < end; slot++) {
        const c = centroid(slot, i);
        if (c < min) min = c;
        if (c > max) max = c;
      }
      centroids[i] = min;
      centroids[3 + i] = max;
      scales[i] = max > min ? BIN_SCALE / (max - min) : 0;
    }
  }

  function fillBins(first: number, end: number): void {
    for (let at = 0; at < binBounds.length; at++) {
      binBounds[at] = at % 6 < 3 ? Number.POSITIVE_INFINITY : Number.NEGATIVE_INFINITY;
    }
    binCounts.fill(0);
    for (let slot = first; slot < end; slot++) {
      for (let i = 0; i < 3; i++) {
        const bin = i * BINS + Math.trunc((centroid(slot, i) - centroids[i]!) * scales[i]!);
        binCounts[bin]! += 1;
        grow(binBounds, 6 * bin, boxes, 6 * slot);
      }
    }
  }

  /** Least Σ area · count over the two sides, in units of half areas; `axis` and `lastLowerBin` say where. */
  function findBest(): number {
    let best = Number.POSITIVE_INFINITY;
    for (let i = 0; i < 3; i++) {
      if (scales[i] === 0) continue;
      let count = 0;
      sweep.set(EMPTY);
      for (let bin = 0; bin < BINS - 1; bin++) {
        grow(sweep, 0, binBounds, 6 * (i * BINS + bin));
        count += binCounts[i * BINS + bin]!;
        lowerCosts[bin] = halfArea(sweep, 0) * count;
      }
      count = 0;
      sweep.set(EMPTY);
      for (let bin = BINS - 1; bin > 0; bin--) {
        grow(sweep, 0, binBounds, 6 * (i * BINS + bin));
        count += binCounts[i * BINS + bin]!;
        const cost = lowerCosts[bin - 1]! + halfArea(sweep, 0) * count;
        if (cost < best) {
          best = cost;
          axis = i;
          lastLowerBin = bin - 1;
        }
      }
    }
    return best;
  }

  function partition(first: number, end: number): number {
    const low = centroids[axis]!;
    const scale = scales[axis]!;
    let [left, right] = [first, end - 1];
    for (;;) {
      while (left <= right && Math.trunc((centroid(left, axis) - low) * scale) <= lastLowerBin) left++;
      while (left <= right && Math.trunc((centroid(right, axis) - low) * scale) > lastLowerBin) right--;
      if (left >= right) return left;
      swap(left++, right--);
    }
  }

  /** Halves by count along the longest axis of the centroids. */
  function halve(first: number, end: number): number {
    axis = 0;
    for (let i = 1; i < 3; i++) {
      if (centroids[3 + i]! - centroids[i]! > centroids[3 + axis]! - centroids[axis]!) axis = i;
    }
    const middle = (first + end) >>> 1;
    let [from, to] = [first, end - 1];
    while (scales[axis] !== 0 && from < to) {
      const pivot = centroid((from + to) >>> 1, axis);
      let [left, right] = [from, to];
      while (left <= right) {
        while (centroid(left, axis) < pivot) left++;
        while (centroid(right, axis) > pivot) right--;
        if (left <= right) swap(left++, right--);
      }
      if (middle <= right) to = right;
      else if (middle >= left) from = left;
      else break;
    }
    return middle;
  }

  return {
    split(first, end, levelsLeft) {
      const count = end - first;
      if (count <= 1) return first;
      measureCentroids(first, end);
      const mustSplit = count > maxLeaf;
      // Halving from here on still fits; one level later it might not.
      if (mustSplit && count > maxLeaf * 2 ** (levelsLeft - 1)) return halve(first, end);
      if (levelsLeft === 0) return first;

      fillBins(first, end);
      const area = nodeHalfArea(first, end);
      const best = findBest();
      const cost = TRAVERSAL_COST * area + INTERSECTION_COST * best;
      if (cost < INTERSECTION_COST * area * count) return partition(first, end);
      if (!mustSplit) return first;
      return area > 0 && best < Number.POSITIVE_INFINITY ? partition(first, end) : halve(first, end);
    },
    axis: () => axis,
  };

  function nodeHalfArea(first: number, end: number): number {
    sweep.set(EMPTY);
    for (let slot = first; slot < end; slot++) grow(sweep, 0, boxes, 6 * slot);
    return halfArea(sweep, 0);
  }
}

const EMPTY = [
  Number.POSITIVE_INFINITY,
  Number.POSITIVE_INFINITY,
  Number.POSITIVE_INFINITY,
  Number.NEGATIVE_INFINITY,
  Number.NEGATIVE_INFINITY,
  Number.NEGATIVE_INFINITY,
];

function grow(target: Float64Array, to: number, source: Float32Array | Float64Array, from: number): void {
  for (let i = 0; i < 3; i++) {
    if (source[from + i]! < target[to + i]!) target[to + i] = source[from + i]!;
    if (source[from + 3 + i]! > target[to + 3 + i]!) target[to + 3 + i] = source[from + 3 + i]!;
  }
}

function halfArea(box: Float64Array, at: number): number {
  const x = box[at + 3]! - box[at]!;
  const y = box[at + 4]! - box[at + 1]!;
  const z = box[at + 5]! - box[at + 2]!;
  return x >= 0 ? x * y + y * z + z * x : 0;
}
