import { INTERSECTION_COST, TRAVERSAL_COST } from "./sahCost";
import { GRID, type Slots, WORDS } from "./slots";

/** Nodes of at most so many primitives are swept. */
export const MOST_SWEPT = 16;

const LARGEST = GRID;
const [INTERSECTION, TRAVERSAL] = [INTERSECTION_COST, TRAVERSAL_COST];
// Per axis, the centroids in rising order, each with its slot in the last four bits.
const keys = new Float64Array(3 * MOST_SWEPT);
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
  if (count <= maxLeaf && isBetterTogether(words, base, count)) return first;

  let best = Number.POSITIVE_INFINITY;
  let bestAxis = 0;
  let bestLower = 0;
  let nodeArea = 0;
  for (let axis = 0; axis < 3; axis++) {
    const row = axis * 16;
    sort(words, base + axis, count, row);
    let a = LARGEST;
    let b = LARGEST;
    let c = LARGEST;
    let d = LARGEST;
    let e = LARGEST;
    let f = LARGEST;
    for (let i = count - 1; i >= 0; i--) {
      const at = base + ((keys[row + i]! & 15) << 3);
      a = lesser(words[at]!, a);
      b = lesser(words[at + 1]!, b);
      c = lesser(words[at + 2]!, c);
      d = lesser(words[at + 3]!, d);
      e = lesser(words[at + 4]!, e);
      f = lesser(words[at + 5]!, f);
      nodeArea = halfArea(a, b, c, d, e, f);
      upperCosts[i] = nodeArea * (count - i);
    }
    a = LARGEST;
    b = LARGEST;
    c = LARGEST;
    d = LARGEST;
    e = LARGEST;
    f = LARGEST;
    for (let lower = 1; lower < count; lower++) {
      const at = base + ((keys[row + lower - 1]! & 15) << 3);
      a = lesser(words[at]!, a);
      b = lesser(words[at + 1]!, b);
      c = lesser(words[at + 2]!, c);
      d = lesser(words[at + 3]!, d);
      e = lesser(words[at + 4]!, e);
      f = lesser(words[at + 5]!, f);
      const cost = halfArea(a, b, c, d, e, f) * lower + upperCosts[lower]!;
      if (cost < best) {
        best = cost;
        bestAxis = axis;
        bestLower = lower;
      }
    }
  }
  const isWorthIt = TRAVERSAL * nodeArea + INTERSECTION * best < INTERSECTION * nodeArea * count;
  if (count <= maxLeaf && !isWorthIt) return first;

  copySorted(from.pairs, to.pairs, first, count, bestAxis * 16);
  chosen.axis = bestAxis;
  return first + (nodeArea > 0 ? bestLower : count >> 1);
}

/** Whether a leaf costs no more than any split: the parts of one are no smaller than the primitives in them. */
function isBetterTogether(words: Int32Array, base: number, count: number): boolean {
  let a = LARGEST;
  let b = LARGEST;
  let c = LARGEST;
  let d = LARGEST;
  let e = LARGEST;
  let f = LARGEST;
  let own = 0;
  for (let at = base; at < base + 8 * count; at += 8) {
    own += halfArea(words[at]!, words[at + 1]!, words[at + 2]!, words[at + 3]!, words[at + 4]!, words[at + 5]!);
    a = lesser(words[at]!, a);
    b = lesser(words[at + 1]!, b);
    c = lesser(words[at + 2]!, c);
    d = lesser(words[at + 3]!, d);
    e = lesser(words[at + 4]!, e);
    f = lesser(words[at + 5]!, f);
  }
  const area = halfArea(a, b, c, d, e, f);
  return INTERSECTION * area * count <= TRAVERSAL * area + INTERSECTION * own;
}

/** Insertion sort of centroids. @param start - the word of the first box's lower bound along the axis. */
function sort(words: Int32Array, start: number, count: number, row: number): void {
  for (let i = 0; i < count; i++) {
    const key = (words[start + 8 * i]! - words[start + 8 * i + 3]!) * 16 + i;
    let at = row + i;
    for (; at > row && keys[at - 1]! > key; at--) keys[at] = keys[at - 1]!;
    keys[at] = key;
  }
}

function copySorted(source: Float64Array, target: Float64Array, first: number, count: number, row: number): void {
  for (let i = 0; i < count; i++) {
    const from = 4 * (first + (keys[row + i]! & 15));
    const to = 4 * (first + i);
    target[to] = source[from]!;
    target[to + 1] = source[from + 1]!;
    target[to + 2] = source[from + 2]!;
    target[to + 3] = source[from + 3]!;
  }
}

/** The lesser of two whole numbers, without a branch. */
function lesser(a: number, b: number): number {
  const difference = (a - b) | 0;
  return b + (difference & (difference >> 31));
}

/** Of a box in the words of a record. */
function halfArea(a: number, b: number, c: number, d: number, e: number, f: number): number {
  const x = LARGEST - a - d;
  const y = LARGEST - b - e;
  const z = LARGEST - c - f;
  return x * y + y * z + z * x;
}
