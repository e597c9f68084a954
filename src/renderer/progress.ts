/** Rows of the film to which one dispatch adds `count` samples per pixel, from `firstSample` of the half on. */
export type Slice = {
  readonly half: 0 | 1;
  readonly firstSample: number;
  readonly count: number;
  readonly firstRow: number;
  readonly endRow: number;
};

/**
 * Which samples the film holds and which come next. Samples are taken in passes over the whole image, each for one half
 * of the film, the halves in turn so that they stay equally full; a pass is cut into slices of rows.
 */
export class Progress {
  readonly #height: number;
  readonly #samples: [number, number] = [0, 0];
  #pass: { readonly half: 0 | 1; readonly count: number; row: number } | undefined;

  constructor(height: number) {
    this.#height = height;
  }

  /** Samples per pixel in both halves together, complete passes only. */
  get samples(): number {
    return this.#samples[0] + this.#samples[1];
  }

  /** Whether no pass is under way and both halves hold equally many samples. */
  get isBalanced(): boolean {
    return this.#pass === undefined && this.#samples[0] === this.#samples[1];
  }

  /**
   * The next slice, of at most `rows` rows. Where it opens a pass, the pass takes as many samples as bring both halves
   * closer to `remaining` more in total, but at most `maxCount`.
   */
  next(rows: number, maxCount: number, remaining: number): Slice {
    const [first, second] = this.#samples;
    if (!this.#pass) {
      const half = first <= second ? 0 : 1;
      const wanted = half === 0 ? Math.ceil(remaining / 2) : Math.min(first - second, remaining);
      this.#pass = { half, count: Math.max(1, Math.min(maxCount, wanted)), row: 0 };
    }
    const { half, count, row } = this.#pass;
    const endRow = Math.min(row + rows, this.#height);
    return { half, firstSample: this.#samples[half], count, firstRow: row, endRow };
  }

  /** Takes note that a slice from `next` has been submitted. */
  finish(slice: Slice): void {
    if (!this.#pass) throw new RangeError("no pass is under way");
    this.#pass.row = slice.endRow;
    if (slice.endRow < this.#height) return;
    this.#samples[slice.half] += slice.count;
    this.#pass = undefined;
  }
}
