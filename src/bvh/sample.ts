import { SIZE_WORD, type Slots, WORDS } from "./slots";

/** Primitives that stand for all others of a node of more than twice as many. */
export const SAMPLE = 512;

// A primitive as large as two bins, or this far outside of where the sample lies, is not left to chance: a few huge or far ones
// decide what boxes cost. This share is of the range of doubled centroids.
const NOTABLE = 1 / 16;
// A node's children's children's children are half as wide, or nearly: as often as a notable size can be halved and is still larger
// than all primitives, so many times three levels need not look for notable ones; one less, to be sure. Of those that lie far out
// only so many, as the next ones may have others.
const LEVELS_PER_HALF = 3;
const LEVELS_WITH_FAR_ONES = 2;

export type Sample = {
  /** Primitives that each stand for `weight` of them. They come first. */
  others: number;
  weight: number;
  /** Primitives that are large or far out. */
  notable: number;
  /** For how many levels of nodes there is no need to look for notable ones. */
  calmLevels: number;
};

/**
 * Copies the primitives of a large node that matter for its split to the front of the same range of other slots.
 *
 * @param isCalm - whether none of them is large.
 */
export function chooseSample(
  { words, pairs }: Slots,
  to: Slots,
  first: number,
  end: number,
  isCalm: boolean,
  sample: Sample,
): void {
  const record = WORDS;
  const size = SIZE_WORD;
  const start = record * first;
  const target = to.pairs;
  const stride = Math.ceil((end - first) / SAMPLE);
  let lowX = (words[start]! - words[start + 3]!) | 0;
  let lowY = (words[start + 1]! - words[start + 4]!) | 0;
  let lowZ = (words[start + 2]! - words[start + 5]!) | 0;
  let highX = lowX;
  let highY = lowY;
  let highZ = lowZ;
  let next = 4 * first;
  for (let i = 0, block = first; block < end; i++, block += stride) {
    // Another offset in each block: the same one could fall in step with the order of a mesh.
    const at = record * (block + ((Math.imul(i, 0x9e3779b1) >>> 0) % Math.min(stride, end - block)));
    const x = (words[at]! - words[at + 3]!) | 0;
    const y = (words[at + 1]! - words[at + 4]!) | 0;
    const z = (words[at + 2]! - words[at + 5]!) | 0;
    if (x < lowX) lowX = x;
    if (y < lowY) lowY = y;
    if (z < lowZ) lowZ = z;
    if (x > highX) highX = x;
    if (y > highY) highY = y;
    if (z > highZ) highZ = z;
    copy(pairs, at / 2, target, next);
    next += 4;
  }
  sample.weight = stride;
  sample.notable = 0;
  sample.calmLevels = 0;
  sample.others = next / 4 - first;
  if (isCalm) return;

  const limit = (Math.max(highX - lowX, highY - lowY, highZ - lowZ) * NOTABLE) | 0;
  next = dropLarge(to, first, next / 4, limit) * 4;
  sample.others = next / 4 - first;
  lowX = (lowX - limit) | 0;
  lowY = (lowY - limit) | 0;
  lowZ = (lowZ - limit) | 0;
  highX = (highX + limit) | 0;
  highY = (highY + limit) | 0;
  highZ = (highZ + limit) | 0;
  let largest = 0;
  for (let at = start; at < record * end; at += record) {
    const x = (words[at]! - words[at + 3]!) | 0;
    const y = (words[at + 1]! - words[at + 4]!) | 0;
    const z = (words[at + 2]! - words[at + 5]!) | 0;
    const own = words[at + size]!;
    if (own > largest) largest = own;
    // Negative if any of these is.
    const slack = (limit - own) | (x - lowX) | (highX - x) | (y - lowY) | (highY - y) | (z - lowZ) | (highZ - z);
    if (slack >= 0) continue;
    copy(pairs, at / 2, target, next);
    next += 4;
  }
  sample.notable = next / 4 - first - sample.others;
  const halvings = Math.floor(Math.log2(limit / Math.max(largest, 1)));
  const most = sample.notable > 0 ? LEVELS_WITH_FAR_ONES : Number.POSITIVE_INFINITY;
  sample.calmLevels = Math.min(Math.max(LEVELS_PER_HALF * halvings - 1, 0), most);
}

/** Closes ranks over the primitives above a size. @returns the slot after the last of those left. */
function dropLarge({ words, pairs }: Slots, first: number, end: number, limit: number): number {
  let next = first;
  for (let slot = first; slot < end; slot++) {
    if (words[WORDS * slot + SIZE_WORD]! <= limit) copy(pairs, 4 * slot, pairs, 4 * next++);
  }
  return next;
}

function copy(source: Float64Array, from: number, target: Float64Array, to: number): void {
  target[to] = source[from]!;
  target[to + 1] = source[from + 1]!;
  target[to + 2] = source[from + 2]!;
  target[to + 3] = source[from + 3]!;
}
