// How wrong images are. An image is RGB, top row first; errors are taken over all pixels and channels.

/** A relative mean squared error. */
export type NoiseFigure = {
  readonly relMse: number;
  /** Its standard error, as a share of it; from the spread between pixels. */
  readonly uncertainty: number;
};

/**
 * The noise of one image, from two of different seeds: mean((a − b)²)/2 / mean((a + b)/2)². Low-discrepancy points are no
 * obstacle, for the two images are independent whatever the points within each.
 */
export function noise(a: Float32Array, b: Float32Array): NoiseFigure {
  const squares = perPixel(a, (i) => (a[i]! - b[i]!) ** 2 / 2);
  const { mean, standardError } = meanOf(squares);
  return {
    relMse: mean / ((meanValue(a) + meanValue(b)) / 2) ** 2,
    uncertainty: mean === 0 ? 0 : standardError / mean,
  };
}

/** Of one scene, by someone else. */
export type ReferenceImage = {
  readonly image: Float32Array;
  /** Of every value of `image`. */
  readonly standardError: Float32Array;
};

export type ExcessFigure = {
  /** Relative RMS difference from the reference beyond the noise of both; 0 where there is less than their noise. */
  readonly excess: number;
  /** The squared excess in its own standard errors: up to 3 or so is chance. */
  readonly sigmas: number;
  /** What the excess may be at most, to two standard errors. */
  readonly bound: number;
};

/**
 * How far the mean of two images is from the reference, once the noise of both has been taken off.
 *
 * @param a - of one size with `b` and the reference.
 */
export function excess(a: Float32Array, b: Float32Array, { image, standardError }: ReferenceImage): ExcessFigure {
  // The mean of two has the variance (a − b)²/4, in expectation.
  const squares = perPixel(
    a,
    (i) => ((a[i]! + b[i]!) / 2 - image[i]!) ** 2 - (a[i]! - b[i]!) ** 2 / 4 - standardError[i]! ** 2,
  );
  const { mean, standardError: error } = meanOf(squares);
  return {
    excess: Math.sqrt(Math.max(mean, 0)) / meanValue(image),
    sigmas: error === 0 ? 0 : mean / error,
    bound: Math.sqrt(Math.max(mean, 0) + 2 * error) / meanValue(image),
  };
}

/** Relative RMSE against the reference, less what the reference's own noise contributes. */
export function trueError(a: Float32Array, { image, standardError }: ReferenceImage): number {
  const { mean } = meanOf(perPixel(a, (i) => (a[i]! - image[i]!) ** 2 - standardError[i]! ** 2));
  return Math.sqrt(Math.max(mean, 0)) / meanValue(image);
}

/** Half the size, each pixel the mean of four. @param height - even, as `width`. */
export function halve(image: Float32Array, width: number, height: number): Float32Array {
  const half = new Float32Array(image.length / 4);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      for (let c = 0; c < 3; c++) {
        half[3 * ((y >> 1) * (width / 2) + (x >> 1)) + c]! += image[3 * (y * width + x) + c]! / 4;
      }
    }
  }
  return half;
}

/** What a renderer gives for its time: 1/(relMSE · seconds). Twice the speed and half the squared error count the same. */
export function efficiency(relMse: number, seconds: number): number {
  return 1 / (relMse * seconds);
}

export function median(values: readonly number[]): number {
  const sorted = [...values].sort((a, b) => a - b);
  const middle = sorted.length / 2;
  return (sorted[Math.ceil(middle) - 1]! + sorted[Math.floor(middle)]!) / 2;
}

/** Of positive values. */
export function geometricMean(values: readonly number[]): number {
  return Math.exp(values.reduce((sum, value) => sum + Math.log(value), 0) / values.length);
}

/** The mean over channels of `value(i)`, per pixel: channels of a pixel share their noise, so they count as one. */
function perPixel(image: Float32Array, value: (i: number) => number): Float64Array {
  return Float64Array.from(
    { length: image.length / 3 },
    (_, p) => (value(3 * p) + value(3 * p + 1) + value(3 * p + 2)) / 3,
  );
}

function meanOf(values: Float64Array): { mean: number; standardError: number } {
  const mean = meanValue(values);
  let squares = 0;
  for (const value of values) squares += (value - mean) ** 2;
  return { mean, standardError: Math.sqrt(squares / (values.length * Math.max(values.length - 1, 1))) };
}

function meanValue(values: Float32Array | Float64Array): number {
  let sum = 0;
  for (const value of values) sum += value;
  return sum / values.length;
}
