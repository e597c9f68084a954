import type { PixelSize } from "./canvasSize";

// 60 frames per second, on faster displays too.
const TARGET_FRAME_MS = 1000 / 60;
// Of a frame, what a pass may take before it has to shrink: more does not fit in one of the tracer's submits (12 ms) with
// something in hand for a pace that varies. The rest of the frame is for showing the picture.
const MAX_PASS_MS = 0.66 * TARGET_FRAME_MS;
// What a pass is sized to, a quarter below, and under which it grows again, so that a varying pace does not resize the
// film over and over.
const WANTED_PASS_MS = 0.5 * TARGET_FRAME_MS;
const MIN_PASS_MS = 0.375 * TARGET_FRAME_MS;
// Less than this shows too little: of either side, and of the shorter side in pixels.
const MIN_SCALE = 1 / 8;
const MIN_SIDE = 64;
// Without a change for this long, in milliseconds, the picture rests. Longer than the pauses between a mouse's events.
const REST_MS = 200;

/**
 * Decides how much of a picture is rendered, so that a camera that moves from frame to frame is seen with each frame: while
 * the picture moves, no more than the adapter does in one frame; at rest, all of it.
 */
export class FrameBudget {
  #changedAt = Number.NEGATIVE_INFINITY;
  #isRepeated = false;

  /** Takes note that another picture is wanted from now on. A single change is no movement yet. */
  noteChange(nowMs: number): void {
    this.#isRepeated = nowMs - this.#changedAt < REST_MS;
    this.#changedAt = nowMs;
  }

  /**
   * The size of the film.
   *
   * @param full - of the picture at rest.
   * @param film - the film's size now; it is kept if it does.
   * @param pathsPerSecond - how fast the adapter is; 0 while unknown.
   */
  sizeFor(full: PixelSize, film: PixelSize, pathsPerSecond: number, nowMs: number): PixelSize {
    const isMoving = this.#isRepeated && nowMs - this.#changedAt < REST_MS;
    return isMoving && pathsPerSecond > 0 ? affordableSize(full, film, pathsPerSecond) : full;
  }
}

/** The size of which a sample of every pixel fits a frame. */
export function affordableSize(full: PixelSize, film: PixelSize, pathsPerSecond: number): PixelSize {
  const msOf = ({ width, height }: PixelSize) => (1000 * width * height) / pathsPerSecond;
  const now = scaled(full, film.height / full.height);
  const isKept = now.width === film.width && msOf(now) >= MIN_PASS_MS && msOf(now) <= MAX_PASS_MS;
  return isKept ? now : scaled(full, Math.sqrt(WANTED_PASS_MS / msOf(full)));
}

/** The height is rounded first and the width follows it, so that the proportions are off by half a pixel at most. */
function scaled({ width, height }: PixelSize, scale: number): PixelSize {
  const least = Math.max(MIN_SCALE, MIN_SIDE / Math.min(width, height));
  const rows = Math.max(1, Math.round(height * Math.min(1, Math.max(scale, least))));
  return { width: Math.max(1, Math.round((rows * width) / height)), height: rows };
}
