import { expect, test } from "vitest";
import { Pace } from "../../../src/renderer/pace";

const FIRST = 1000;

/** A pace that has seen an adapter of constant speed do work of this size. */
function measured(msPerPath: number, paths = 10_000): Pace {
  const pace = new Pace(FIRST);
  for (let i = 0; i < 50; i++) pace.observe(paths, msPerPath * paths);
  return pace;
}

test("before anything is measured the work is small and nothing is predicted", () => {
  const pace = new Pace(FIRST);
  for (const budgetMs of [1, 12, 100]) expect(pace.pathsFor(budgetMs)).toBe(FIRST);
  expect(pace.predictMs(1e9)).toBe(0);
});

test("work fills the budget", () => {
  const pace = measured(1e-3);
  for (const budgetMs of [4, 12, 100]) expect(pace.predictMs(pace.pathsFor(budgetMs))).toBeCloseTo(budgetMs, 9);
});

test("what starting costs a small first work is forgotten with the first large one", () => {
  // 0.05 ms to start with, and 10⁷ paths per millisecond, as on a quick GPU.
  const msOf = (paths: number) => 0.05 + paths / 1e7;
  const pace = new Pace(8192);
  const submits = [];
  while (submits.length < 3) {
    const paths = pace.pathsFor(12);
    submits.push(paths);
    pace.observe(paths, msOf(paths));
  }
  expect(msOf(pace.pathsFor(12))).toBeGreaterThan(0.8 * 12);
  expect(msOf(pace.pathsFor(12))).toBeLessThan(1.05 * 12);
});

test("a first work of a few strips, which may have missed what is slow, lets the next one be 16 times as large at most", () => {
  const pace = new Pace(16);
  pace.observe(16, 1e-3);
  expect(pace.pathsFor(12)).toBe(256);
  pace.observe(256, 1e-3);
  expect(pace.pathsFor(12)).toBe(4096);
});

test("one stutter changes the work by less than a factor of four, and a lasting change is learnt within ten measurements", () => {
  const pace = measured(1e-3);
  const before = pace.pathsFor(12);
  pace.observe(10_000, 100);
  expect(pace.pathsFor(12)).toBeGreaterThan(before / 4);
  const slowed = measured(1e-3);
  for (let i = 0; i < 10; i++) slowed.observe(10_000, 4e-3 * 10_000);
  // 0.7¹⁰ = 2.8 % of the old speed is left.
  expect(slowed.predictMs(10_000) / 40).toBeCloseTo(1, 1);
});
