import { expect, test } from "vitest";
import { logScale, roundDown, roundUp, ticks } from "../../../demo/performance/axes";

test("a scale puts its ends on its ends, and the geometric mean halfway", () => {
  const scale = logScale([0.01, 100], [300, 0]);
  expect([0.01, 1, 100].map(scale).map(Math.round)).toEqual([300, 150, 0]);
});

test("bounds become round numbers on their outer side", () => {
  expect([0.03, 0.5, 7, 100].map(roundDown)).toEqual([0.02, 0.5, 5, 100]);
  expect([0.03, 0.5, 7, 100].map(roundUp)).toEqual([0.05, 0.5, 10, 100]);
});

test("a long axis is marked at powers of ten, a short one in between too", () => {
  expect(ticks([0.005, 20])).toEqual([0.01, 0.1, 1, 10]);
  expect(ticks([0.1, 2])).toEqual([0.1, 0.2, 0.5, 1, 2]);
});
