// Seconds over which rates are smoothed.
const WINDOW_S = 1;

/** A rate of events, averaged over about the last second. */
export class Rate {
  #perSecond = 0;

  /** Events per second; 0 before the first measurement. */
  get perSecond(): number {
    return this.#perSecond;
  }

  /** Takes note of `count` events in the last `seconds`. */
  observe(count: number, seconds: number): void {
    if (seconds <= 0) return;
    const weight = this.#perSecond === 0 ? 1 : 1 - Math.exp(-seconds / WINDOW_S);
    this.#perSecond += (count / seconds - this.#perSecond) * weight;
  }
}
