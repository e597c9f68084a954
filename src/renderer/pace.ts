// Of the past, what still counts after one more measurement, so that one stutter changes little.
const KEPT = 0.7;
// A few strips tell little of a picture, many tell all of it: the next work is at most this many times what was measured, or
// its square by this many paths, whichever is more.
const GROWTH = 16;
const TELLING_PATHS = 64;

// Samples per pixel in one dispatch. More gain little, and would add up too many samples before the film keeps what f32 loses.
const MOST_SAMPLES = 32;
// Pixels that the first work should have, rather than more samples of fewer.
const FIRST_PIXELS = 256;

/** Learns how fast the adapter traces and sizes work to a time budget. */
export class Pace {
  readonly #firstPaths: number;
  #ms = 0;
  #paths = 0;
  #mostPaths = 0;

  /** @param firstPaths - how many paths one may dare before anything has been measured. */
  constructor(firstPaths: number) {
    this.#firstPaths = firstPaths;
  }

  /**
   * Samples per pixel in one dispatch while nobody watches. Whatever is measured, one scene has the same: samples that are added
   * up in the same groups give the same picture to the last bit.
   */
  get dispatchSamples(): number {
    return Math.max(1, Math.min(MOST_SAMPLES, Math.floor(this.#firstPaths / FIRST_PIXELS)));
  }

  /** Whether anything has been measured. */
  get isKnown(): boolean {
    return this.#paths > 0;
  }

  /** Paths that are likely to fit `budgetMs`. */
  pathsFor(budgetMs: number): number {
    if (!this.isKnown) return this.#firstPaths;
    const most = this.#mostPaths * Math.max(GROWTH, this.#mostPaths / TELLING_PATHS);
    return Math.min((budgetMs * this.#paths) / this.#ms, most);
  }

  /** Milliseconds that so many paths are likely to take; 0 while nothing is known. */
  predictMs(paths: number): number {
    return this.isKnown ? (paths * this.#ms) / this.#paths : 0;
  }

  /** Takes note that so many paths took `ms` > 0. Larger work says more than small work, which starting it makes slow. */
  observe(paths: number, ms: number): void {
    this.#ms = KEPT * this.#ms + ms;
    this.#paths = KEPT * this.#paths + paths;
    this.#mostPaths = Math.max(this.#mostPaths, paths);
  }
}
