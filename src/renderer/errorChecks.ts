// Milliseconds between two estimates of the error.
const INTERVAL_MS = 200;
// A picture that is to stop at some error is estimated again with this many times the samples, and gets no more than that before
// the estimate is known. Its square is less than 2: no picture gets twice the samples that would have been enough, however fast
// the adapter is.
const GROWTH = 1.4;
// The fewest samples that have an error: one in each half.
const FEWEST = 2;

/** Decides with which work the error is estimated, and how far a picture may run ahead of its estimate. */
export class ErrorChecks {
  #askedAt = Number.NEGATIVE_INFINITY;
  /** Samples per pixel of the last estimate, and of the last one that is known. */
  #asked = 0;
  #known = 0;

  /** Samples per pixel that a picture of `samples` may have before the next estimate is known. */
  allowedSamples(samples: number, targetError: number): number {
    if (targetError === 0) return Number.POSITIVE_INFINITY;
    const most = Math.floor(GROWTH * this.#asked);
    return this.#isPending ? most : Math.max(most, samples + FEWEST);
  }

  /** Whether work after which the film holds `samples` per pixel should estimate the error; takes note if so. */
  ask(samples: number, targetError: number, isLast: boolean, nowMs: number): boolean {
    const isGrown = targetError > 0 && !this.#isPending && samples >= GROWTH * this.#known;
    const isDue = isLast || isGrown || nowMs - this.#askedAt > INTERVAL_MS;
    if (samples < FEWEST || samples === this.#asked || !isDue) return false;
    this.#askedAt = nowMs;
    this.#asked = samples;
    return true;
  }

  /** The estimate that was asked for at so many samples is known. */
  report(samples: number): void {
    this.#known = samples;
  }

  get #isPending(): boolean {
    return this.#asked !== this.#known;
  }
}
