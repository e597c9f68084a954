import { nextTask } from "../../nextTask";
import { keep } from "../../scene/keptBytes";
import type { DecodedImage } from "../loadedScene";

/** Texels that are read in one task: they take a few milliseconds. */
const SLICE_TEXELS = 2 ** 18;

/** Light by sRGB, both from 0 to 1: IEC 61966-2-1, as `linearOf` in `wgsl/textures.wgsl` has it. */
const linearOf = (c: number) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);

const BYTES = Array.from({ length: 256 }, (_, byte) => byte);
const DATA = Float64Array.from(BYTES);
const LINEAR = Float64Array.from(BYTES, (byte) => linearOf(byte / 255));
/** Light from which on the next byte is nearer. */
const ROUNDED_UP = Float64Array.from(BYTES, (byte) => (byte === 255 ? 2 : linearOf((byte + 0.5) / 255)));
const STEPS = 4096;
/** A byte that is at most what light rounds to, by light in steps: one or two below it. */
const AT_LEAST = (() => {
  let byte = 0;
  return Uint8Array.from({ length: STEPS + 1 }, (_, step) => {
    while (step / STEPS >= ROUNDED_UP[byte]!) byte++;
    return byte;
  });
})();

/**
 * A smaller picture, a slice in each task: every texel is the mean of the rectangle that it covers.
 *
 * @param isColor - whether red, green and blue are sRGB, of which the light is averaged, or data. Alpha is always data.
 */
export async function shrinkPicture(
  image: DecodedImage,
  [width, height]: readonly [number, number],
  isColor: boolean,
  signal: AbortSignal | undefined,
): Promise<DecodedImage> {
  const texels = new Uint8Array(4 * width * height);
  const columns = overlaps(image.width, width);
  const rows = overlaps(image.height, height);
  // Of a row of the result, and of the next, into which a row of the picture can reach too.
  let sums = new Float64Array(4 * width);
  let next = new Float64Array(4 * width);
  const line = new Float64Array(4 * width);
  let unbrokenTexels = 0;
  for (let row = 0; row < image.height; row++) {
    unbrokenTexels += image.width;
    if (unbrokenTexels > SLICE_TEXELS) {
      unbrokenTexels = image.width;
      await nextTask();
      signal?.throwIfAborted();
    }
    line.fill(0);
    addTexels(image, row, columns, isColor, line);
    addLine(line, rows.share[row]!, sums);
    if (rows.rest[row]! > 0) addLine(line, rows.rest[row]!, next);
    const y = rows.target[row]!;
    if (rows.target[row + 1] === y) continue;
    writeTexels(sums, isColor, texels, 4 * width * y);
    [sums, next] = [next, sums];
    next.fill(0);
  }
  return { width, height, texels: keep(texels) };
}

/** By column (or row) of a picture: the column of the smaller one that it is in, and its share of that and of the one behind. */
type Overlaps = { readonly target: Uint32Array; readonly share: Float64Array; readonly rest: Float64Array };

function overlaps(from: number, to: number): Overlaps {
  const [target, share, rest] = [new Uint32Array(from), new Float64Array(from), new Float64Array(from)];
  for (let i = 0; i < from; i++) {
    // In units of 1/to of a column, so that these are integers.
    const column = Math.floor((i * to) / from);
    const here = Math.min(to, (column + 1) * from - i * to);
    target[i] = column;
    share[i] = here / from;
    rest[i] = (to - here) / from;
  }
  return { target, share, rest };
}

function addTexels(
  { texels, width }: DecodedImage,
  row: number,
  columns: Overlaps,
  isColor: boolean,
  line: Float64Array,
) {
  const { target, share, rest } = columns;
  const values = isColor ? LINEAR : DATA;
  for (let x = 0, from = 4 * width * row; x < width; x++, from += 4) {
    const to = 4 * target[x]!;
    const red = values[texels[from]!]!;
    const green = values[texels[from + 1]!]!;
    const blue = values[texels[from + 2]!]!;
    const alpha = texels[from + 3]!;
    const weight = share[x]!;
    line[to]! += weight * red;
    line[to + 1]! += weight * green;
    line[to + 2]! += weight * blue;
    line[to + 3]! += weight * alpha;
    const weightBehind = rest[x]!;
    if (weightBehind === 0) continue;
    line[to + 4]! += weightBehind * red;
    line[to + 5]! += weightBehind * green;
    line[to + 6]! += weightBehind * blue;
    line[to + 7]! += weightBehind * alpha;
  }
}

function addLine(line: Float64Array, weight: number, sums: Float64Array): void {
  for (let i = 0; i < line.length; i++) sums[i]! += weight * line[i]!;
}

function writeTexels(sums: Float64Array, isColor: boolean, texels: Uint8Array, start: number): void {
  for (let i = 0; i < sums.length; i++) {
    texels[start + i] = isColor && i % 4 < 3 ? byteOf(sums[i]!) : Math.round(sums[i]!);
  }
}

function byteOf(light: number): number {
  let byte = AT_LEAST[Math.floor(light * STEPS)]!;
  while (light >= ROUNDED_UP[byte]!) byte++;
  return byte;
}
