/** A moment of an accumulation. */
export type CoursePoint = {
  /** Since it began; > 0. */
  readonly seconds: number;
  /** Relative. */
  readonly error: number;
};

// Between a point and the next but one: 150 points go from a tenth of a second to a day and more.
const RATIO = 1.1;

/** The error against the time it took, at points about equidistant in the logarithm of time, and now. */
export class ErrorCourse {
  #points: CoursePoint[] = [];

  /** The earliest first. */
  get points(): readonly CoursePoint[] {
    return this.#points;
  }

  /** Takes note of the error as it is; `Infinity` while it is not known. Time that went back began anew. */
  observe({ seconds, error }: CoursePoint): void {
    if (seconds < (this.#points.at(-1)?.seconds ?? 0)) this.#points = [];
    if (!(seconds > 0 && error > 0 && error < Number.POSITIVE_INFINITY)) return;
    if (error === this.#points.at(-1)?.error) return; // no new estimate
    const kept = this.#points.at(-2);
    if (kept !== undefined && seconds < RATIO * kept.seconds) this.#points.pop();
    this.#points.push({ seconds, error });
  }
}
