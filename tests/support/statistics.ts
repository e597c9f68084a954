// Is an image what it should be, given the noise of both?
//
// [1] Mitsuba 3, src/tests/test_renders.py: per-value z-test, Šidák-corrected
// [2] Wichura 1988, "Algorithm AS 241: The Percentage Points of the Normal Distribution"

/** Means over independent renders. RGB, top row first, `3 · width · height` values. */
export type MeasuredImage = {
  readonly width: number;
  readonly height: number;
  /** Per pixel, in all renders together. */
  readonly samples: number;
  readonly mean: Float64Array;
  /** Variance of every value of `mean`, estimated from the spread of the renders. */
  readonly variance: Float64Array;
};

/** What an image should show; RGB, top row first. */
export type ExpectedImage = {
  readonly image: ArrayLike<number>;
  /** Of every value of `image`. */
  readonly standardError: ArrayLike<number>;
  /** Samples per pixel behind `image`; `Infinity` for a closed form. */
  readonly samples: number;
  /** How far every value of `image` may be off for reasons that are no noise, as a share of it. */
  readonly bias: ArrayLike<number>;
};

export type Verdict = {
  /** Share of the pixels all of whose channels pass the z-test. */
  readonly pixelShare: number;
  /** Share of the 8×8 blocks all of whose channels' means pass. */
  readonly blockShare: number;
  /** Difference of the image means per channel beyond rounding and `bias`, in standard errors. */
  readonly meanSigmas: readonly [number, number, number];
  /** Largest relative standard error of a channel's mean. */
  readonly meanError: number;
};

// Probability with which a correct renderer may fail, over all pixels or blocks of one image. [1]
const SIGNIFICANCE = 0.01;
const BLOCK = 8;
// Relative error of a mean that is rounding: the film adds n ≤ 512 non-negative f32 samples one after the other, and
// each addition may be off by 2⁻²³ of the sum, for f32 additions may round either way (design §5).
export const ROUNDING = 512 * 2 ** -23;

/** @param renders - RGBA images of one scene with different seeds, at least two, of `samples` samples each. */
export function measure(
  renders: readonly Float32Array[],
  width: number,
  height: number,
  samples: number,
): MeasuredImage {
  const mean = new Float64Array(3 * width * height);
  const variance = new Float64Array(mean.length);
  const k = renders.length;
  for (let i = 0; i < mean.length; i++) {
    const at = 4 * Math.floor(i / 3) + (i % 3);
    let sum = 0;
    for (const render of renders) sum += render[at]!;
    let squares = 0;
    for (const render of renders) squares += (render[at]! - sum / k) ** 2;
    mean[i] = sum / k;
    variance[i] = squares / ((k - 1) * k);
  }
  return { width, height, samples: k * samples, mean, variance };
}

/**
 * Compares an image with what it should be: pixel by pixel, in blocks of 8×8, and as a whole.
 *
 * The variance estimated from a handful of renders fails where light comes in rare bright samples: all renders may have
 * missed it, and agree on a wrong value. So pixels and blocks are given, as in [1], the variance of as many samples of the
 * reference renderer where it is the larger; and a pixel that of its surroundings, which has nine times the degrees of
 * freedom of its own. All of this errs towards accepting. The mean of the image does without: pixels are independent, so
 * that its variance is the sum of theirs, unbiased and known to a per cent or so.
 */
export function judge(measured: MeasuredImage, expected: ExpectedImage): Verdict {
  const { width, height } = measured;
  return {
    pixelShare: pixelShare(measured, expected),
    blockShare: blockShare(measured, expected),
    ...judgeRegion(measured, expected, 0, 0, width, height),
  };
}

/** An image that shows the same colour everywhere, exactly. */
export function constantImage(width: number, height: number, rgb: readonly [number, number, number]): ExpectedImage {
  const count = 3 * width * height;
  const exact = new Float64Array(count);
  const image = Float64Array.from({ length: count }, (_, i) => rgb[i % 3]!);
  return { image, standardError: exact, samples: Number.POSITIVE_INFINITY, bias: exact };
}

function pixelShare(measured: MeasuredImage, expected: ExpectedImage): number {
  const { width, height, mean, variance } = measured;
  const threshold = sidakThreshold(SIGNIFICANCE, mean.length);
  let passed = 0;
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const passes = [0, 1, 2].every((c) => {
        const i = 3 * (y * width + x) + c;
        const error = expected.standardError[i]!;
        const own = Math.max(variance[i]!, pooledVariance(measured, x, y, c), referenceVariance(measured, expected, i));
        const allowed =
          threshold * Math.sqrt(own + error ** 2) + (ROUNDING + expected.bias[i]!) * Math.abs(expected.image[i]!);
        return Math.abs(mean[i]! - expected.image[i]!) <= allowed;
      });
      if (passes) passed++;
    }
  }
  return passed / (width * height);
}

/** Mean variance of a channel over a pixel and its neighbours. */
function pooledVariance({ width, height, variance }: MeasuredImage, x: number, y: number, c: number): number {
  let sum = 0;
  let count = 0;
  for (let v = Math.max(y - 1, 0); v <= Math.min(y + 1, height - 1); v++) {
    for (let u = Math.max(x - 1, 0); u <= Math.min(x + 1, width - 1); u++) {
      sum += variance[3 * (v * width + u) + c]!;
      count++;
    }
  }
  return sum / count;
}

/** Of as many samples of the reference renderer as `measured` holds; 0 for a closed form. */
function referenceVariance({ samples }: MeasuredImage, expected: ExpectedImage, i: number): number {
  const variance = expected.standardError[i]! ** 2;
  return variance === 0 ? 0 : (variance * expected.samples) / samples;
}

function blockShare(measured: MeasuredImage, expected: ExpectedImage): number {
  const { width, height } = measured;
  const variance = measured.variance.map((own, i) => Math.max(own, referenceVariance(measured, expected, i)));
  const cautious = { ...measured, variance };
  const blocks = Math.ceil(width / BLOCK) * Math.ceil(height / BLOCK);
  const threshold = sidakThreshold(SIGNIFICANCE, 3 * blocks);
  let passed = 0;
  for (let y = 0; y < height; y += BLOCK) {
    for (let x = 0; x < width; x += BLOCK) {
      const { meanSigmas } = judgeRegion(cautious, expected, x, y, x + BLOCK, y + BLOCK);
      if (meanSigmas.every((sigmas) => Math.abs(sigmas) <= threshold)) passed++;
    }
  }
  return passed / blocks;
}

function judgeRegion(
  { width, height, mean, variance }: MeasuredImage,
  { image, standardError, bias }: ExpectedImage,
  left: number,
  top: number,
  right: number,
  bottom: number,
): Pick<Verdict, "meanSigmas" | "meanError"> {
  const ours = [0, 0, 0];
  const theirs = [0, 0, 0];
  const variances = [0, 0, 0];
  const allowed = [0, 0, 0];
  for (let y = top; y < Math.min(bottom, height); y++) {
    for (let x = left; x < Math.min(right, width); x++) {
      for (let c = 0; c < 3; c++) {
        const i = 3 * (y * width + x) + c;
        ours[c]! += mean[i]!;
        theirs[c]! += image[i]!;
        variances[c]! += variance[i]! + standardError[i]! ** 2;
        allowed[c]! += (ROUNDING + bias[i]!) * Math.abs(image[i]!);
      }
    }
  }
  const sigmas = [0, 1, 2].map((c) => {
    const difference = ours[c]! - theirs[c]!;
    const beyond = Math.max(Math.abs(difference) - allowed[c]!, 0);
    return beyond === 0 ? 0 : (Math.sign(difference) * beyond) / Math.sqrt(variances[c]!);
  });
  const errors = [0, 1, 2].map((c) => (ours[c] === 0 ? 0 : Math.sqrt(variances[c]!) / Math.abs(ours[c]!)));
  return { meanSigmas: sigmas as [number, number, number], meanError: Math.max(...errors) };
}

/**
 * Mean and standard error of one channel over all pixels of an image whose pixels all see the same: each is an
 * independent measurement, so their spread tells the error.
 */
export function measurePoint(image: Float32Array, channel = 0): { mean: number; standardError: number } {
  const count = image.length / 4;
  let sum = 0;
  for (let i = 0; i < count; i++) sum += image[4 * i + channel]!;
  const mean = sum / count;
  let squares = 0;
  for (let i = 0; i < count; i++) squares += (image[4 * i + channel]! - mean) ** 2;
  return { mean, standardError: Math.sqrt(squares / ((count - 1) * count)) };
}

/** The z beyond which one of `count` correct, independent values lies with probability `significance`. [1] */
export function sidakThreshold(significance: number, count: number): number {
  // 1 − (1 − α)^(1/n) without its cancellation; two-sided.
  const level = -Math.expm1(Math.log1p(-significance) / count);
  return -normalQuantile(level / 2);
}

/** Inverse of the normal distribution function, to 1e-15. [2] PPND16 */
export function normalQuantile(p: number): number {
  const q = p - 0.5;
  if (Math.abs(q) <= 0.425) {
    const r = 0.180625 - q * q;
    return (q * polynomial(CENTRAL[0], r)) / polynomial(CENTRAL[1], r);
  }
  const r = Math.sqrt(-Math.log(Math.min(p, 1 - p)));
  const [[numerator, denominator], at] = r <= 5 ? [MIDDLE, r - 1.6] : [TAIL, r - 5];
  return Math.sign(q) * (polynomial(numerator, at) / polynomial(denominator, at));
}

/** Highest power first. */
function polynomial(coefficients: readonly number[], x: number): number {
  return coefficients.reduce((sum, coefficient) => sum * x + coefficient, 0);
}

type Fraction = readonly [numerator: readonly number[], denominator: readonly number[]];

// biome-ignore-start lint/correctness/noPrecisionLoss: as printed
const CENTRAL: Fraction = [
  [
    2509.0809287301226727, 33430.575583588128105, 67265.770927008700853, 45921.953931549871457, 13731.693765509461125,
    1971.5909503065514427, 133.14166789178437745, 3.387132872796366608,
  ],
  [
    5226.495278852545925, 28729.085735721942674, 39307.89580009271061, 21213.794301586595867, 5394.1960214247511077,
    687.1870074920579083, 42.313330701600911252, 1,
  ],
];
const MIDDLE: Fraction = [
  [
    7.7454501427834140764e-4, 0.0227238449892691845833, 0.24178072517745061177, 1.27045825245236838258,
    3.64784832476320460504, 5.7694972214606914055, 4.6303378461565452959, 1.42343711074968357734,
  ],
  [
    1.05075007164441684324e-9, 5.475938084995344946e-4, 0.0151986665636164571966, 0.14810397642748007459,
    0.68976733498510000455, 1.6763848301838038494, 2.05319162663775882187, 1,
  ],
];
const TAIL: Fraction = [
  [
    2.01033439929228813265e-7, 2.71155556874348757815e-5, 0.0012426609473880784386, 0.026532189526576123093,
    0.29656057182850489123, 1.7848265399172913358, 5.4637849111641143699, 6.6579046435011037772,
  ],
  [
    2.04426310338993978564e-15, 1.4215117583164458887e-7, 1.8463183175100546818e-5, 7.868691311456132591e-4,
    0.0148753612908506148525, 0.13692988092273580531, 0.59983220655588793769, 1,
  ],
];
// biome-ignore-end lint/correctness/noPrecisionLoss: as printed
