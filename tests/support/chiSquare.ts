// Do samples follow their density?
//
// [1] Pharr, Jakob, Humphreys 2016, "Physically Based Rendering", 3rd ed., section 14.1.3, and pbrt's bsdfs_test.cpp
// [2] Press et al. 2007, "Numerical Recipes", 3rd ed., section 6.2

/** Bins that expect fewer samples are counted together: the χ² distribution is a limit for many per bin. [1] */
const MIN_EXPECTED = 5;

/** A share of the samples that bins may hold although they expect none: quadrature misses slivers of a cut bin. [1] */
const SLIVER = 1e-4;

/**
 * The probability that samples of the expected distribution deviate from it as far as these do, or further.
 *
 * @param sliver - the share of the samples that bins may hold although they expect none; more of them makes 0.
 */
export function chiSquareTest(observed: ArrayLike<number>, expected: ArrayLike<number>, sliver = SLIVER): number {
  const order = Array.from(expected, (_, i) => i).sort((a, b) => expected[a]! - expected[b]!);
  const sampleCount = Array.from(observed).reduce((sum, count) => sum + count, 0);
  let chi2 = 0;
  let bins = 0;
  let [pooledObserved, pooledExpected] = [0, 0];
  for (const i of order) {
    pooledObserved += observed[i]!;
    pooledExpected += expected[i]!;
    if (pooledExpected === 0 && pooledObserved > sliver * sampleCount) return 0;
    if (pooledExpected < MIN_EXPECTED) continue;
    chi2 += (pooledObserved - pooledExpected) ** 2 / pooledExpected;
    bins++;
    [pooledObserved, pooledExpected] = [0, 0];
  }
  return regularizedGammaQ((bins - 1) / 2, chi2 / 2);
}

/** The level at which each of `count` tests is made so that all of them together fail by chance with `significance`. */
export function sidakLevel(significance: number, count: number): number {
  return -Math.expm1(Math.log1p(-significance) / count);
}

/** Q(a, x) = Γ(a, x) / Γ(a), by series below a + 1 and by continued fraction above. [2] */
export function regularizedGammaQ(a: number, x: number): number {
  if (x <= 0) return 1;
  const scale = Math.exp(a * Math.log(x) - x - logGamma(a));
  if (x < a + 1) {
    let term = 1 / a;
    let sum = term;
    for (let n = a + 1; term > sum * 1e-16; n++) {
      term *= x / n;
      sum += term;
    }
    return 1 - sum * scale;
  }
  // Lentz's method. [2] section 5.2
  let b = x + 1 - a;
  let c = 1e300;
  let d = 1 / b;
  let h = d;
  for (let i = 1, change = 0; Math.abs(change - 1) > 1e-15; i++) {
    const numerator = -i * (i - a);
    b += 2;
    d = 1 / (numerator * d + b);
    c = b + numerator / c;
    change = d * c;
    h *= change;
  }
  return scale * h;
}

/** Stirling's series, shifted to where it has 15 digits. */
function logGamma(a: number): number {
  let shift = 0;
  let z = a;
  for (; z < 15; z++) shift -= Math.log(z);
  const series = 1 / (12 * z) - 1 / (360 * z ** 3) + 1 / (1260 * z ** 5) - 1 / (1680 * z ** 7);
  return shift + (z - 0.5) * Math.log(z) - z + 0.5 * Math.log(2 * Math.PI) + series;
}
