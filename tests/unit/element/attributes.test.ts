import { expect, it } from "vitest";
import {
  EXPOSURE_RULE,
  LOADING_MODES,
  OBSERVED_ATTRIBUTES,
  parseKeyword,
  parseNumber,
  SETTING_ATTRIBUTES,
  settingOfAttribute,
} from "../../../src/element/attributes";

it.each([
  ["4", 4],
  [" 16 ", 16],
  ["1e2", 100],
  ["0", undefined],
  ["-3", undefined],
  ["2.5", undefined],
  ["many", undefined],
  ["", undefined],
  ["NaN", undefined],
  ["Infinity", undefined],
  [null, undefined],
])("samples-per-frame=%j counts as %j", (text, wanted) => {
  expect(parseNumber(text, SETTING_ATTRIBUTES.samplesPerFrame)).toBe(wanted);
});

it("max-samples may be infinite", () => {
  expect(parseNumber("Infinity", SETTING_ATTRIBUTES.maxSamples)).toBe(Number.POSITIVE_INFINITY);
});

it("exposure is any number of stops that keeps its power of two finite", () => {
  expect(parseNumber("-1.5", EXPOSURE_RULE)).toBe(-1.5);
  expect(parseNumber("1000", EXPOSURE_RULE)).toBeUndefined();
});

it.each([
  ["lazy", "lazy"],
  [" LAZY ", "lazy"],
  ["eager", "eager"],
  ["", "eager"],
  ["later", "eager"],
  [null, "eager"],
])("loading=%j counts as %j", (text, wanted) => {
  expect(parseKeyword(text, LOADING_MODES, "eager")).toBe(wanted);
});

it("every setting attribute is observed and leads back to its setting", () => {
  for (const [name, { attribute }] of Object.entries(SETTING_ATTRIBUTES)) {
    expect(OBSERVED_ATTRIBUTES).toContain(attribute);
    expect(settingOfAttribute(attribute)).toBe(name);
  }
  expect(settingOfAttribute("src")).toBeUndefined();
});
