import { expect, it } from "vitest";
import { fromHex, hueOf, strengthOf, toHex, withStrength } from "../../../src/panel/colors";
import type { Rgb } from "../../../src/scene/schema";

it("a colour is shown as sRGB", () => {
  expect(toHex([0, 0, 0])).toBe("#000000");
  expect(toHex([1, 1, 1])).toBe("#ffffff");
  expect(toHex([0.5, 0.001, 0.2158605])).toBe("#bc0380"); // 0.735, 12.92 · 0.001 and 0.5
  expect(toHex([2, -1, 0.5])).toBe("#ff00bc");
});

it("each of the 256 bytes comes back as it was", () => {
  for (let byte = 0; byte < 256; byte++) {
    const hex = `#${byte.toString(16).padStart(2, "0")}7f00`;
    expect(toHex(fromHex(hex))).toBe(hex);
  }
});

it("light is split in colour and strength", () => {
  const light: Rgb = [40, 20, 10];
  expect(strengthOf(light)).toBe(40);
  expect(hueOf(light)).toBe(toHex([1, 0.5, 0.25]));
  expect(hueOf([0, 0, 0])).toBe("#ffffff");
});

it("another strength leaves the colour exactly as it was", () => {
  expect(withStrength([40, 20, 10], 80, "#000000")).toEqual([80, 40, 20]);
  expect(withStrength([0, 0, 0], 3, "#ffffff")).toEqual([3, 3, 3]);
});
