// Seconds over which rates are smoothed.
const WINDOW_S = 1;

/** A rate of events, averaged over about the last second: what happened over how long it took, older parts weighing less. */
export class Rate {
  #count = 0;
  #seconds = 0;

  /** Events per second; 0 before the first measurement. */
  get perSecond(): number {
    return this.#seconds === 0 ? 0 : this.#count / this.#seconds;
  }

  /** Takes note of `count` events in the last `seconds`. */
  observe(count: number, seconds: number): void {
    if (seconds <= 0) return;
    const kept = Math.exp(-seconds / WINDOW_S);
    this.#count = kept * this.#count + count;
    this.#seconds = kept * this.#seconds + seconds;
  }
}
