import type { CanvasView } from "./canvasView";
import type { ProgressDetail, ReadyDetail } from "./events";

/** Whom the milestones are told. */
export type MilestoneListener = {
  readonly onReady: (detail: ReadyDetail) => void;
  readonly onProgress: (detail: ProgressDetail) => void;
  readonly onConverged: (detail: ProgressDetail) => void;
  /** Asked whether the picture rests because somebody said so: then it is not finished. */
  readonly isPaused: () => boolean;
};

const PROGRESS_INTERVAL_MS = 100;

/** Tells how far a picture is: when it is first seen, when it has more samples, and when it is as good as it was to be. */
export class Milestones {
  readonly #listener: MilestoneListener;
  /** When the scene was asked for whose first picture is still to come. */
  #requestedAt: number | undefined;
  /** Whether anything was drawn since. */
  #hasDrawn = false;
  #reportedAt = Number.NEGATIVE_INFINITY;
  #reportedSamples = 0;
  #wasConverged = false;

  constructor(listener: MilestoneListener) {
    this.#listener = listener;
  }

  /** Whether a scene is there that has not been seen yet. */
  get owesPicture(): boolean {
    return this.#requestedAt !== undefined;
  }

  /**
   * A scene is there; its first picture is to come.
   *
   * @param requestedAt - when it was asked for, as of `performance.now()`.
   */
  expectPicture(requestedAt: number): void {
    this.#requestedAt = requestedAt;
    this.#hasDrawn = false;
  }

  /** The canvas shows something new. */
  noteDrawn(): void {
    this.#hasDrawn = true;
  }

  /** There is no picture any more. */
  forget(): void {
    this.#requestedAt = undefined;
    this.#reportedSamples = 0;
    this.#wasConverged = false;
  }

  /** Tells what is new. To be called every frame. */
  report({ tracer, isFullSize }: Pick<CanvasView, "tracer" | "isFullSize">): void {
    const { samples, error, converged } = tracer.stats;
    const now = performance.now();
    if (this.#hasDrawn && samples > 0 && this.#requestedAt !== undefined) {
      const milliseconds = now - this.#requestedAt;
      this.#requestedAt = undefined;
      this.#reportedSamples = 0;
      this.#listener.onReady({ tracer, milliseconds });
    }
    if (this.owesPicture) return;
    const isDue = now - this.#reportedAt >= PROGRESS_INTERVAL_MS || converged;
    if (samples !== this.#reportedSamples && isDue) {
      this.#reportedAt = now;
      this.#reportedSamples = samples;
      if (samples > 0) this.#listener.onProgress({ samples, error });
    }
    const hasConverged = converged && isFullSize && !this.#listener.isPaused();
    if (hasConverged && !this.#wasConverged) this.#listener.onConverged({ samples, error });
    this.#wasConverged = hasConverged;
  }
}
