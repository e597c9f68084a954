import { GRID, type Slots, WORDS } from "./slots";

/** A plane between the primitives of a node. */
export type Split = {
  /** -1: there is none. */
  axis: number;
  /** Least min + max − GRID of a box, along `axis`, that is not below. */
  threshold: number;
  /** Half area times primitives, summed over both sides. */
  cost: number;
  /** Half the surface area of the node. */
  area: number;
  /** Largest extent of the centroids, in half steps of the grid. */
  range: number;
};

const MOST_BINS = 16;
// These suffice for few: of up to 64 primitives instead of 32, a tree of a million costs 0.03 % more.
const FEWER_BINS = 8;
const FEW = 64;

// A bin has the words of a box, then how many primitives its centroids stand for.
const BIN_WORDS = 8;
const COUNT_WORD = 6;
// Across axes along which centroids span no more than this share of the widest span, no plane is looked for.
export const NARROW = 1 / 2;
const bins = new Int32Array(3 * MOST_BINS * BIN_WORDS);
const upperCosts = new Float64Array(MOST_BINS);
const lows = new Int32Array(3);
const highs = new Int32Array(3);
const scales = new Float64Array(3);
const LARGEST = GRID;

/**
 * The best plane by the SAH, of those between the bins into which the centroids' ranges are divided.
 *
 * @param weighted - of the first so many primitives each counts `weight` times, of the others once.
 */
export function findBinnedSplit(
  slots: Slots,
  first: number,
  end: number,
  weighted: number,
  weight: number,
  split: Split,
) {
  measureCentroids(slots, first, end);
  const perAxis = end - first <= FEW ? FEWER_BINS : MOST_BINS;
  split.axis = -1;
  split.range = 0;
  split.cost = Number.POSITIVE_INFINITY;
  for (let axis = 0; axis < 3; axis++) split.range = Math.max(split.range, highs[axis]! - lows[axis]!);
  for (let axis = 0; axis < 3; axis++) {
    const range = highs[axis]! - lows[axis]!;
    scales[axis] = range > NARROW * split.range ? (perAxis * LAST_BIN) / range : 0;
  }
  fillBins(slots, first, end, weighted, weight, perAxis);
  for (let axis = 0; axis < 3; axis++) {
    if (scales[axis]! > 0) findPlane(axis, perAxis, split);
  }
}

// A little less than 1, so that the highest centroid is in the last bin, not behind it.
const LAST_BIN = 1 - 2 ** -40;

/**
 * The lesser of two whole numbers, without a branch. Where it is taken for every primitive, here and in sweep.ts, it is written
 * out: as calls of this function, which V8 then no longer inlines, building a tree over a million triangles takes 5.5 s
 * instead of 1.5.
 */
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

function measureCentroids({ words }: Slots, first: number, end: number): void {
  const record = WORDS;
  let lowX = LARGEST;
  let lowY = LARGEST;
  let lowZ = LARGEST;
  let negativeHighX = LARGEST;
  let negativeHighY = LARGEST;
  let negativeHighZ = LARGEST;
  for (let at = record * first; at < record * end; at += record) {
    const x = (words[at]! - words[at + 3]!) | 0;
    const y = (words[at + 1]! - words[at + 4]!) | 0;
    const z = (words[at + 2]! - words[at + 5]!) | 0;
    lowX = lesser(x, lowX);
    lowY = lesser(y, lowY);
    lowZ = lesser(z, lowZ);
    negativeHighX = lesser(-x | 0, negativeHighX);
    negativeHighY = lesser(-y | 0, negativeHighY);
    negativeHighZ = lesser(-z | 0, negativeHighZ);
  }
  lows[0] = lowX;
  lows[1] = lowY;
  lows[2] = lowZ;
  highs[0] = -negativeHighX;
  highs[1] = -negativeHighY;
  highs[2] = -negativeHighZ;
}

function fillBins(
  { words }: Slots,
  first: number,
  end: number,
  weighted: number,
  weight: number,
  perAxis: number,
): void {
  bins.fill(LARGEST, 0, 3 * perAxis * BIN_WORDS);
  for (let bin = 0; bin < 3 * perAxis; bin++) bins[bin * BIN_WORDS + COUNT_WORD] = 0;
  const record = WORDS;
  const unweighted = record * (first + weighted);
  const lowX = lows[0]!;
  const lowY = lows[1]!;
  const lowZ = lows[2]!;
  const scaleX = scales[0]!;
  const scaleY = scales[1]!;
  const scaleZ = scales[2]!;
  for (let at = record * first; at < record * end; at += record) {
    const a = words[at]!;
    const b = words[at + 1]!;
    const c = words[at + 2]!;
    const d = words[at + 3]!;
    const e = words[at + 4]!;
    const f = words[at + 5]!;
    const count = at < unweighted ? weight : 1;
    let difference = 0;
    if (scaleX > 0) {
      const inX = (((((a - d) | 0) - lowX) * scaleX) | 0) << 3;
      difference = (a - bins[inX]!) | 0;
      bins[inX]! += difference & (difference >> 31);
      difference = (b - bins[inX + 1]!) | 0;
      bins[inX + 1]! += difference & (difference >> 31);
      difference = (c - bins[inX + 2]!) | 0;
      bins[inX + 2]! += difference & (difference >> 31);
      difference = (d - bins[inX + 3]!) | 0;
      bins[inX + 3]! += difference & (difference >> 31);
      difference = (e - bins[inX + 4]!) | 0;
      bins[inX + 4]! += difference & (difference >> 31);
      difference = (f - bins[inX + 5]!) | 0;
      bins[inX + 5]! += difference & (difference >> 31);
      bins[inX + COUNT_WORD]! += count;
    }
    if (scaleY > 0) {
      const inY = (perAxis + (((((b - e) | 0) - lowY) * scaleY) | 0)) << 3;
      difference = (a - bins[inY]!) | 0;
      bins[inY]! += difference & (difference >> 31);
      difference = (b - bins[inY + 1]!) | 0;
      bins[inY + 1]! += difference & (difference >> 31);
      difference = (c - bins[inY + 2]!) | 0;
      bins[inY + 2]! += difference & (difference >> 31);
      difference = (d - bins[inY + 3]!) | 0;
      bins[inY + 3]! += difference & (difference >> 31);
      difference = (e - bins[inY + 4]!) | 0;
      bins[inY + 4]! += difference & (difference >> 31);
      difference = (f - bins[inY + 5]!) | 0;
      bins[inY + 5]! += difference & (difference >> 31);
      bins[inY + COUNT_WORD]! += count;
    }
    if (scaleZ > 0) {
      const inZ = (2 * perAxis + (((((c - f) | 0) - lowZ) * scaleZ) | 0)) << 3;
      difference = (a - bins[inZ]!) | 0;
      bins[inZ]! += difference & (difference >> 31);
      difference = (b - bins[inZ + 1]!) | 0;
      bins[inZ + 1]! += difference & (difference >> 31);
      difference = (c - bins[inZ + 2]!) | 0;
      bins[inZ + 2]! += difference & (difference >> 31);
      difference = (d - bins[inZ + 3]!) | 0;
      bins[inZ + 3]! += difference & (difference >> 31);
      difference = (e - bins[inZ + 4]!) | 0;
      bins[inZ + 4]! += difference & (difference >> 31);
      difference = (f - bins[inZ + 5]!) | 0;
      bins[inZ + 5]! += difference & (difference >> 31);
      bins[inZ + COUNT_WORD]! += count;
    }
  }
}

/** Puts the best plane across one axis in `split`, if it is better than what is there. */
function findPlane(axis: number, perAxis: number, split: Split): void {
  const base = axis * perAxis;
  let a = LARGEST;
  let b = LARGEST;
  let c = LARGEST;
  let d = LARGEST;
  let e = LARGEST;
  let f = LARGEST;
  let count = 0;
  let area = 0;
  for (let bin = perAxis - 1; bin >= 0; bin--) {
    const at = (base + bin) << 3;
    const own = bins[at + COUNT_WORD]!;
    if (own > 0) {
      a = lesser(bins[at]!, a);
      b = lesser(bins[at + 1]!, b);
      c = lesser(bins[at + 2]!, c);
      d = lesser(bins[at + 3]!, d);
      e = lesser(bins[at + 4]!, e);
      f = lesser(bins[at + 5]!, f);
      count += own;
      area = halfArea(a, b, c, d, e, f);
    }
    upperCosts[bin] = area * count;
  }
  split.area = area;

  a = LARGEST;
  b = LARGEST;
  c = LARGEST;
  d = LARGEST;
  e = LARGEST;
  f = LARGEST;
  count = 0;
  for (let bin = 0; bin < perAxis - 1; bin++) {
    const at = (base + bin) << 3;
    const own = bins[at + COUNT_WORD]!;
    if (own === 0) continue;
    a = lesser(bins[at]!, a);
    b = lesser(bins[at + 1]!, b);
    c = lesser(bins[at + 2]!, c);
    d = lesser(bins[at + 3]!, d);
    e = lesser(bins[at + 4]!, e);
    f = lesser(bins[at + 5]!, f);
    count += own;
    const cost = halfArea(a, b, c, d, e, f) * count + upperCosts[bin + 1]!;
    if (cost < split.cost) {
      split.cost = cost;
      split.axis = axis;
      split.threshold = Math.ceil(lows[axis]! + (bin + 1) / scales[axis]!);
    }
  }
}
