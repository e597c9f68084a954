import { expect, test } from "vitest";
import { chiSquareTest, regularizedGammaQ, sidakLevel } from "../../support/chiSquare";
import { createRandom } from "../../support/random";

test.each([
  // Upper percentage points of χ², NIST/SEMATECH e-Handbook of Statistical Methods, 1.3.6.7.4.
  [1, 3.841, 0.05],
  [10, 18.307, 0.05],
  [10, 23.209, 0.01],
  [50, 76.154, 0.01],
  [100, 149.449, 0.001],
  [100, 77.929, 0.95],
])("χ² with %d degrees of freedom exceeds %d with probability %d", (degrees, chi2, probability) => {
  expect(regularizedGammaQ(degrees / 2, chi2 / 2) / probability).toBeCloseTo(1, 2);
});

test("Q(1, x) is e^−x", () => {
  for (const x of [0.01, 1, 1.9, 2.1, 30]) expect(regularizedGammaQ(1, x) / Math.exp(-x)).toBeCloseTo(1, 12);
});

test("p-values of correct samples are uniform, seed 1", () => {
  const random = createRandom(1);
  const counts = [0, 0, 0, 0];
  for (let run = 0; run < 1000; run++) counts[Math.floor(4 * chiSquareTest(histogram(random, 1), EVEN))]!++;
  // Binomial: 250 ± 4·sqrt(1000·¼·¾).
  for (const count of counts) expect(Math.abs(count - 250)).toBeLessThan(55);
});

test("samples of another density are found out, seed 2", () => {
  expect(chiSquareTest(histogram(createRandom(2), 1.3), EVEN)).toBeLessThan(1e-6);
});

test("a sample where none can be is found out", () => {
  expect(chiSquareTest([1, 500, 499], [0, 500, 500])).toBe(0);
});

test("Šidák's level lets all tests together pass with the chosen probability", () => {
  expect((1 - sidakLevel(0.01, 40)) ** 40).toBeCloseTo(0.99, 12);
});

const EVEN = Array.from({ length: 20 }, () => 100);

function histogram(random: () => number, power: number): number[] {
  const counts = Array.from({ length: 20 }, () => 0);
  for (let i = 0; i < 2000; i++) counts[Math.floor(20 * random() ** power)]!++;
  return counts;
}
