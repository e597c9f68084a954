import { describe, expect, test } from "vitest";
import { dualWithRim, inCommonOrder, towardsMiddle, withRim } from "../../../src/shapes/rims";

describe("rims", () => {
  test("are a few ULP of the coordinates at the edge", () => {
    const [x, y, z] = withRim([1, -2, 0], [0, 6, -4]);
    expect(x - 1).toBeCloseTo(2 ** -21, 15);
    expect(y - 2).toBeCloseTo(8 * 2 ** -21, 15);
    expect(z).toBeCloseTo(4 * 2 ** -21, 15);
  });

  test("shorten duals by as much", () => {
    // A half edge of length 2 that ends 2 + 6 from the origin: u = 1 at 2·(1 + 4·2⁻²¹).
    expect(1 / dualWithRim([0.5, 0, 0], [6, 0, 0])[0]).toBeCloseTo(2 * (1 + 4 * 2 ** -21), 12);
  });
});

describe("points are drawn to the middle", () => {
  test("by more than a shape's rim", () => {
    expect((1 - towardsMiddle([6, 0, 0], 2, 2)) * 2).toBeGreaterThan(4 * 8 * 2 ** -21);
  });

  test("by no more than 2⁻¹⁶, however thin the shape", () => {
    expect(1 - towardsMiddle([1e5, 0, 0], 1e-9, 1)).toBe(2 ** -16);
  });
});

test("triangles with a common edge agree on its direction, as f32 keeps it", () => {
  const [a, b, c, d] = [
    [1, 0, 0],
    [1 + 1e-12, -1, 0],
    [0, 5, 0],
    [2, 0, 1],
  ] as const;
  expect(inCommonOrder([a, b, c])).toEqual([c, b, a]);
  expect(inCommonOrder([d, a, b])).toEqual([b, a, d]);
});
