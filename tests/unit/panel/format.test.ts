import { expect, it } from "vitest";
import {
  formatCount,
  formatFps,
  formatMilliseconds,
  formatPercent,
  formatRate,
  formatSeconds,
} from "../../../src/panel/format";

it.each([
  [0, "0"],
  [7, "7"],
  [999, "999"],
  [1000, "1.00 k"],
  [999_999, "1.00 M"],
  [1_234_567, "1.23 M"],
  [45_600_000_000, "45.6 G"],
  [Number.POSITIVE_INFINITY, "–"],
])("counts %d as %s", (value, text) => {
  expect(formatCount(value)).toBe(text);
});

it.each([
  [1.234, "123 %"],
  [0.01234, "1.23 %"],
  [0.000123, "0.0123 %"],
  [0, "0 %"],
  [Number.POSITIVE_INFINITY, "–"],
  [Number.NaN, "–"],
])("shows the error %d as %s", (value, text) => {
  expect(formatPercent(value)).toBe(text);
});

it("shows a dash for what is not known yet", () => {
  expect([formatRate(0), formatFps(0), formatMilliseconds(0)]).toEqual(["–", "–", "–"]);
});

it("shows rates with their unit", () => {
  expect(formatRate(2_450_000)).toBe("2.45 M/s");
  expect(formatRate(12)).toBe("12 /s");
  expect(formatFps(59.94)).toBe("59.9");
  expect(formatMilliseconds(16.67)).toBe("16.7 ms");
});

it.each([
  [0, "0 s"],
  [0.1234, "0.12 s"],
  [12.3, "12 s"],
  [119, "120 s"],
  [121, "2 min"],
  [7100, "118 min"],
  [86_400, "24 h"],
  [Number.POSITIVE_INFINITY, "–"],
])("shows %d seconds as %s", (seconds, text) => {
  expect(formatSeconds(seconds)).toBe(text);
});
