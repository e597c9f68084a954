import { expect, test } from "vitest";
import { relativeError } from "../../../src/gpu/errorPass";

/** Partial sums as `wgsl/error.wgsl` writes them: squared error and radiance, both over three channels, and pixels. */
function sums(...groups: [squaredError: number, radiance: number, pixels: number][]): Float32Array {
  return new Float32Array(groups.flatMap((group) => [...group, 0]));
}

test("the relative error is the root of the mean squared error over the mean", () => {
  // Four pixels, twelve values: mean squared error 3/12 = 0.25, mean 24/12 = 2.
  expect(relativeError(sums([3, 24, 4]))).toBe(0.25);
});

test("how the pixels are spread over the workgroups does not matter", () => {
  expect(relativeError(sums([1, 20, 1], [0, 0, 0], [2, 4, 3]))).toBe(relativeError(sums([3, 24, 4])));
});

test("a brighter picture of the same noise-to-signal ratio has the same error", () => {
  expect(relativeError(sums([3 * 64 ** 2, 24 * 64, 4]))).toBe(relativeError(sums([3, 24, 4])));
});

test("before both halves hold a sample the error is infinite", () => {
  expect(relativeError(sums([0, 0, 0]))).toBe(Number.POSITIVE_INFINITY);
  expect(relativeError(new Float32Array(0))).toBe(Number.POSITIVE_INFINITY);
});

test("while every sample is black the error is infinite: the light may only not have been found yet", () => {
  expect(relativeError(sums([0, 0, 16]))).toBe(Number.POSITIVE_INFINITY);
});
