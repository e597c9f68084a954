// What a build moves about: one record per primitive, sorted in place of an index, so that neighbours in the tree are
// neighbours in memory.
//
// Boxes are whole numbers of steps on a grid. The least of two such numbers takes no branch; of floats it takes one, and in a
// node of some dozens of primitives that is guessed wrong half of the time, which is three times as slow. Maxima are counted
// down from the grid's last line, so that every union is six minima.

/** Words of a record: least x, y, z; greatest x, y, z counted down from GRID; the primitive; its box's longest side. */
export const WORDS = 8;
export const PRIMITIVE_WORD = 6;
export const SIZE_WORD = 7;
/** The grid's last line: sums of two numbers fit 31 bits, and no two words in a row are a NaN where a double is moved. */
export const GRID = 2 ** 29 - 1;

/** Records, in two views of one memory: read as words, moved as doubles. */
export type Slots = {
  readonly words: Int32Array;
  readonly pairs: Float64Array;
};

export function createSlots(count: number): Slots {
  const words = new Int32Array(WORDS * count);
  return { words, pairs: new Float64Array(words.buffer) };
}

/**
 * Writes the boxes of the primitives in a range of slots, on a grid that just holds them, the same for all axes.
 *
 * @param bounds - of all primitives, as `buildBvh` takes them.
 */
export function quantize({ words }: Slots, first: number, end: number, bounds: Float32Array): void {
  const stride = WORDS;
  const start = stride * first;
  const stop = stride * end;
  let minX = Number.POSITIVE_INFINITY;
  let minY = Number.POSITIVE_INFINITY;
  let minZ = Number.POSITIVE_INFINITY;
  let maxX = Number.NEGATIVE_INFINITY;
  let maxY = Number.NEGATIVE_INFINITY;
  let maxZ = Number.NEGATIVE_INFINITY;
  for (let at = start + PRIMITIVE_WORD; at < stop; at += stride) {
    const from = 6 * words[at]!;
    if (bounds[from]! < minX) minX = bounds[from]!;
    if (bounds[from + 1]! < minY) minY = bounds[from + 1]!;
    if (bounds[from + 2]! < minZ) minZ = bounds[from + 2]!;
    if (bounds[from + 3]! > maxX) maxX = bounds[from + 3]!;
    if (bounds[from + 4]! > maxY) maxY = bounds[from + 4]!;
    if (bounds[from + 5]! > maxZ) maxZ = bounds[from + 5]!;
  }
  const extent = Math.max(maxX - minX, maxY - minY, maxZ - minZ);
  const grid = GRID;
  const primitive = PRIMITIVE_WORD;
  const size = SIZE_WORD;
  const scale = extent > 0 ? (grid - 1) / extent : 0;
  for (let at = start; at < stop; at += stride) {
    const from = 6 * words[at + primitive]!;
    const x = Math.trunc((bounds[from]! - minX) * scale);
    const y = Math.trunc((bounds[from + 1]! - minY) * scale);
    const z = Math.trunc((bounds[from + 2]! - minZ) * scale);
    const upperX = Math.trunc((bounds[from + 3]! - minX) * scale);
    const upperY = Math.trunc((bounds[from + 4]! - minY) * scale);
    const upperZ = Math.trunc((bounds[from + 5]! - minZ) * scale);
    words[at] = x;
    words[at + 1] = y;
    words[at + 2] = z;
    words[at + 3] = grid - upperX;
    words[at + 4] = grid - upperY;
    words[at + 5] = grid - upperZ;
    words[at + size] = Math.max(upperX - x, upperY - y, upperZ - z);
  }
}

/**
 * Copies a range to the same range of other slots, those below a plane from its front on, the others from its back.
 *
 * @param threshold - least min + max − GRID of a box, along `axis`, that is not below.
 * @returns the first slot of those that are not below.
 */
export function partition(
  { words, pairs }: Slots,
  to: Slots,
  first: number,
  end: number,
  axis: number,
  threshold: number,
): number {
  const target = to.pairs;
  let front = 4 * first;
  let back = 4 * (end - 1);
  for (let from = 4 * first, word = 8 * first + axis; from < 4 * end; from += 4, word += 8) {
    const isBelow = (words[word]! - words[word + 3]! - threshold) >> 31; // every bit, or none
    const at = (front & isBelow) | (back & ~isBelow);
    target[at] = pairs[from]!;
    target[at + 1] = pairs[from + 1]!;
    target[at + 2] = pairs[from + 2]!;
    target[at + 3] = pairs[from + 3]!;
    front += isBelow & 4;
    back -= ~isBelow & 4;
  }
  return front / 4;
}

/** Sorts a range so that no centroid before its middle lies above one after, along `axis`. @returns the middle slot. */
export function halve(slots: Slots, first: number, end: number, axis: number): number {
  const { words } = slots;
  const middle = (first + end) >>> 1;
  const centroid = (slot: number) => words[8 * slot + axis]! - words[8 * slot + axis + 3]!;
  for (let [from, to] = [first, end - 1]; from < to; ) {
    const pivot = centroid((from + to) >>> 1);
    let [left, right] = [from, to];
    while (left <= right) {
      while (centroid(left) < pivot) left++;
      while (centroid(right) > pivot) right--;
      if (left <= right) swap(slots, left++, right--);
    }
    if (middle <= right) to = right;
    else if (middle >= left) from = left;
    else break;
  }
  return middle;
}

function swap({ pairs }: Slots, a: number, b: number): void {
  for (let i = 0; i < 4; i++) {
    const pair = pairs[4 * a + i]!;
    pairs[4 * a + i] = pairs[4 * b + i]!;
    pairs[4 * b + i] = pair;
  }
}
