import { BLOCK_SIDE, BLOCK_STRIPS } from "../gpu/strips";

/** Samples per pixel that one dispatch adds to some of the film's strips: see `wgsl/slice.wgsl`. */
export type Slice = {
  readonly half: 0 | 1;
  /** Index of the first sample within the half. */
  readonly firstSample: number;
  /** Samples per pixel. */
  readonly sampleCount: number;
  /** From the first strip to before the last, in the order of the pass. */
  readonly firstStrip: number;
  readonly endStrip: number;
  /** Strips that stay together in that order: 1, or a block's. */
  readonly unitStrips: number;
  /** Units from one to the next in that order, modulo their number. */
  readonly unitStride: number;
  /** Camera paths in it; on average, where the film's edge cuts blocks. */
  readonly paths: number;
};

// Slices smaller than this many blocks are made of single strips, or they would show too little of the picture to tell from
// them how long the rest takes.
const FEW_BLOCKS = 32;

type Pass = Pick<Slice, "half" | "sampleCount" | "unitStrips" | "unitStride"> & { strip: number };

/**
 * Which samples the film holds and which come next. Samples are taken in passes over the whole image, each for one half
 * of the film, the halves in turn so that they stay equally full. A pass is cut into slices, each of which is spread over
 * the whole image: so slices of one size take about the same time, whatever is seen where.
 */
export class Schedule {
  /** Of the film. */
  readonly pixels: number;
  readonly #strips: number;
  readonly #samples: [number, number] = [0, 0];
  #pass: Pass | undefined;

  constructor(width: number, height: number) {
    this.pixels = width * height;
    this.#strips = BLOCK_STRIPS * Math.ceil(width / BLOCK_SIDE) * Math.ceil(height / BLOCK_SIDE);
  }

  /** Samples per pixel in both halves together, complete passes only. */
  get samples(): number {
    return this.#samples[0] + this.#samples[1];
  }

  /** Whether no pass is under way. */
  get isComplete(): boolean {
    return this.#pass === undefined;
  }

  /**
   * The next slice, of at most `paths` paths, but one strip at least. Where it opens a pass, the pass takes as many samples
   * as bring both halves closer to `remaining` more in total, but at most `maxCount`.
   */
  next(paths: number, maxCount: number, remaining: number): Slice {
    this.#pass ??= this.#open(paths, maxCount, remaining);
    const { half, sampleCount, strip, unitStrips, unitStride } = this.#pass;
    const passPaths = sampleCount * this.pixels;
    const wanted = strip + Math.max(1, Math.floor((paths * this.#strips) / passPaths));
    // Whole blocks where there are some, so that no lane idles.
    const whole = wanted - (wanted % unitStrips);
    const endStrip = Math.min(whole > strip ? whole : wanted, this.#strips);
    const firstSample = this.#samples[half];
    const strips = { firstStrip: strip, endStrip, unitStrips, unitStride };
    return { half, firstSample, sampleCount, ...strips, paths: (passPaths * (endStrip - strip)) / this.#strips };
  }

  /** Takes note that a slice from `next` has been submitted. */
  finish(slice: Slice): void {
    if (!this.#pass) throw new RangeError("no pass is under way");
    this.#pass.strip = slice.endStrip;
    if (slice.endStrip < this.#strips) return;
    this.#samples[slice.half] += slice.sampleCount;
    this.#pass = undefined;
  }

  #open(paths: number, maxCount: number, remaining: number): Pass {
    const [first, second] = this.#samples;
    const half = first <= second ? 0 : 1;
    const wanted = half === 0 ? Math.ceil(remaining / 2) : Math.min(first - second, remaining);
    const sampleCount = Math.max(1, Math.min(maxCount, wanted));
    const unitStrips = paths < FEW_BLOCKS * BLOCK_SIDE ** 2 * sampleCount ? 1 : BLOCK_STRIPS;
    const isOneSlice = paths >= this.pixels * sampleCount;
    return {
      half,
      sampleCount,
      strip: 0,
      unitStrips,
      unitStride: isOneSlice ? 1 : strideFor(this.#strips / unitStrips),
    };
  }
}

/**
 * A step that visits each of `count` places once, modulo their number, and any few in a row at places far from each other:
 * near the golden ratio of them, and so that no product of a place and the step passes 32 bits.
 */
function strideFor(count: number): number {
  let stride = Math.max(1, Math.floor(Math.min(count * 0.618, (2 ** 32 - 1) / count)));
  while (greatestCommonDivisor(stride, count) > 1) stride--;
  return stride;
}

function greatestCommonDivisor(a: number, b: number): number {
  return b === 0 ? a : greatestCommonDivisor(b, a % b);
}
