import { describe, expect, test } from "vitest";
import { Meter } from "../../../src/renderer/meter";
import { Schedule } from "../../../src/renderer/schedule";
import {
  DEFAULT_SETTINGS,
  effectOfChange,
  SETTING_EFFECTS,
  type Settings,
  sampleLimit,
} from "../../../src/renderer/settings";

// The largest count that an f32 reaches in steps of one.
const COUNTED = 2 ** 24;

test("a film that runs for a year stops where its halves can count no further", () => {
  const limit = sampleLimit(DEFAULT_SETTINGS);
  expect([limit, sampleLimit({ maxSamples: 1e12 }), sampleLimit({ maxSamples: 100 })]).toEqual([
    2 * COUNTED,
    limit,
    100,
  ]);
  const schedule = new Schedule(1, 1);
  while (schedule.samples < limit) {
    const slice = schedule.next(1e9, 1_000_003, limit - schedule.samples);
    expect(slice.firstSample + slice.sampleCount).toBeLessThanOrEqual(COUNTED);
    schedule.finish(slice);
  }
  expect(schedule.samples).toBe(limit);
});

test("at that limit sampling rests, whatever maxSamples is", () => {
  const meter = new Meter("");
  const report = { gpuMs: undefined, rays: 0, badSamples: 0, errorSums: undefined };
  const isConvergedAt = (samples: number) => {
    meter.count(samples, report);
    meter.updateConverged(DEFAULT_SETTINGS);
    return meter.stats.converged;
  };
  expect([isConvergedAt(2 * COUNTED - 1), isConvergedAt(2 * COUNTED)]).toEqual([false, true]);
});

describe("what a change of settings asks for", () => {
  test("is said of every setting", () => {
    expect(Object.keys(SETTING_EFFECTS).sort()).toEqual(Object.keys(DEFAULT_SETTINGS).sort());
  });

  const OTHERS = {
    maxBounces: 3,
    lightSamples: 2,
    samplesPerFrame: 4,
    estimator: "uniform",
    sampler: "independent",
    constants: false,
    seed: 7,
    targetError: 0.1,
    maxSamples: 64,
  } as const satisfies Settings;

  test.each(Object.keys(SETTING_EFFECTS) as (keyof Settings)[])("%s alone: what the table says", (name) => {
    const changed = { ...DEFAULT_SETTINGS, [name]: OTHERS[name] };
    expect(effectOfChange(DEFAULT_SETTINGS, changed)).toBe(SETTING_EFFECTS[name]);
  });

  test("is the most that one of several asks for, and nothing where all are the same", () => {
    expect(effectOfChange(DEFAULT_SETTINGS, OTHERS)).toBe("recompile");
    expect(effectOfChange(DEFAULT_SETTINGS, { ...DEFAULT_SETTINGS, seed: 7, targetError: 0.1 })).toBe("restart");
    expect(effectOfChange(OTHERS, { ...OTHERS })).toBe("none");
  });
});
