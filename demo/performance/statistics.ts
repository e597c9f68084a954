import type { Reference } from "./reference";

/** How wrong a picture was at some time. */
export type Point = {
  /** Per pixel. */
  readonly samples: number;
  /** On the estimator's own clock. */
  readonly seconds: number;
  /** Relative RMSE against the reference; undefined once it is below the reference's own. */
  readonly trueError: number | undefined;
  /** What the viewer believes it to be; undefined until it has an opinion. */
  readonly estimatedError: number | undefined;
};

/** A point whose true error is known. */
export type KnownPoint = Point & { readonly trueError: number };

/** Channels of a pixel in what `PathTracer.readRadiance` returns, and of those the ones that hold light. */
const STRIDE = 4;
const COLOURS = 3;

/**
 * Relative RMSE: sqrt(mean((I−R)²) − mean(SE²)) / mean(R), with the reference's own noise taken out.
 *
 * @param radiance - RGBA, top row first.
 * @returns undefined where the reference is noisier than the picture.
 */
export function trueError(
  radiance: ArrayLike<number>,
  { image, mean, meanSquaredNoise, ownError }: Reference,
): number | undefined {
  let sum = 0;
  for (let i = 0; i < image.length; i++) {
    const pixel = Math.floor(i / COLOURS);
    sum += (radiance[pixel * STRIDE + (i % COLOURS)]! - image[i]!) ** 2;
  }
  const error = Math.sqrt(Math.max(sum / image.length - meanSquaredNoise, 0)) / mean;
  return error > ownError ? error : undefined;
}

/** Relative RMSE of either of two independent pictures of the same, from how much they differ. RGBA both. */
export function errorOfPair(first: ArrayLike<number>, second: ArrayLike<number>): number {
  let squares = 0;
  let light = 0;
  for (let i = 0; i < first.length; i++) {
    if (i % STRIDE === COLOURS) continue;
    squares += (first[i]! - second[i]!) ** 2;
    light += first[i]! + second[i]!;
  }
  const values = (first.length / STRIDE) * COLOURS;
  return Math.sqrt(squares / 2 / values) / (light / 2 / values);
}

/** The newest point with a known true error. */
export function lastKnown(points: readonly Point[]): KnownPoint | undefined {
  return points.findLast(isKnown);
}

export function isKnown(point: Point): point is KnownPoint {
  return point.trueError !== undefined;
}

/** 1 / (relative MSE · seconds): it stays the same while more samples are taken, if the error falls as they should make it. */
export function efficiency({ trueError, seconds }: KnownPoint): number {
  return 1 / (trueError ** 2 * seconds);
}

/** When a curve first came down to an error. */
export type Arrival = {
  readonly seconds: number;
  /** The curve began below the error: it may have been there sooner. */
  readonly isLatest: boolean;
};

/** Reads off a curve, straight between its points in a log-log plot, when it came down to `error`. */
export function timeToReach(error: number, points: readonly Point[]): Arrival | undefined {
  const known = points.filter(isKnown);
  const index = known.findIndex((point) => point.trueError <= error);
  const after = known[index];
  if (after === undefined) return undefined;
  const before = known[index - 1];
  if (before === undefined) return { seconds: after.seconds, isLatest: after.trueError < error };
  const share = Math.log(before.trueError / error) / Math.log(before.trueError / after.trueError);
  return { seconds: before.seconds * (after.seconds / before.seconds) ** share, isLatest: false };
}

/** One estimator's lead over another. */
export type Lead = {
  /** Both came down to this error … */
  readonly error: number;
  /** … the one then, */
  readonly sooner: number;
  /** the other then, in seconds. */
  readonly later: number;
  /** The lead is at least this many times; exactly, unless `isLatest` was so. */
  readonly factor: number;
  readonly isAtLeast: boolean;
};

/**
 * How much sooner `ahead` came down to the least error that `behind` has had; undefined if it has not come down to it. Not to
 * the error it has now: that can have risen again, with the first find of a light that was missing from the picture.
 */
export function leadOf(ahead: readonly Point[], behind: readonly Point[]): Lead | undefined {
  const known = behind.filter(isKnown);
  if (known.length === 0) return undefined;
  const best = known.reduce((a, b) => (b.trueError < a.trueError ? b : a));
  const arrival = timeToReach(best.trueError, ahead);
  if (arrival === undefined) return undefined;
  return {
    error: best.trueError,
    sooner: arrival.seconds,
    later: best.seconds,
    factor: best.seconds / arrival.seconds,
    isAtLeast: arrival.isLatest,
  };
}
