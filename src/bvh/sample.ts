import { SIZE_WORD, type Slots, WORDS } from "./slots";

/** Primitives that stand for all others of a larger node. Twice as many change the cost of a tree by 0.3 % either way. */
export const SAMPLE = 512;

// A primitive that sticks out of its bin, or lies a bin outside of where the sample does, is not left to chance: a few huge or
// far ones decide what boxes cost. Of a range in doubled coordinates this is half of a sixteenth.
const NOTABLE = 1 / 32;

/** @returns an offset in [0, stride), another for each `i`: a fixed one could fall in step with the order of a mesh. */
const jitter = (i: number, stride: number) => (Math.imul(i, 0x9e3779b1) >>> 0) % stride;

/**
 * Copies the primitives of a large node that matter for its split to the front of the same range of other slots: first those
 * which are large or far out, then some of the rest.
 *
 * @param chosen - takes how many there are of either kind.
 * @returns how many primitives one of the rest stands for.
 */
export function chooseSample(
  { words, pairs }: Slots,
  to: Slots,
  first: number,
  end: number,
  chosen: { notable: number; others: number },
): number {
  const stride = Math.ceil((end - first) / SAMPLE);
  const [record, size] = [WORDS, SIZE_WORD];
  const [start, stop] = [record * first, record * end];
  let lowX = words[start]! - words[start + 3]!;
  let lowY = words[start + 1]! - words[start + 4]!;
  let lowZ = words[start + 2]! - words[start + 5]!;
  let [highX, highY, highZ] = [lowX, lowY, lowZ];
  for (let i = 0, block = first; block < end; i++, block += stride) {
    const at = record * (block + jitter(i, Math.min(stride, end - block)));
    const x = words[at]! - words[at + 3]!;
    const y = words[at + 1]! - words[at + 4]!;
    const z = words[at + 2]! - words[at + 5]!;
    if (x < lowX) lowX = x;
    if (y < lowY) lowY = y;
    if (z < lowZ) lowZ = z;
    if (x > highX) highX = x;
    if (y > highY) highY = y;
    if (z > highZ) highZ = z;
  }
  const limit = Math.trunc(Math.max(highX - lowX, highY - lowY, highZ - lowZ) * NOTABLE);
  lowX -= limit;
  lowY -= limit;
  lowZ -= limit;
  highX += limit;
  highY += limit;
  highZ += limit;

  const target = to.pairs;
  let next = 4 * first;
  for (let at = start; at < stop; at += record) {
    const x = words[at]! - words[at + 3]!;
    const y = words[at + 1]! - words[at + 4]!;
    const z = words[at + 2]! - words[at + 5]!;
    const isPlain = words[at + size]! <= limit && x >= lowX && x <= highX && y >= lowY && y <= highY && z >= lowZ && z <= highZ;
    if (isPlain) continue;
    for (let i = 0; i < 4; i++) target[next + i] = pairs[at / 2 + i]!;
    next += 4;
  }
  chosen.notable = next / 4 - first;
  for (let i = 0, block = first; block < end; i++, block += stride) {
    const at = record * (block + jitter(i, Math.min(stride, end - block)));
    if (words[at + size]! > limit) continue;
    for (let j = 0; j < 4; j++) target[next + j] = pairs[at / 2 + j]!;
    next += 4;
  }
  chosen.others = next / 4 - first - chosen.notable;
  return stride;
}
