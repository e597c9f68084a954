import { expect, test } from "vitest";
import { Rate } from "../../../src/renderer/rate";

test("nothing is known at first", () => {
  expect(new Rate().perSecond).toBe(0);
});

test("the first measurement counts in full", () => {
  const rate = new Rate();
  rate.observe(5, 0.1);
  expect(rate.perSecond).toBe(50);
});

test("a constant rate stays what it is", () => {
  const rate = new Rate();
  for (let i = 0; i < 100; i++) rate.observe(1, 1 / 60);
  expect(rate.perSecond).toBeCloseTo(60, 9);
});

test.each([0.01, 0.25])("a change is averaged over about a second, measured every %d s", (seconds) => {
  const rate = new Rate();
  for (let t = 0; t < 40; t += seconds) rate.observe(10 * seconds, seconds);
  for (let t = 0; t < 1 - 1e-9; t += seconds) rate.observe(20 * seconds, seconds);
  // 1/e of the old rate is left after one second, however often it was measured.
  expect(rate.perSecond).toBeCloseTo(20 - 10 / Math.E, 9);
});

test("a short first measurement does not outweigh what follows", () => {
  const rate = new Rate();
  rate.observe(1, 0.001);
  rate.observe(1e6, 0.1);
  expect(rate.perSecond).toBeGreaterThan(0.98e7);
});

test("no time passed is no measurement", () => {
  const rate = new Rate();
  rate.observe(3, 0);
  rate.observe(3, -1);
  expect(rate.perSecond).toBe(0);
});
