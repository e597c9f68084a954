import { expect, test } from "vitest";
import { renderSeeds, seedsFrom } from "../support/device";
import { loadReference } from "../support/reference";
import { measure } from "../support/statistics";

const SIZE = [64, 64] as const;
const SEEDS = seedsFrom(1, 12);
const FEW = 16;
const MANY = 128;

// The exponents are those of sums of squares over 4096 pixels × 12 seeds. A few hundred bright samples carry half of each
// sum, so that either is known to about 5 %, and the exponent to 0.07/ln 8 = 0.03.
test("the squared error of Sobol points falls at least as N^-1.1 on cornell, seeds 1–12", async () => {
  const exponent = await errorExponent("sobol");
  console.log(`squared error with Sobol points: N^${exponent.toFixed(3)}`);
  expect(exponent).toBeLessThan(-1.1);
});

test("the squared error of independent points falls as N^-1 on cornell, seeds 1–12", async () => {
  const exponent = await errorExponent("independent");
  console.log(`squared error with independent points: N^${exponent.toFixed(3)}`);
  // Three standard errors.
  expect(Math.abs(exponent + 1)).toBeLessThan(0.1);
});

async function errorExponent(sampler: "sobol" | "independent"): Promise<number> {
  const few = await meanSquaredError(sampler, FEW);
  const many = await meanSquaredError(sampler, MANY);
  return Math.log(many / few) / Math.log(MANY / FEW);
}

/** Of one render, from the spread of several: no reference's error enters. */
async function meanSquaredError(sampler: "sobol" | "independent", samples: number): Promise<number> {
  const { scene } = loadReference("cornell");
  const renders = await renderSeeds(scene, { size: SIZE, samples, seeds: SEEDS, settings: { sampler } });
  const { variance } = measure(
    renders.map(({ image }) => image),
    SIZE[0],
    SIZE[1],
    samples,
  );
  return (SEEDS.length * variance.reduce((sum, value) => sum + value, 0)) / variance.length;
}
