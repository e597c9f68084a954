import { expect, test } from "vitest";
import { triangleBounds } from "../../../src/bvh/triangleBounds";
import { createRandom } from "../../support/random";

test("a box is that of the three vertices", () => {
  const positions = Float32Array.of(0, 0, 0, 1, 5, -1, -2, 3, 4, 9, 9, 9);
  expect([...triangleBounds(positions, Uint32Array.of(0, 1, 2, 3, 3, 3))]).toEqual([
    -2, 0, -1, 1, 5, 4, 9, 9, 9, 9, 9, 9,
  ]);
  expect([...triangleBounds(positions.subarray(0, 9))]).toEqual([-2, 0, -1, 1, 5, 4]);
  expect(triangleBounds(new Float32Array(0))).toHaveLength(0);
});

test("boxes of doubles hold them, and are the smallest that do, seed 3", () => {
  const random = createRandom(3);
  const positions = Float64Array.from({ length: 9000 }, () => (random() - 0.5) * 10 ** (80 * random() - 50));
  positions.set([0, -0, 2 ** -160, -(2 ** -160), 1, -1, 1 + 2 ** -30, -1 - 2 ** -30, 0.1]);
  const bounds = triangleBounds(positions);
  const [float, bits] = [new Float32Array(1), new Int32Array(1)];
  const nearer = new Int32Array(float.buffer);
  for (let i = 0; i < bounds.length; i++) {
    const corner = 9 * Math.trunc(i / 6) + (i % 3);
    const values = [positions[corner]!, positions[corner + 3]!, positions[corner + 6]!];
    const isLow = i % 6 < 3;
    const value = isLow ? Math.min(...values) : Math.max(...values);
    expect(isLow ? bounds[i]! <= value : bounds[i]! >= value).toBe(true);
    if (bounds[i] === value || bounds[i] === 0) continue;
    // The next float towards the value lies beyond it.
    float[0] = bounds[i]!;
    bits[0] = nearer[0]!;
    nearer[0] = bits[0]! + (isLow === bounds[i]! > 0 ? 1 : -1);
    expect(isLow ? float[0]! > value : float[0]! < value, `${bounds[i]} for ${value}`).toBe(true);
  }
});

test("what is wrong with positions or indices is said", () => {
  expect(() => triangleBounds(new Float32Array(9), Uint32Array.of(0, 1, 3))).toThrow(
    "indices[2]: expected a vertex below 3, got 3",
  );
  expect(() => triangleBounds(new Float32Array(9), Uint32Array.of(0, 1))).toThrow(
    "indices: expected 3 per triangle, got 2",
  );
  expect(() => triangleBounds(new Float32Array(10))).toThrow(
    "positions: expected 3 numbers per vertex, got 10 numbers",
  );
});
