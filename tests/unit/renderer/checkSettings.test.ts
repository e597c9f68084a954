import { describe, expect, test } from "vitest";
import { RtViewerError } from "../../../src/errors";
import { checkSettings } from "../../../src/renderer/checkSettings";
import { DEFAULT_SETTINGS, type Settings } from "../../../src/renderer/settings";

const check = (changes: object, sceneBounces = 8) =>
  checkSettings({ ...DEFAULT_SETTINGS, ...changes } as Settings, sceneBounces);

test("the defaults can be used, and so can their extremes", () => {
  check({});
  check({ maxBounces: 0, lightSamples: 1024, samplesPerFrame: 1, seed: 0, maxSamples: 1, constants: false });
  check({ maxBounces: 1024, lightSamples: 16, samplesPerFrame: 1024, seed: 2 ** 32 - 1, targetError: 1e9 });
});

test.each([
  [{ lightSamples: 0 }, "lightSamples: expected an integer from 1 to 1024, got 0"],
  [{ lightSamples: Number.NaN }, "lightSamples: expected an integer from 1 to 1024, got NaN"],
  [{ lightSamples: 1.5 }, "lightSamples: expected an integer from 1 to 1024, got 1.5"],
  [{ lightSamples: "4" }, "lightSamples: expected an integer from 1 to 1024, got 4"],
  [{ maxBounces: -2 }, "maxBounces: expected an integer from 0 to 1024, got -2"],
  [{ maxBounces: Number.POSITIVE_INFINITY }, "maxBounces: expected an integer from 0 to 1024, got Infinity"],
  [{ samplesPerFrame: "all" }, "samplesPerFrame: expected an integer from 1 to 1024, got all"],
  [{ seed: -1 }, "seed: expected an integer from 0 to 4294967295, got -1"],
  [{ targetError: -0.1 }, "targetError: expected a number ≥ 0, got -0.1"],
  [{ maxSamples: 0 }, "maxSamples: expected an integer ≥ 1, got 0"],
  [{ estimator: "metropolis" }, 'estimator: expected "path" or "uniform", got metropolis'],
  [{ constants: "yes" }, 'constants: expected true or false or "auto", got yes'],
])("%j is refused with what may be", (changes, message) => {
  expect(() => check(changes)).toThrow(message);
  expect(() => check(changes)).toThrow(RtViewerError);
});

test("every setting at fault is named", () => {
  expect(() => check({ seed: 0.5, sampler: "halton" })).toThrow(/seed: .*\n.*sampler: /);
});

describe("a path of too many shadow rays", () => {
  test("is refused, with how many light samples are possible", () => {
    const message = "lightSamples: at most 16 are possible with 1024 bounces, got 17";
    expect(() => check({ maxBounces: 1024, lightSamples: 17 })).toThrow(message);
  });

  test("counts the scene's own bounces where the setting leaves them to it", () => {
    expect(() => check({ lightSamples: 1000 }, 64)).toThrow("at most 252 are possible with 64 bounces");
    check({ lightSamples: 1000, maxBounces: 4 }, 64);
  });
});
