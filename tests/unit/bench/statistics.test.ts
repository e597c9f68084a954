import { describe, expect, test } from "vitest";
import { efficiency, excess, geometricMean, halve, median, noise, trueError } from "../../bench/statistics";
import { createRandom } from "../../support/random";

const filled = (count: number, value: number) => new Float32Array(count).fill(value);

/** +`offset` and −`offset` in turn about `mean`, pixel by pixel. */
const alternating = (count: number, mean: number, offset: number) =>
  Float32Array.from({ length: count }, (_, i) => mean + (Math.floor(i / 3) % 2 === 0 ? offset : -offset));

describe("noise", () => {
  test("two images ±d about a mean m differ by 2d: relMSE = 2d²/m²", () => {
    const { relMse, uncertainty } = noise(alternating(48, 4, 1), alternating(48, 4, -1));
    expect(relMse).toBeCloseTo(2 / 16, 12);
    expect(uncertainty).toBe(0); // each pixel says the same
  });

  test("equal images have none", () => {
    expect(noise(filled(12, 3), filled(12, 3))).toEqual({ relMse: 0, uncertainty: 0 });
  });

  test("a constant difference d counts as noise of variance d²/2", () => {
    expect(noise(filled(12, 1), filled(12, 3)).relMse).toBeCloseTo(2 / 4, 12);
  });

  test("one pixel of n that differs is known to 100 %", () => {
    const a = filled(3 * 50, 1);
    const b = a.map((value, i) => (i < 3 ? 2 : value));
    expect(noise(a, b).uncertainty).toBeCloseTo(1, 12);
  });
});

describe("excess", () => {
  const exact = (image: Float32Array) => ({ image, standardError: filled(image.length, 0) });

  test("a bias of 10 % without noise is found whole", () => {
    expect(excess(filled(12, 1.1), filled(12, 1.1), exact(filled(12, 1))).excess).toBeCloseTo(0.1, 6);
  });

  test("noise that the two images show is taken off", () => {
    // Their mean is off by d/2 and its variance is estimated as (2·d/2)²/4 = d²/4: nothing is left.
    const found = excess(filled(12, 1), filled(12, 1.2), exact(filled(12, 1)));
    expect(found.excess).toBeLessThan(1e-4);
  });

  test("the reference's own noise is taken off, and less than the noise is 0", () => {
    const reference = { image: filled(12, 1), standardError: filled(12, 0.1) };
    expect(excess(filled(12, 1.1), filled(12, 1.1), reference).excess).toBeLessThan(1e-3);
    expect(excess(filled(12, 1), filled(12, 1), reference).excess).toBe(0);
  });

  test("of independent noise without bias is within four standard errors, 400 pixels", () => {
    const random = createRandom(7);
    const noisy = () => Float32Array.from({ length: 1200 }, () => 0.5 + random());
    const { sigmas } = excess(noisy(), noisy(), exact(filled(1200, 1)));
    expect(Math.abs(sigmas)).toBeLessThan(4);
  });
});

test("the true error subtracts the reference's: √(0.5² − 0.3²) = 0.4", () => {
  const reference = { image: filled(12, 1), standardError: filled(12, 0.3) };
  expect(trueError(filled(12, 1.5), reference)).toBeCloseTo(0.4, 6);
});

test("halving averages 2 × 2 pixels and keeps channels and rows apart", () => {
  // 4 × 2 pixels whose value is x + 10·y + 100·c.
  const image = Float32Array.from({ length: 24 }, (_, i) => {
    const pixel = Math.floor(i / 3);
    return (pixel % 4) + 10 * Math.floor(pixel / 4) + 100 * (i % 3);
  });
  expect([...halve(image, 4, 2)]).toEqual([5.5, 105.5, 205.5, 7.5, 107.5, 207.5]);
});

test("twice the speed and half the squared error are worth the same", () => {
  expect(efficiency(0.5, 2)).toBe(efficiency(1, 1));
  expect(efficiency(0.1, 2)).toBeCloseTo(5, 12);
});

test("the median of an even number of values is the middle two's mean", () => {
  expect(median([9, 1, 5])).toBe(5);
  expect(median([4, 1, 3, 100])).toBe(3.5);
  expect(median([7])).toBe(7);
});

test("the geometric mean of a ratio and its inverse is 1", () => {
  expect(geometricMean([4, 0.25])).toBeCloseTo(1, 12);
});
