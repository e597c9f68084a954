import { NARROW } from "./bins";
import { INTERSECTION_COST, TRAVERSAL_COST } from "./sahCost";
import { GRID, type Slots, WORDS } from "./slots";

/** Nodes of at most so many primitives are swept. */
export const MOST_SWEPT = 16;

const LARGEST = GRID;
const [INTERSECTION, TRAVERSAL, SHARE] = [INTERSECTION_COST, TRAVERSAL_COST, NARROW];
// Per axis, the primitives in rising order of their centroids.
const sorted = new Uint8Array(3 * MOST_SWEPT);
const centroids = new Int32Array(MOST_SWEPT);
const ranks = new Int32Array(MOST_SWEPT);
const upperCosts = new Float64Array(MOST_SWEPT);

/**
 * Splits a small node where it is best of all planes between two centroids, and copies it, sorted, to the same range of other
 * slots.
 *
 * @param chosen - takes the axis.
 * @returns the first slot of the upper part; `first`, and nothing is copied, if it is better left together.
 */
export function sweep(
  from: Slots,
  to: Slots,
  first: number,
  end: number,
  maxLeaf: number,
  chosen: { axis: number },
): number {
  const { words } = from;
  const base = WORDS * first;
  const count = end - first;
  measure(words, base, count);
  const { area, own } = measured;
  // The parts of a split are no smaller than the primitives in them.
  const leafCost = count <= maxLeaf ? INTERSECTION * area * count : Number.POSITIVE_INFINITY;
  if (leafCost <= TRAVERSAL * area + INTERSECTION * own) return first;

  let best = Number.POSITIVE_INFINITY;
  let bestAxis = 0;
  let bestLower = 0;
  let difference = 0;
  const rangeX = sort(words, base, count, 0);
  const rangeY = sort(words, base + 1, count, 16);
  const rangeZ = sort(words, base + 2, count, 32);
  const least = SHARE * Math.max(rangeX, rangeY, rangeZ);
  for (let axis = 0; axis < 3; axis++) {
    const row = axis * 16;
    if ((axis === 0 ? rangeX : axis === 1 ? rangeY : rangeZ) < least) continue;
    let a = LARGEST;
    let b = LARGEST;
    let c = LARGEST;
    let d = LARGEST;
    let e = LARGEST;
    let f = LARGEST;
    for (let i = count - 1; i > 0; i--) {
      const at = base + 8 * sorted[row + i]!;
      difference = (words[at]! - a) | 0; // see lesser() in bins.ts
      a += difference & (difference >> 31);
      difference = (words[at + 1]! - b) | 0;
      b += difference & (difference >> 31);
      difference = (words[at + 2]! - c) | 0;
      c += difference & (difference >> 31);
      difference = (words[at + 3]! - d) | 0;
      d += difference & (difference >> 31);
      difference = (words[at + 4]! - e) | 0;
      e += difference & (difference >> 31);
      difference = (words[at + 5]! - f) | 0;
      f += difference & (difference >> 31);
      upperCosts[i] = halfArea(a, b, c, d, e, f) * (count - i);
    }
    a = LARGEST;
    b = LARGEST;
    c = LARGEST;
    d = LARGEST;
    e = LARGEST;
    f = LARGEST;
    for (let lower = 1; lower < count; lower++) {
      const at = base + 8 * sorted[row + lower - 1]!;
      difference = (words[at]! - a) | 0;
      a += difference & (difference >> 31);
      difference = (words[at + 1]! - b) | 0;
      b += difference & (difference >> 31);
      difference = (words[at + 2]! - c) | 0;
      c += difference & (difference >> 31);
      difference = (words[at + 3]! - d) | 0;
      d += difference & (difference >> 31);
      difference = (words[at + 4]! - e) | 0;
      e += difference & (difference >> 31);
      difference = (words[at + 5]! - f) | 0;
      f += difference & (difference >> 31);
      const cost = halfArea(a, b, c, d, e, f) * lower + upperCosts[lower]!;
      if (cost < best) {
        best = cost;
        bestAxis = axis;
        bestLower = lower;
      }
    }
  }
  if (leafCost <= TRAVERSAL * area + INTERSECTION * best) return first;

  copySorted(from.pairs, to.pairs, first, count, bestAxis * 16);
  chosen.axis = bestAxis;
  return first + (area > 0 ? bestLower : count >> 1);
}

// Half areas of the box around all, and of all boxes, summed.
const measured = { area: 0.5, own: 0.5 };

function measure(words: Int32Array, base: number, count: number): void {
  let a = LARGEST;
  let b = LARGEST;
  let c = LARGEST;
  let d = LARGEST;
  let e = LARGEST;
  let f = LARGEST;
  let own = 0;
  let difference = 0;
  for (let at = base; at < base + 8 * count; at += 8) {
    own += halfArea(words[at]!, words[at + 1]!, words[at + 2]!, words[at + 3]!, words[at + 4]!, words[at + 5]!);
    difference = (words[at]! - a) | 0;
    a += difference & (difference >> 31);
    difference = (words[at + 1]! - b) | 0;
    b += difference & (difference >> 31);
    difference = (words[at + 2]! - c) | 0;
    c += difference & (difference >> 31);
    difference = (words[at + 3]! - d) | 0;
    d += difference & (difference >> 31);
    difference = (words[at + 4]! - e) | 0;
    e += difference & (difference >> 31);
    difference = (words[at + 5]! - f) | 0;
    f += difference & (difference >> 31);
  }
  measured.area = halfArea(a, b, c, d, e, f);
  measured.own = own;
}

/**
 * Writes the primitives in rising order of their centroids. Each is compared with each, for that takes no branch: of so few it
 * is faster than to sort.
 *
 * @param start - the word of the first box's lower bound along the axis.
 * @returns how far the centroids reach.
 */
function sort(words: Int32Array, start: number, count: number, row: number): number {
  for (let i = 0; i < count; i++) {
    const centroid = (words[start + 8 * i]! - words[start + 8 * i + 3]!) | 0;
    let rank = i;
    for (let j = 0; j < i; j++) {
      const isBelow = ((centroid - centroids[j]!) | 0) >> 31; // −1 or 0
      rank += isBelow;
      ranks[j]! -= isBelow;
    }
    centroids[i] = centroid;
    ranks[i] = rank;
  }
  for (let i = 0; i < count; i++) sorted[row + ranks[i]!] = i;
  return centroids[sorted[row + count - 1]!]! - centroids[sorted[row]!]!;
}

function copySorted(source: Float64Array, target: Float64Array, first: number, count: number, row: number): void {
  for (let i = 0; i < count; i++) {
    const from = 4 * (first + sorted[row + i]!);
    const to = 4 * (first + i);
    target[to] = source[from]!;
    target[to + 1] = source[from + 1]!;
    target[to + 2] = source[from + 2]!;
    target[to + 3] = source[from + 3]!;
  }
}

/** Of a box in the words of a record. */
function halfArea(a: number, b: number, c: number, d: number, e: number, f: number): number {
  const x = LARGEST - a - d;
  const y = LARGEST - b - e;
  const z = LARGEST - c - f;
  return x * y + y * z + z * x;
}
