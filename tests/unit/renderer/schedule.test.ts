import { describe, expect, test } from "vitest";
import { Schedule, type Slice } from "../../../src/renderer/schedule";

/** A film of four blocks, 64 strips. */
const film = () => new Schedule(16, 16);
const PIXELS = 256;
const ALL = 1e9;

/** Takes slices until `target` samples per pixel are complete; `paths` and `maxCount` may change from slice to slice. */
function sampleTo(schedule: Schedule, target: number, paths: () => number, maxCount: () => number): Slice[] {
  const slices: Slice[] = [];
  while (schedule.samples < target) {
    const slice = schedule.next(paths(), maxCount(), target - schedule.samples);
    schedule.finish(slice);
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

/** Pixels of a slice, as `wgsl/slice.wgsl` finds them. */
function pixelsOf({ firstStrip, endStrip, unitStrips, unitStride }: Slice, width: number, height: number): number[] {
  const columns = Math.ceil(width / 8);
  const units = (columns * Math.ceil(height / 8) * 16) / unitStrips;
  const pixels: number[] = [];
  for (let strip = firstStrip; strip < endStrip; strip++) {
    const unit = (Math.floor(strip / unitStrips) * unitStride) % units;
    const place = unit * unitStrips + (strip % unitStrips);
    const block = Math.floor(place / 16);
    for (let lane = 0; lane < 4; lane++) {
      const pixel = (place % 16) * 4 + lane;
      const x = 8 * (block % columns) + (pixel % 8);
      const y = 8 * Math.floor(block / columns) + Math.floor(pixel / 8);
      if (x < width && y < height) pixels.push(y * width + x);
    }
  }
  return pixels;
}

describe("a pass", () => {
  test("that fits is one slice, in the order of the film", () => {
    expect(film().next(PIXELS, 1, 1)).toEqual({
      ...{ half: 0, firstSample: 0, sampleCount: 1, paths: PIXELS },
      ...{ firstStrip: 0, endStrip: 64, unitStrips: 1, unitStride: 1 },
    });
  });

  test("keeps its half, count and order when the limits change under way", () => {
    const schedule = film();
    const first = schedule.next(512, 4, 100);
    schedule.finish(first);
    const second = schedule.next(ALL, 1, 100);
    expect(first).toMatchObject({ half: 0, firstSample: 0, sampleCount: 4, firstStrip: 0, endStrip: 32 });
    expect(second).toEqual({ ...first, firstStrip: 32, endStrip: 64 });
  });

  test("counts only when it is complete", () => {
    const schedule = film();
    schedule.finish(schedule.next(512, 4, 100));
    expect([schedule.samples, schedule.isComplete]).toEqual([0, false]);
    schedule.finish(schedule.next(512, 4, 100));
    expect([schedule.samples, schedule.isComplete]).toEqual([4, true]);
  });

  test("asked for again without being finished is the same slice", () => {
    const schedule = film();
    expect(schedule.next(512, 4, 100)).toEqual(schedule.next(512, 4, 100));
  });

  test("takes a strip of four pixels at least, however little is allowed", () => {
    expect(film().next(0, 1, 1)).toMatchObject({ firstStrip: 0, endStrip: 1, paths: 4 });
  });

  test("is cut at blocks, so that no lane idles, where a slice has many", () => {
    const schedule = new Schedule(640, 480);
    const slices = sampleTo(
      schedule,
      1,
      () => 10_001,
      () => 1,
    );
    expect(slices.length).toBe(Math.ceil(4800 / Math.floor(10_001 / 64)));
    for (const { endStrip } of slices) expect(endStrip % 16).toBe(0);
  });

  test.each([
    [640, 480, 20_000],
    [640, 480, 400],
    [1920, 1080, 24_000],
    [8192, 8192, 100_000],
  ])("of %i × %i pixels in slices of %i paths spreads each over the whole picture", (width, height, paths) => {
    const schedule = new Schedule(width, height);
    const slice = schedule.next(paths, 1, 1);
    const rows = pixelsOf(slice, width, height).map((pixel) => Math.floor(pixel / width));
    // Every eighth of the picture's height gets its share, but for half of it.
    for (let band = 0; band < 8; band++) {
      const inBand = rows.filter((row) => Math.floor((8 * row) / height) === band).length;
      expect(inBand).toBeGreaterThan((0.5 * rows.length) / 8);
      expect(inBand).toBeLessThan((1.5 * rows.length) / 8);
    }
  });
});

describe("halves", () => {
  test("take turns of equal size", () => {
    const slices = sampleTo(
      film(),
      12,
      () => ALL,
      () => 3,
    );
    expect(slices.map(({ half, firstSample, sampleCount }) => [half, firstSample, sampleCount])).toEqual([
      [0, 0, 3],
      [1, 0, 3],
      [0, 3, 3],
      [1, 3, 3],
    ]);
  });

  test.each([1, 2, 3, 7, 16, 33])("hold equally many of %i samples, or one more in the first", (target) => {
    const schedule = film();
    const slices = sampleTo(
      schedule,
      target,
      () => ALL,
      () => 16,
    );
    const held = (half: 0 | 1) => slices.filter((s) => s.half === half).reduce((sum, s) => sum + s.sampleCount, 0);
    expect([held(0), held(1)]).toEqual([Math.ceil(target / 2), Math.floor(target / 2)]);
    expect(schedule.samples).toBe(target);
  });
});

test.each([1, 2, 3])("every pixel gets every sample exactly once, whatever the limits, seed %i", (seed) => {
  const random = randomOf(seed);
  const [width, height] = [1 + Math.floor(50 * random()), 1 + Math.floor(50 * random())];
  const schedule = new Schedule(width, height);
  const limits = [() => 3 * width * height * random() ** 3, () => 1 + Math.floor(9 * random())] as const;
  // In steps, as calls of sample(n) would.
  const slices = [3, 4, 20, 21, 50].flatMap((target) => sampleTo(schedule, target, ...limits));

  const seen = new Uint8Array(2 * width * height * 50);
  let paths = 0;
  for (const slice of slices) {
    paths += slice.paths;
    for (const pixel of pixelsOf(slice, width, height)) {
      for (let i = 0; i < slice.sampleCount; i++) {
        seen[(slice.half * width * height + pixel) * 50 + slice.firstSample + i]! += 1;
      }
    }
  }
  expect(Math.max(...seen)).toBe(1);
  expect(seen.reduce((sum, times) => sum + times)).toBe(50 * width * height);
  expect(paths).toBeCloseTo(50 * width * height, 6);
  expect(schedule.samples).toBe(50);
});

test.each([[64], [1, 63], [5, 5, 5, 49]])("64 samples taken as %j and more leave both halves with 32", (...steps) => {
  const schedule = film();
  let target = 0;
  let first = 0;
  for (const step of steps) {
    target += step;
    for (const { half, sampleCount } of sampleTo(
      schedule,
      target,
      () => ALL,
      () => 16,
    )) {
      first += half === 0 ? sampleCount : 0;
    }
  }
  expect([schedule.samples, first]).toEqual([64, 32]);
});

test("there is no limit to an endless picture", () => {
  expect(film().next(ALL, 2, Number.POSITIVE_INFINITY).sampleCount).toBe(2);
});

test("a slice that no pass is under way for is a mistake", () => {
  const schedule = film();
  const slice = schedule.next(ALL, 1, 1);
  schedule.finish(slice);
  expect(() => schedule.finish(slice)).toThrow(RangeError);
});
