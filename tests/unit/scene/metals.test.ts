import { describe, expect, test } from "vitest";
import { conductorF0, dielectricF0, metals } from "../../../src/scene/metals";
import { reflectanceToRgb } from "../../../tools/metals/colorimetry";
import { metalF0 } from "../../../tools/metals/metalF0";
import * as opticalConstants from "../../../tools/metals/opticalConstants";

const MEASURED = new Map(Object.entries(opticalConstants));

describe("F0", () => {
  test("of glass and of an index of 1", () => {
    expect(dielectricF0(1.5)).toBeCloseTo(0.04, 15);
    expect(dielectricF0(1)).toBe(0);
  });

  test("of a conductor is between 0 and 1, and 1 for a perfect one", () => {
    expect(conductorF0(0, 3)).toBe(1);
    expect(conductorF0(1, 0)).toBe(0);
    expect(conductorF0(0.13, 4.103)).toBeCloseTo(0.97, 2); // gold at 704.5 nm, Johnson & Christy 1972
  });
});

describe("colour of a spectrum", () => {
  test("a constant reflectance is grey", () => {
    expect(reflectanceToRgb(() => 1)).toEqual([1, 1, 1]);
    for (const channel of reflectanceToRgb(() => 0.25)) expect(channel).toBeCloseTo(0.25, 12);
  });

  test("a band of wavelengths has the colour of the band", () => {
    const [longRed, longGreen, longBlue] = reflectanceToRgb((nm) => (nm > 600 ? 0.5 : 0));
    expect(longRed).toBeGreaterThan(10 * Math.max(longGreen, longBlue));
    const [shortRed, shortGreen, shortBlue] = reflectanceToRgb((nm) => (nm < 490 ? 0.5 : 0));
    expect(shortBlue).toBeGreaterThan(4 * Math.max(shortRed, shortGreen));
  });

  test("what lies outside the gamut is clipped", () => {
    for (const channel of reflectanceToRgb((nm) => (nm > 480 && nm < 520 ? 1 : 0))) {
      expect(channel).toBeGreaterThanOrEqual(0);
      expect(channel).toBeLessThanOrEqual(1);
    }
  });
});

describe("metals", () => {
  test.each(Object.entries(metals))("%s is what its measured indices give, to six digits", (name, color) => {
    const constants = MEASURED.get(name.toUpperCase())!;
    for (const i of [0, 1, 2] as const) expect(color[i]).toBeCloseTo(metalF0(constants)[i], 6);
  });

  // What physicallybased.info (CC0) publishes for the same measurements, red of gold clipped. Its integration is independent
  // of ours, under D65 too. The tolerance is the fit of the matching functions (1 % of their peaks) acting on the part of a
  // reflectance that is not grey, at most 0.4 for gold, and half a unit of the third digit.
  test.each([
    ["gold", [1, 0.773, 0.307]],
    ["silver", [0.991, 0.985, 0.974]],
    ["copper", [0.932, 0.623, 0.522]],
    ["iron", [0.53, 0.513, 0.494]],
  ] as const)("%s agrees with an independent integration", (name, expected) => {
    for (const i of [0, 1, 2] as const) expect(Math.abs(metals[name][i] - expected[i])).toBeLessThan(0.004);
  });

  // The values most renderers ship (Lagarde 2011, "Feeding a physically based shading model") rest on other samples. Between
  // the samples of one metal that refractiveindex.info has, F0 varies by about 0.06, and of titanium by more than 0.1.
  test.each([
    ["gold", [1, 0.766, 0.336], 0.06],
    ["silver", [0.972, 0.96, 0.915], 0.06],
    ["copper", [0.955, 0.637, 0.538], 0.06],
    ["aluminium", [0.913, 0.921, 0.925], 0.06],
    ["iron", [0.53, 0.51, 0.49], 0.06],
    ["titanium", [0.542, 0.497, 0.449], 0.1],
    ["chromium", [0.55, 0.556, 0.554], 0.06],
  ] as const)("%s is near what is commonly used", (name, expected, tolerance) => {
    for (const i of [0, 1, 2] as const) expect(Math.abs(metals[name][i] - expected[i])).toBeLessThan(tolerance);
  });

  test("every table runs upwards and covers 390 to 780 nm", () => {
    for (const rows of Object.values(opticalConstants)) {
      const wavelengths = rows.map(([nm]) => nm);
      expect(wavelengths).toEqual([...wavelengths].sort((a, b) => a - b));
      expect(wavelengths[0]).toBeLessThan(390);
      expect(wavelengths.at(-1)).toBeGreaterThan(780);
    }
  });

  test("every metal can be a base color", () => {
    for (const color of Object.values(metals)) {
      for (const channel of color) expect(channel >= 0 && channel <= 1).toBe(true);
    }
  });
});
