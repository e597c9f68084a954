import { expect, test } from "vitest";
import { Pace, pathsOf } from "../../../src/renderer/pace";
import type { Slice } from "../../../src/renderer/progress";

const WIDTH = 256;

function sliceOf(rows: number, count: number): Slice {
  return { half: 0, firstSample: 0, count, firstRow: 0, endRow: rows };
}

/** A pace that has seen an adapter of constant speed. */
function measured(msPerPath: number): Pace {
  const pace = new Pace();
  const slice = sliceOf(8, 1);
  for (let i = 0; i < 50; i++) pace.observe(slice, WIDTH, msPerPath * pathsOf(slice, WIDTH));
  return pace;
}

test("paths are pixels times samples", () => {
  expect(pathsOf({ half: 1, firstSample: 9, count: 3, firstRow: 8, endRow: 24 }, 10)).toBe(10 * 16 * 3);
});

test("before anything is measured the work is small and nothing is predicted", () => {
  const pace = new Pace();
  expect(pathsOf(sliceOf(pace.rowsFor(12, WIDTH, 1), 1), WIDTH)).toBeLessThanOrEqual(8192);
  expect(pace.predictMs(sliceOf(8, 1), WIDTH)).toBe(0);
});

test("work fits the budget, and fills it up to a workgroup's rows", () => {
  const pace = measured(1e-3);
  for (const [budgetMs, count] of [
    [12, 1],
    [100, 1],
    [100, 3],
  ] as const) {
    const rows = pace.rowsFor(budgetMs, WIDTH, count);
    expect(pace.predictMs(sliceOf(rows, count), WIDTH)).toBeLessThanOrEqual(budgetMs);
    expect(pace.predictMs(sliceOf(rows + 8, count), WIDTH)).toBeGreaterThan(budgetMs);
  }
});

test("slices end on workgroups, and hold at least one however slow the adapter is", () => {
  for (const msPerPath of [1e-7, 3e-4, 1e-2, 10]) {
    const rows = measured(msPerPath).rowsFor(12, WIDTH, 2);
    expect(rows % 8).toBe(0);
    expect(rows).toBeGreaterThanOrEqual(8);
  }
});

test("the first measurement counts in full; later ones blend, so that one stutter does not", () => {
  const slice = sliceOf(8, 1);
  const pace = new Pace();
  pace.observe(slice, WIDTH, 10);
  expect(pace.predictMs(slice, WIDTH)).toBeCloseTo(10, 12);
  pace.observe(slice, WIDTH, 100);
  expect(pace.predictMs(slice, WIDTH)).toBeGreaterThan(10);
  expect(pace.predictMs(slice, WIDTH)).toBeLessThan(50);
});

test("a lasting change is learnt within ten measurements", () => {
  const pace = measured(1e-3);
  const slice = sliceOf(8, 1);
  for (let i = 0; i < 10; i++) pace.observe(slice, WIDTH, 4e-3 * pathsOf(slice, WIDTH));
  // 0.7¹⁰ = 2.8 % of the old speed is left.
  expect(pace.predictMs(slice, WIDTH) / (4e-3 * pathsOf(slice, WIDTH))).toBeCloseTo(1, 1);
});
