import { describe, expect, test } from "vitest";
import { constantImage, judge, measure, normalQuantile, sidakThreshold } from "../../support/statistics";

// Gaussian noise of standard deviation 0.1 around 1, from a small generator with a fixed seed.
function noisyRenders(count: number, size: number, value: (pixel: number) => number): Float32Array[] {
  let state = 12345;
  const uniform = () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return (state + 0.5) / 2 ** 32;
  };
  return Array.from({ length: count }, () =>
    Float32Array.from({ length: 4 * size * size }, (_, i) => value(i >> 2) + 0.1 * normalQuantile(uniform())),
  );
}

const SIZE = 32;
const WHITE = constantImage(SIZE, SIZE, [1, 1, 1]);
const judgeValue = (value: (pixel: number) => number) =>
  judge(measure(noisyRenders(8, SIZE, value), SIZE, SIZE, 32), WHITE);

describe("the image comparison", () => {
  test("accepts an image that is right up to its noise, seed 12345", () => {
    const { pixelShare, blockShare, meanSigmas } = judgeValue(() => 1);
    expect(pixelShare).toBeGreaterThanOrEqual(0.9975);
    expect(blockShare).toBe(1);
    expect(Math.max(...meanSigmas.map(Math.abs))).toBeLessThan(4);
  });

  test("rejects the mean of an image that is 1 % too bright, 9 standard errors, seed 12345", () => {
    const { meanSigmas } = judgeValue(() => 1.01);
    expect(Math.min(...meanSigmas)).toBeGreaterThan(4);
  });

  test("rejects a block that is 6 % too bright, five standard errors of its mean, seed 12345", () => {
    const { blockShare } = judgeValue((pixel) => (pixel % SIZE < 8 && pixel < 8 * SIZE ? 1.06 : 1));
    expect(blockShare).toBeLessThan(1);
  });

  test("rejects eight wrong pixels of 1024, seed 12345", () => {
    const { pixelShare } = judgeValue((pixel) => (pixel % 128 === 5 ? 1.4 : 1));
    expect(pixelShare).toBeLessThan(0.9975);
  });
});

test("the normal quantile equals tabulated values", () => {
  expect(normalQuantile(0.5)).toBe(0);
  expect(normalQuantile(0.975)).toBeCloseTo(1.959963984540054, 14);
  expect(normalQuantile(1e-3)).toBeCloseTo(-3.090232306167814, 13);
  expect(normalQuantile(1e-15)).toBeCloseTo(-7.941345326170998, 12);
});

test("the Šidák threshold of a single value is the plain two-sided one", () => {
  expect(sidakThreshold(0.05, 1)).toBeCloseTo(1.959963984540054, 12);
  expect(sidakThreshold(0.01, 49152)).toBeGreaterThan(5);
});
