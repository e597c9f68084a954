import { describe, expect, test } from "vitest";
import { renderSeeds, seedsFrom } from "../support/device";
import {
  ANALYTIC_NAMES,
  loadReference,
  REFERENCE_NAMES,
  type Reference,
  SURFACE_REFERENCE_NAMES,
} from "../support/reference";
import { judge, measure } from "../support/statistics";

// Eight independent renders of 32 samples: together 256 samples per pixel, and a measured variance for each value.
const SEEDS = seedsFrom(1, 8);
const SAMPLES = 32;

// How far the viewer's estimate of its error may be off.
const HONESTY = 1.1;

// The default estimator with values as constants, as a resting scene is rendered; the other with values in the uniform, as
// an edited one is. `constants.test.ts` holds the two kinds of program together.
const CASES = [
  ...[...REFERENCE_NAMES, ...SURFACE_REFERENCE_NAMES].map(
    (name) => ({ name, estimator: "path", sampler: "sobol" }) as const,
  ),
  ...ANALYTIC_NAMES.map((name) => ({ name, estimator: "path", sampler: "independent" }) as const),
  ...(["cornell", "bleed", "spheres"] as const).map(
    (name) => ({ name, estimator: "uniform", sampler: "sobol" }) as const,
  ),
];

describe.each(CASES)("$name with the $estimator estimator and $sampler points, seeds 1–8", (settings) => {
  const { name, estimator, sampler } = settings;
  const reference = loadReference(name);
  const { width, height } = reference;
  const rendered = renderOnce(() =>
    renderSeeds(reference.scene, {
      size: [width, height],
      samples: SAMPLES,
      seeds: SEEDS,
      settings: { estimator, sampler, constants: estimator === "path" },
    }),
  );

  test("agrees with Mitsuba, pixel by pixel and in the mean", async () => {
    const renders = await rendered();
    const measured = measure(
      renders.map(({ image }) => image),
      width,
      height,
      SAMPLES,
    );
    const verdict = judge(measured, reference);
    console.log(`${name} ${estimator} ${sampler}: ${describeVerdict(verdict)}`);
    expect(verdict.pixelShare).toBeGreaterThanOrEqual(0.9975);
    expect(verdict.blockShare).toBe(1);
    for (const sigmas of verdict.meanSigmas) expect(Math.abs(sigmas)).toBeLessThan(4);
  }, 120_000); // the slowest has 8,000 triangles

  test("drops no sample", async () => {
    for (const { stats } of await rendered()) expect(stats.badSamples).toBe(0);
  });

  test("knows its own error", async () => {
    const squares = (await rendered()).map(({ image, stats }) => ({
      actual: relativeMse(image, reference),
      estimated: stats.error ** 2,
    }));
    const logRatio = (of: Readonly<typeof squares>) =>
      Math.log(Math.sqrt(meanOf(of.map(({ estimated }) => estimated)) / meanOf(of.map(({ actual }) => actual))));
    const [ratio, chance] = [logRatio(squares), jackknifeError(squares, logRatio)];
    const percent = (value: number) => (100 * value).toFixed(2);
    const [actual, estimated] = (["actual", "estimated"] as const).map((key) =>
      Math.sqrt(meanOf(squares.map((square) => square[key]))),
    ) as [number, number];
    console.log(
      `${name} ${estimator} ${sampler}: relative RMSE ${percent(actual)} %, estimated ${percent(estimated)} %, chance ±${percent(chance)} %`,
    );
    // Both have the same expectation: the estimate is made of two independent halves. What differs is chance, and rare
    // bright samples rule it.
    expect(Math.abs(ratio)).toBeLessThan(Math.log(HONESTY) + 3 * chance);
    expect(chance).toBeLessThan(0.15); // or the comparison would say nothing
  });
});

/** Squared relative RMSE against the reference, less what the reference's own noise contributes. */
function relativeMse(image: Float32Array, { image: reference, standardError }: Reference): number {
  let squares = 0;
  let sum = 0;
  for (let i = 0; i < reference.length; i++) {
    const ours = image[4 * Math.floor(i / 3) + (i % 3)]!;
    squares += (ours - reference[i]!) ** 2 - standardError[i]! ** 2;
    sum += reference[i]!;
  }
  return squares / reference.length / (sum / reference.length) ** 2;
}

/** Standard error of a statistic of independent values: the spread of what it is without each one of them. */
function jackknifeError<T>(values: readonly T[], statistic: (values: readonly T[]) => number): number {
  const without = values.map((_, i) => statistic(values.filter((_, j) => j !== i)));
  const mean = meanOf(without);
  return Math.sqrt((values.length - 1) * meanOf(without.map((value) => (value - mean) ** 2)));
}

function meanOf(values: readonly number[]): number {
  return values.reduce((sum, value) => sum + value, 0) / values.length;
}

function describeVerdict({ pixelShare, blockShare, meanSigmas, meanError }: ReturnType<typeof judge>): string {
  const sigmas = meanSigmas.map((value) => value.toFixed(2)).join(" ");
  return `pixels ${(100 * pixelShare).toFixed(2)} %, blocks ${(100 * blockShare).toFixed(1)} %, mean ${sigmas} σ, σ ${meanError.toExponential(1)}`;
}

function renderOnce<T>(render: () => Promise<T>): () => Promise<T> {
  let result: Promise<T> | undefined;
  return () => {
    result ??= render();
    return result;
  };
}
