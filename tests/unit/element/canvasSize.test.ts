import { describe, expect, it } from "vitest";
import { boxOfEntry, canvasSize, DEFAULT_LIMITS } from "../../../src/element/canvasSize";

const UNLIMITED = { maxSide: Number.POSITIVE_INFINITY, maxPixels: Number.POSITIVE_INFINITY };

describe("canvasSize", () => {
  it("multiplies CSS pixels by the pixel ratio and rounds", () => {
    expect(canvasSize({ width: 320.4, height: 239.7, pixelRatio: 1.5 })).toEqual({ width: 481, height: 360 });
  });

  it("prefers the physical pixels that the browser tells", () => {
    const box = { width: 100, height: 50, pixelRatio: 1.5, device: { width: 151, height: 74 } };
    expect(canvasSize(box)).toEqual({ width: 151, height: 74 });
  });

  it.each([
    [0, 0],
    [-5, 10],
    [Number.NaN, 20],
    [Number.POSITIVE_INFINITY, 20],
  ])("gives at least one pixel for a box of %d × %d", (width, height) => {
    const size = canvasSize({ width, height, pixelRatio: 1 });
    expect(size.width).toBeGreaterThanOrEqual(1);
    expect(size.height).toBeGreaterThanOrEqual(1);
    expect(Number.isInteger(size.width) && Number.isInteger(size.height)).toBe(true);
  });

  it("keeps under the default limits in the same proportions", () => {
    const size = canvasSize({ width: 3840, height: 2160, pixelRatio: 2 });
    expect(size.width * size.height).toBeLessThanOrEqual(DEFAULT_LIMITS.maxPixels);
    expect(size.width * size.height).toBeGreaterThan(0.99 * DEFAULT_LIMITS.maxPixels);
    expect(size.width / size.height).toBeCloseTo(16 / 9, 2);
  });

  it("caps the longer side", () => {
    const size = canvasSize({ width: 20_000, height: 10, pixelRatio: 1 }, { ...UNLIMITED, maxSide: 8192 });
    expect(size).toEqual({ width: 8192, height: 4 });
  });
});

describe("boxOfEntry", () => {
  const contentRect = { width: 300, height: 200 } as DOMRectReadOnly;

  it("reads physical pixels where there are any", () => {
    const entry = { contentRect, devicePixelContentBoxSize: [{ inlineSize: 601, blockSize: 399 }] };
    expect(boxOfEntry(entry as unknown as ResizeObserverEntry, 2)).toEqual({
      width: 300,
      height: 200,
      pixelRatio: 2,
      device: { width: 601, height: 399 },
    });
  });

  it("does without them in Safari", () => {
    const entry = { contentRect } as unknown as ResizeObserverEntry;
    expect(boxOfEntry(entry, 2)).toEqual({ width: 300, height: 200, pixelRatio: 2 });
  });
});
