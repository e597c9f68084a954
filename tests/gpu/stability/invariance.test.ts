import { afterAll, expect, test } from "vitest";
import type { Vec3 } from "../../../src/scene/schema";
import { renderScene } from "../../support/device";
import { placed } from "../../support/placed";
import { loadReference } from "../../support/reference";
import { small } from "../../support/stability";
import { recordStability, type StabilityRow } from "../../support/stabilityRows";

const SIZE = [96, 96] as const;
const SAMPLES = 64;
// The same seed makes the same decisions, unless one of them is as close as rounding: then a path ends elsewhere. With a
// flip in a thousand paths of relative spread 3, the mean of 6·10⁵ paths moves by 3·√(2·10⁻³/6·10⁵) = 1.7·10⁻⁴ (one σ).
const BIAS = 1e-3;

const PLACES: readonly { name: string; size: number; by: Vec3 }[] = [
  { name: "scaled by 0.05 at (60, −35, 48)", size: 0.05, by: [60, -35, 48] },
  { name: "scaled by 2000 at the origin", size: 2000, by: [0, 0, 0] },
  { name: "scaled by 10⁻³ at the origin", size: 1e-3, by: [0, 0, 0] },
  { name: "of its own size 10⁴ from the origin", size: 1, by: [6000, -7483.3, 2828.4] },
];
const rows: StabilityRow[] = [];
const { scene } = loadReference("cornell");

test.each(PLACES)("cornell $name is cornell at the origin, seed 1", async ({ name, size, by }) => {
  const options = { size: SIZE, samples: SAMPLES, seed: 1 };
  const { image: home } = await renderScene(scene, options);
  const { image, stats } = await renderScene(placed(scene, size, by), options);
  const bias = meanOf(image) / meanOf(home) - 1;
  const different = shareOfDifferentPixels(image, home);
  rows.push({
    case: `\`cornell\` ${name}`,
    asserted: `mean off by at most ${100 * BIAS} %; 95 % of the pixels the same to 10⁻³`,
    inputs: SIZE[0] * SIZE[1] * SAMPLES,
    worst: `mean ${small(bias)}; ${(100 * (1 - different)).toFixed(1)} % the same`,
    textbook: "Mitsuba 3, single precision: mean +1.4·10⁻² for the first",
  });
  expect(Math.abs(bias)).toBeLessThan(BIAS);
  expect(different).toBeLessThan(0.05);
  expect(stats.badSamples).toBe(0);
});

afterAll(() =>
  recordStability(
    "invariance",
    rows.map(({ textbook, ...row }, i) => (i === 0 ? { ...row, textbook: textbook! } : row)),
  ),
);

function meanOf(image: Float32Array): number {
  let sum = 0;
  for (let i = 0; i < image.length; i++) if (i % 4 < 3) sum += image[i]!;
  return sum / (0.75 * image.length);
}

function shareOfDifferentPixels(a: Float32Array, b: Float32Array): number {
  let different = 0;
  for (let i = 0; i < a.length; i += 4) {
    if ([0, 1, 2].some((c) => Math.abs(a[i + c]! - b[i + c]!) > 1e-3 * Math.abs(b[i + c]!))) different++;
  }
  return different / (a.length / 4);
}
