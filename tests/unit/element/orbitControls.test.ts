import { expect, it } from "vitest";
import { wheelZoom } from "../../../src/element/orbitControls";

it("a notch of the wheel down moves away, up moves nearer, by the same factor", () => {
  expect(wheelZoom(100, false, false)).toBeGreaterThan(1.1);
  expect(wheelZoom(100, false, false) * wheelZoom(-100, false, false)).toBeCloseTo(1);
});

it("lines count for more than pixels, and so do the small steps of a pinch", () => {
  expect(wheelZoom(3, true, false)).toBeGreaterThan(wheelZoom(3, false, false));
  expect(wheelZoom(3, false, true)).toBeGreaterThan(wheelZoom(3, false, false));
});

it.each([1e9, -1e9, Number.POSITIVE_INFINITY])("one event of %d never throws the camera far", (delta) => {
  const factor = wheelZoom(delta, true, true);
  expect(factor).toBeGreaterThan(0.5);
  expect(factor).toBeLessThan(2);
});
