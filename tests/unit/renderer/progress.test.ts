import { describe, expect, test } from "vitest";
import { Progress, type Slice } from "../../../src/renderer/progress";

/** Takes slices until `target` samples per pixel are complete; `rows` and `maxCount` may change from slice to slice. */
function sampleTo(progress: Progress, target: number, rows: () => number, maxCount: () => number): Slice[] {
  const slices: Slice[] = [];
  while (progress.samples < target) {
    const slice = progress.next(rows(), maxCount(), target - progress.samples);
    progress.finish(slice);
    slices.push(slice);
  }
  return slices;
}

/** Numbers in [0, 1): mulberry32, for reproducible shuffling. */
function randomOf(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), state | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

describe("a pass", () => {
  test("is cut into slices of rows that end at the last one", () => {
    const slices = sampleTo(
      new Progress(20),
      1,
      () => 8,
      () => 1,
    );
    expect(slices.map(({ firstRow, endRow }) => [firstRow, endRow])).toEqual([
      [0, 8],
      [8, 16],
      [16, 20],
    ]);
  });

  test("keeps its half and count when the limits change under way", () => {
    const progress = new Progress(16);
    const first = progress.next(8, 4, 100);
    progress.finish(first);
    const second = progress.next(8, 1, 100);
    expect(first).toEqual({ half: 0, firstSample: 0, count: 4, firstRow: 0, endRow: 8 });
    expect(second).toEqual({ half: 0, firstSample: 0, count: 4, firstRow: 8, endRow: 16 });
  });

  test("counts only when it is complete", () => {
    const progress = new Progress(16);
    progress.finish(progress.next(8, 4, 100));
    expect(progress.samples).toBe(0);
    progress.finish(progress.next(8, 4, 100));
    expect(progress.samples).toBe(4);
  });

  test("asked for again without being finished is the same slice", () => {
    const progress = new Progress(16);
    expect(progress.next(8, 4, 100)).toEqual(progress.next(8, 4, 100));
  });
});

describe("halves", () => {
  test("take turns of equal size", () => {
    const slices = sampleTo(
      new Progress(8),
      12,
      () => 8,
      () => 3,
    );
    expect(slices.map(({ half, firstSample, count }) => [half, firstSample, count])).toEqual([
      [0, 0, 3],
      [1, 0, 3],
      [0, 3, 3],
      [1, 3, 3],
    ]);
  });

  test.each([1, 2, 3, 7, 16, 33])("hold equally many of %i samples, or one more in the first", (target) => {
    const progress = new Progress(8);
    const slices = sampleTo(
      progress,
      target,
      () => 8,
      () => 16,
    );
    const held = (half: 0 | 1) => slices.filter((s) => s.half === half).reduce((sum, { count }) => sum + count, 0);
    expect([held(0), held(1)]).toEqual([Math.ceil(target / 2), Math.floor(target / 2)]);
    expect(progress.samples).toBe(target);
    expect(progress.isBalanced).toBe(target % 2 === 0);
  });

  test("are unbalanced while a pass is under way", () => {
    const progress = new Progress(16);
    expect(progress.isBalanced).toBe(true);
    progress.finish(progress.next(8, 1, 100));
    expect(progress.isBalanced).toBe(false);
  });
});

test.each([1, 2, 3])("every row gets every sample exactly once, whatever the limits, seed %i", (seed) => {
  const random = randomOf(seed);
  const height = 1 + Math.floor(50 * random());
  const progress = new Progress(height);
  const limits = [() => 1 + Math.floor(2 * height * random()), () => 1 + Math.floor(9 * random())] as const;
  // In steps, as calls of sample(n) would.
  const slices = [3, 4, 20, 21, 50].flatMap((target) => sampleTo(progress, target, ...limits));

  const seen = new Map<string, number>();
  for (const { half, firstSample, count, firstRow, endRow } of slices) {
    expect(endRow).toBeGreaterThan(firstRow);
    for (let row = firstRow; row < endRow; row++) {
      for (let i = 0; i < count; i++) {
        const key = `row ${row}, half ${half}, sample ${firstSample + i}`;
        seen.set(key, (seen.get(key) ?? 0) + 1);
      }
    }
  }
  expect(seen.size).toBe(height * progress.samples);
  expect([...seen.values()].every((times) => times === 1)).toBe(true);
  expect(progress.samples).toBe(50);
});

test.each([[64], [1, 63], [5, 5, 5, 49]])("64 samples taken as %j and more leave both halves with 32", (...steps) => {
  const progress = new Progress(4);
  let target = 0;
  let first = 0;
  for (const step of steps) {
    target += step;
    for (const { half, count } of sampleTo(
      progress,
      target,
      () => 8,
      () => 16,
    ))
      first += half === 0 ? count : 0;
  }
  expect([progress.samples, first]).toEqual([64, 32]);
});

test("there is no limit to an endless picture", () => {
  expect(new Progress(8).next(8, 2, Number.POSITIVE_INFINITY).count).toBe(2);
});

test("a slice that no pass is under way for is a mistake", () => {
  const progress = new Progress(8);
  const slice = progress.next(8, 1, 1);
  progress.finish(slice);
  expect(() => progress.finish(slice)).toThrow(RangeError);
});
