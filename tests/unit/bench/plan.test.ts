import { expect, test } from "vitest";
import { CAP_SECONDS, mainCount, pilotCount, sampleCounts } from "../../bench/plan";

test("a fast renderer takes the samples, a quarter, a sixteenth and a 64th of them", () => {
  expect(sampleCounts(64, 0.001)).toEqual([1, 4, 16, 64]);
  expect(pilotCount(64)).toBe(4);
});

test("few samples have no sixteenth", () => {
  expect(sampleCounts(4, 0.001)).toEqual([1, 4]);
  expect(pilotCount(4)).toBe(1);
});

test("no render is planned to exceed the cap", () => {
  const secondsPerSample = 0.6;
  const counts = sampleCounts(64, secondsPerSample);
  expect(counts).toEqual([1, 4, 16, 32]);
  expect(Math.max(...counts) * secondsPerSample).toBeLessThanOrEqual(CAP_SECONDS);
});

test("one sample is taken even if it exceeds the cap", () => {
  expect(sampleCounts(64, 10 * CAP_SECONDS)).toEqual([1]);
});

test("the table shows the samples asked for, or as near below as there is", () => {
  expect(mainCount([1, 4, 16, 64], 64)).toBe(64);
  expect(mainCount([4, 16, 32], 64)).toBe(32);
});
