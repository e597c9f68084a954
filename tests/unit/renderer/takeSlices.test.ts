import { describe, expect, test } from "vitest";
import { Schedule } from "../../../src/renderer/schedule";
import { takeSlices } from "../../../src/renderer/takeSlices";

const [WIDTH, HEIGHT] = [640, 480];
const PIXELS = WIDTH * HEIGHT;
const ANY = Number.POSITIVE_INFINITY;

const film = () => new Schedule(WIDTH, HEIGHT);
const countsOf = (slices: readonly { half: number; sampleCount: number }[]) =>
  slices.map(({ half, sampleCount }) => [half, sampleCount]);
const pathsOf = (slices: readonly { paths: number }[]) => slices.reduce((sum, { paths }) => sum + paths, 0);

describe("while somebody watches", () => {
  test("a budget of 44 samples is spent on both halves evenly", () => {
    const slices = takeSlices(film(), { paths: 44.5 * PIXELS, samples: ANY, dispatchSamples: 32, isWatched: true });
    expect(countsOf(slices)).toEqual([
      [0, 22],
      [1, 22],
    ]);
  });

  test("one sample is one, however much the budget allows", () => {
    const schedule = film();
    for (const half of [0, 1, 0]) {
      const slices = takeSlices(schedule, { paths: 1e9, samples: 1, dispatchSamples: 32, isWatched: true });
      expect(countsOf(slices)).toEqual([[half, 1]]);
    }
  });

  test("a quick GPU fills a frame with many dispatches of a small picture", () => {
    const schedule = new Schedule(64, 64);
    takeSlices(schedule, { paths: 1e7, samples: ANY, dispatchSamples: 32, isWatched: true });
    expect(schedule.samples).toBe(2048);
  });

  test("a pass that does not fit has one sample, and the submit ends with it", () => {
    const schedule = film();
    const limits = { paths: 0.4 * PIXELS, samples: ANY, dispatchSamples: 32, isWatched: true };
    const frames = [1, 2, 3].map(() => takeSlices(schedule, limits));
    for (const slices of frames) expect(countsOf(slices)).toEqual([[0, 1]]);
    expect(schedule.samples).toBe(1);
    expect(pathsOf(frames[0]!)).toBeLessThanOrEqual(limits.paths);
  });
});

describe("while nobody watches", () => {
  test("64 samples of a small picture are one submit", () => {
    const schedule = new Schedule(256, 256);
    const slices = takeSlices(schedule, { paths: 1e9, samples: 64, dispatchSamples: 32, isWatched: false });
    expect(countsOf(slices)).toEqual([
      [0, 32],
      [1, 32],
    ]);
    expect(schedule.samples).toBe(64);
  });

  test("a slow adapter takes many samples of some of the pixels", () => {
    const limits = { paths: 200_000, samples: 64, dispatchSamples: 32, isWatched: false };
    const [slice, ...others] = takeSlices(film(), limits);
    expect(others).toEqual([]);
    expect(slice).toMatchObject({ half: 0, sampleCount: 32 });
    expect(slice!.paths).toBeLessThanOrEqual(limits.paths);
  });

  test("what a scene allows in one dispatch is taken, whatever the adapter's pace", () => {
    for (const paths of [16, 8192, 1e9]) {
      const limits = { paths, samples: 64, dispatchSamples: 4, isWatched: false };
      expect(takeSlices(film(), limits)[0]!.sampleCount).toBe(4);
    }
  });
});
