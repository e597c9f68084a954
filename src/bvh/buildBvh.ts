import { findBinnedSplit, type Split } from "./bins";
import type { Bvh } from "./bvh";
import { INTERSECTION_COST, TRAVERSAL_COST } from "./sahCost";
import { chooseSample, SAMPLE, type Sample } from "./sample";
import { createSlots, halve, PRIMITIVE_WORD, partition, quantize, WORDS } from "./slots";
import { MOST_SWEPT, sweep } from "./sweep";
import { uniteBounds } from "./uniteBounds";

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
// Where centroids lie in a range of fewer half steps of the grid, it is too coarse for them.
const COARSE = 2 ** 12;
// Progress is told when this share of the primitives has been placed since the last time.
const PROGRESS_STEP = 1 / 128;

/**
 * Builds a binary BVH with binned SAH (Wald 2007, "On fast Construction of SAH-based Bounding Volume Hierarchies").
 *
 * Nodes of few primitives try every plane between two centroids; of many, bins are filled with a sample of them.
 *
 * @param bounds - `[minX, minY, minZ, maxX, maxY, maxZ]` per primitive, world space; length `6 * count`. Not kept, not changed.
 * @throws {RangeError} if a bound is not finite or a minimum lies above its maximum, naming the primitive. An empty input
 *   gives one empty leaf.
 */
export function buildBvh(bounds: Float32Array, { maxLeaf = DEFAULT_MAX_LEAF, onProgress }: BuildOptions = {}): Bvh {
  if (!Number.isInteger(maxLeaf) || maxLeaf < 1 || maxLeaf > 255) {
    throw new RangeError(`maxLeaf: expected an integer from 1 to 255, got ${maxLeaf}`);
  }
  checkBounds(bounds);
  const count = bounds.length / 6;
  const order = new Uint32Array(count);
  const splitter = createSplitter(bounds, maxLeaf);
  const { links, axes, counts } = createNodes(Math.max(2 * count - 1, 1));
  const progressStep = Math.max(Math.ceil(count * PROGRESS_STEP), 1);

  // Second children wait on a stack.
  const pending = new Uint32Array(6 * MAX_DEPTH);
  let waiting = 0;
  let first = 0;
  let end = count;
  let side = 0;
  let calm = 0;
  let depth = 0;
  let node = 0;
  let deepest = 0;
  let told = 0;
  for (;;) {
    const middle = splitter.split(side, first, end, MAX_DEPTH - depth, calm);
    if (middle > first) {
      axes[node] = splitter.axis;
      side = splitter.side;
      calm = splitter.calmLevels;
      depth += 1;
      pending[waiting] = node;
      pending[waiting + 1] = middle;
      pending[waiting + 2] = end;
      pending[waiting + 3] = side;
      pending[waiting + 4] = depth;
      pending[waiting + 5] = calm;
      waiting += 6;
      end = middle;
    } else {
      axes[node] = LEAF_AXIS;
      counts[node] = end - first;
      links[node] = first;
      splitter.copyPrimitives(side, first, end, order);
      if (depth > deepest) deepest = depth;
      if (onProgress !== undefined && end - told >= progressStep && end < count) {
        onProgress(end / count);
        told = end;
      }
      if (waiting === 0) break;
      waiting -= 6;
      links[pending[waiting]!] = node + 1;
      first = pending[waiting + 1]!;
      end = pending[waiting + 2]!;
      side = pending[waiting + 3]!;
      depth = pending[waiting + 4]!;
      calm = pending[waiting + 5]!;
    }
    node += 1;
  }
  const nodeCount = node + 1;
  const tree = {
    bounds: new Float32Array(6 * nodeCount),
    links: links.slice(0, nodeCount),
    axes: axes.slice(0, nodeCount),
    counts: counts.slice(0, nodeCount),
    order,
    depth: deepest,
  };
  uniteBounds(tree, bounds);
  onProgress?.(1);
  return tree;
}

function checkBounds(bounds: Float32Array): void {
  if (bounds.length % 6 !== 0) {
    throw new RangeError(`bounds: expected 6 numbers per primitive, got ${bounds.length} numbers`);
  }
  for (let at = 0; at < bounds.length; at += 6) {
    const x = bounds[at + 3]! - bounds[at]!;
    const y = bounds[at + 4]! - bounds[at + 1]!;
    const z = bounds[at + 5]! - bounds[at + 2]!;
    // In doubles the differences of finite floats are finite, and what comes of NaN fails every comparison.
    if (x >= 0 && y >= 0 && z >= 0 && x + y + z < Number.POSITIVE_INFINITY) continue;
    const box = [...bounds.subarray(at, at + 6)];
    const expectation = box.every(Number.isFinite) ? "minima not above maxima" : "finite numbers";
    throw new RangeError(`bounds of primitive ${at / 6}: expected ${expectation}, got [${box.join(", ")}]`);
  }
}

/** Whoever decides where nodes are split. Primitives are in one of two arrays of slots, `side` says which. */
type Splitter = {
  /** Of the last split. */
  axis: number;
  /** Where the primitives are after the last split. */
  side: number;
  /** To be passed on to where the two parts are split. */
  calmLevels: number;
  /**
   * Sorts a range of slots into two parts, the lower one first.
   *
   * @param levelsLeft - how deep a tree may be under this node.
   * @returns the first slot of the upper part; `first` if the range is to be a leaf.
   */
  split(side: number, first: number, end: number, levelsLeft: number, calmLevels: number): number;
  copyPrimitives(side: number, first: number, end: number, target: Uint32Array): void;
};

function createSplitter(bounds: Float32Array, maxLeaf: number): Splitter {
  const count = bounds.length / 6;
  const sides = [createSlots(count), createSlots(count)] as const;
  for (let slot = 0; slot < count; slot++) sides[0].words[WORDS * slot + PRIMITIVE_WORD] = slot;
  quantize(sides[0], 0, count, bounds);
  const plane: Split = { axis: -1, threshold: 0, cost: 0, area: 0, range: 0 };
  const sample: Sample = { others: 0, weight: 0, notable: 0, calmLevels: 0 };

  function findPlane(side: number, first: number, end: number, calmLevels: number): void {
    const from = side === 0 ? sides[0] : sides[1];
    if (end - first <= 2 * SAMPLE) {
      findBinnedSplit(from, first, end, 0, 1, plane);
      return;
    }
    const to = side === 0 ? sides[1] : sides[0];
    chooseSample(from, to, first, end, calmLevels > 0, sample);
    findBinnedSplit(to, first, first + sample.others + sample.notable, sample.others, sample.weight, plane);
  }

  return {
    axis: 0,
    side: 0,
    calmLevels: 0,
    split(side, first, end, levelsLeft, calmLevels) {
      const from = side === 0 ? sides[0] : sides[1];
      const to = side === 0 ? sides[1] : sides[0];
      const size = end - first;
      if (size <= 1 || levelsLeft === 0) return first;
      // Halved from here on, a tree still fits; a level further down it might not.
      const mustHalve = size > maxLeaf * 2 ** (levelsLeft - 1);
      if (size <= MOST_SWEPT && !mustHalve) {
        this.side = 1 - side;
        return sweep(from, to, first, end, maxLeaf, this);
      }

      findPlane(side, first, end, calmLevels);
      if (plane.range < COARSE) {
        quantize(from, first, end, bounds);
        findPlane(side, first, end, 0);
      }
      this.calmLevels = calmLevels > 0 ? calmLevels - 1 : sample.calmLevels;
      if (plane.axis >= 0 && plane.area > 0 && !mustHalve) {
        const cost = TRAVERSAL_COST * plane.area + INTERSECTION_COST * plane.cost;
        if (size <= maxLeaf && cost >= INTERSECTION_COST * plane.area * size) return first;
        const middle = partition(from, to, first, end, plane.axis, plane.threshold);
        if (middle > first && middle < end) {
          this.axis = plane.axis;
          this.side = 1 - side;
          return middle;
        }
      }
      if (size <= maxLeaf) return first;
      this.axis = Math.max(plane.axis, 0);
      this.side = side;
      return halve(from, first, end, this.axis);
    },
    copyPrimitives(side, first, end, target) {
      const { words } = side === 0 ? sides[0] : sides[1];
      for (let slot = first; slot < end; slot++) target[slot] = words[WORDS * slot + PRIMITIVE_WORD]!;
    },
  };
}

function createNodes(count: number) {
  return { links: new Uint32Array(count), axes: new Uint8Array(count), counts: new Uint8Array(count) };
}
