import { describe, expect, test } from "vitest";
import { parseOptions, RENDERER_IDS, UsageError } from "../../bench/options";

test("by default everything is measured and the repository's report replaced", () => {
  const options = parseOptions([]);
  expect(options).toMatchObject({ size: 256, samples: 64, runs: 3, hosts: ["chromium", "dawn"], out: "tests/bench" });
  expect(options.renderers).toEqual(RENDERER_IDS);
  expect(options.scenes).toHaveLength(5);
});

test("a GPU's full run replaces the report too", () => {
  expect(parseOptions(["--gpu"]).out).toBe("tests/bench");
});

test.each([["--quick"], ["--scenes", "cornell"], ["--samples", "4"]])(
  "a part of the benchmark stays out of the repository: %s",
  (...args) => {
    expect(parseOptions(args).out).toBe("tests/output/bench");
  },
);

test("--from writes the report to the folder that its results are in", () => {
  expect(parseOptions(["--from", "tests/bench/results/swiftshader.json"]).out).toBe("tests/bench");
});

test("lists are put into the order of the tables", () => {
  expect(parseOptions(["--renderers", "cycles,ours"]).renderers).toEqual(["ours", "cycles"]);
});

test("what --quick chooses can be overridden", () => {
  const options = parseOptions(["--quick", "--scenes", "veach", "--renderers", "ours,mitsuba"]);
  expect(options).toMatchObject({ scenes: ["veach"], renderers: ["ours", "mitsuba"], size: 64 });
});

describe("says what is wrong", () => {
  test.each([
    [["--scenes", "cornel"], /--scenes: expected some of cornell, .*got cornel/],
    [["--renderers", ""], /--renderers: expected some of/],
    [["--host", "firefox"], /--host: expected chromium, dawn or both, got firefox/],
    [["--size", "12.5"], /--size: expected an integer ≥ 2, got 12.5/],
    [["--runs", "1"], /--runs: expected an integer ≥ 2, got 1/],
    [["--speed"], /Unknown option/],
  ])("%j", (args, message) => {
    expect(() => parseOptions(args)).toThrow(UsageError);
    expect(() => parseOptions(args)).toThrow(message);
  });
});
