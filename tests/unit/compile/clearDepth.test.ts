import { describe, expect, test } from "vitest";
import { clearDepth, type View } from "../../../src/compile/clearDepth";
import type { Shape } from "../../../src/compile/primitives";

// A camera 1000 in front of the origin; the image spans ±0.01.
const VIEW: View = { origin: [0, 0, 1000], forward: [0, 0, -1], right: [0.01, 0, 0], up: [0, 0.01, 0] };
const BALL: Shape = { kind: "sphere", center: [0, 0, 0], radius: 1 };
const plane = (point: readonly [number, number, number], normal: readonly [number, number, number]): Shape => ({
  kind: "plane",
  point,
  normal,
  axis: undefined,
});

describe("the depth in front of which a view is clear", () => {
  test("is that of the nearest shape, less a thousandth", () => {
    const depth = clearDepth([BALL, { kind: "box", center: [0, 0, -9], halfSize: [1, 1, 1], turn: 0.3 }], VIEW);
    expect(depth).toBeLessThan(999);
    expect(depth).toBeGreaterThan(997.9);
  });

  test("is 0 where a shape reaches the camera or lies behind it", () => {
    expect(clearDepth([{ ...BALL, radius: 2000 }], VIEW)).toBe(0);
    expect(clearDepth([BALL, { ...BALL, center: [0, 0, 1500] }], VIEW)).toBe(0);
  });

  test("is 0 in an empty scene", () => {
    expect(clearDepth([], VIEW)).toBe(0);
  });

  test("ends where a plane enters the image", () => {
    // A floor 2 below: the image's lower edge meets it 200 away.
    const depth = clearDepth([plane([5, -2, 7], [0, 1, 0])], VIEW);
    expect(depth).toBeLessThan(200);
    expect(depth).toBeGreaterThan(199.7);
  });

  test("does not end at a plane behind the camera, and is 0 on one", () => {
    expect(clearDepth([BALL, plane([0, 0, 1001], [0, 0, 1])], VIEW)).toBeGreaterThan(997);
    expect(clearDepth([BALL, plane([0, 0, 1000], [0, 0, 1])], VIEW)).toBe(0);
    expect(clearDepth([BALL, plane([0, 0, 1000], [0, 1, 0])], VIEW)).toBe(0);
  });
});
