import type { Slice } from "./progress";

// Until something has been measured, small enough not to freeze the slowest adapter.
const FIRST_PATHS = 8192;
// Rows of a workgroup: slices end on them, so that no lane idles.
const ROW_STEP = 8;
// Weight of the newest measurement.
const BLEND = 0.3;

/** Learns how fast the adapter traces and sizes work to a time budget. */
export class Pace {
  #msPerPath: number | undefined;

  /** Rows that fit `budgetMs` at `count` samples per pixel, at least one workgroup's. */
  rowsFor(budgetMs: number, width: number, count: number): number {
    const paths = this.#msPerPath === undefined ? FIRST_PATHS : budgetMs / this.#msPerPath;
    return Math.max(ROW_STEP, Math.floor(paths / (width * count) / ROW_STEP) * ROW_STEP);
  }

  /** Milliseconds the slice is likely to take; 0 while nothing is known. */
  predictMs(slice: Slice, width: number): number {
    return (this.#msPerPath ?? 0) * pathsOf(slice, width);
  }

  observe(slice: Slice, width: number, ms: number): void {
    const msPerPath = ms / pathsOf(slice, width);
    this.#msPerPath = this.#msPerPath === undefined ? msPerPath : lerp(this.#msPerPath, msPerPath, BLEND);
  }
}

export function pathsOf(slice: Slice, width: number): number {
  return width * (slice.endRow - slice.firstRow) * slice.count;
}

function lerp(a: number, b: number, t: number): number {
  return a + (b - a) * t;
}
