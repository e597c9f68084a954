/**
 * The course of a figure in a fixed number of points. Times are in whatever unit the caller likes and never go back.
 */
export interface History {
  /** Oldest first. */
  readonly values: readonly number[];
  add(time: number, value: number): void;
  clear(): void;
}

/** The latest points only: a strip that moves on. */
export class RecentHistory implements History {
  readonly #capacity: number;
  #values: number[] = [];

  constructor(capacity: number) {
    this.#capacity = capacity;
  }

  get values(): readonly number[] {
    return this.#values;
  }

  add(_time: number, value: number): void {
    this.#values.push(value);
    if (this.#values.length > this.#capacity) this.#values.shift();
  }

  clear(): void {
    this.#values = [];
  }
}

/** All of it from the start: whenever the points are used up, every second one is dropped and the step doubles. */
export class WholeHistory implements History {
  readonly #capacity: number;
  readonly #firstStep: number;
  #step: number;
  #start: number | undefined;
  #values: number[] = [];

  /**
   * @param capacity - how many points are kept at most; even.
   * @param step - the time between two points to begin with.
   */
  constructor(capacity: number, step: number) {
    this.#capacity = capacity;
    this.#firstStep = step;
    this.#step = step;
  }

  get values(): readonly number[] {
    return this.#values;
  }

  /** Takes the value if the next point is due by then. */
  add(time: number, value: number): void {
    this.#start ??= time;
    if (time - this.#start < this.#values.length * this.#step) return;
    this.#values.push(value);
    if (this.#values.length < this.#capacity) return;
    this.#values = this.#values.filter((_, index) => index % 2 === 0);
    this.#step *= 2;
  }

  clear(): void {
    this.#values = [];
    this.#start = undefined;
    this.#step = this.#firstStep;
  }
}
