import { describe, expect, test } from "vitest";
import { buildBvh, MAX_DEPTH } from "../../../src/bvh/buildBvh";
import { boxSoup, faults } from "../../support/bvh";
import { createRandom } from "../../support/random";

const MAX_LEAVES = [1, 2, 4, 8, 255];

/** Boxes from their corners. */
const boxes = (...rows: readonly (readonly number[])[]): Float32Array => Float32Array.from(rows.flat());
const repeat = (count: number, box: (i: number) => readonly number[]): Float32Array =>
  boxes(...Array.from({ length: count }, (_, i) => box(i)));
/** A cube without size at x, or with one. */
const cubeAt = (x: number, size = 0): number[] => [x, x, x, x + size, x + size, x + size];

describe("a tree keeps its promises", () => {
  test.each(MAX_LEAVES)("over boxes at random, at most %i to a leaf, seeds 1 to 40", (maxLeaf) => {
    for (let seed = 1; seed <= 40; seed++) {
      const random = createRandom(seed);
      const bounds = boxSoup(random, Math.trunc(4 ** (5 * random())), random() ** 3);
      expect(faults(buildBvh(bounds, { maxLeaf }), bounds, maxLeaf), `seed ${seed}`).toEqual([]);
    }
  });

  const random = createRandom(11);
  const flat = (axis: number) => boxSoup(random, 500).map((value, i) => (i % 3 === axis ? 0.25 : value));
  const degenerate: readonly (readonly [string, Float32Array])[] = [
    ["nothing", new Float32Array(0)],
    ["one primitive", boxes([0, 1, 2, 3, 4, 5])],
    ["one point", boxes([1, 1, 1, 1, 1, 1])],
    ["two of the same", boxes(cubeAt(1, 1), cubeAt(1, 1))],
    ["1000 of the same", repeat(1000, () => cubeAt(1, 1))],
    ["1000 in one point", repeat(1000, () => cubeAt(3))],
    ["1000 in one point at the origin, some at −0", repeat(1000, (i) => cubeAt(i % 3 ? 0 : -0))],
    ["points on a line", repeat(1000, (i) => [i, 0, 0, i, 0, 0])],
    ["points on a diagonal", repeat(1000, (i) => cubeAt((i * 389) % 1000))],
    ["all in the plane x = ¼", flat(0)],
    ["all in the plane y = ¼", flat(1)],
    ["all in the plane z = ¼", flat(2)],
    ["every one twice", Float32Array.from([...boxSoup(createRandom(5), 300), ...boxSoup(createRandom(5), 300)])],
    ["boxes around one centre", repeat(300, (i) => [-i, -i, -i, i, i, i])],
    ["the smallest numbers", boxSoup(random, 300).map((value) => value * 2 ** -140)],
    ["the largest numbers", boxSoup(random, 300).map((value) => (value - 0.5) * 3e38)],
    ["one far outlier", Float32Array.from([...boxSoup(random, 300), ...cubeAt(1e30, 1)])],
    ["long thin boxes", boxSoup(random, 500).map((value, i) => (i % 3 === 0 ? (i % 6 < 3 ? -50 : 50) : value))],
  ];
  test.each(degenerate)("over %s", (_, bounds) => {
    for (const maxLeaf of MAX_LEAVES) expect(faults(buildBvh(bounds, { maxLeaf }), bounds, maxLeaf)).toEqual([]);
  });

  // Binning cuts off little from such rows: without a bound the tree would be as deep as they are long.
  const steep: readonly (readonly [string, Float32Array])[] = [
    ["points at 2^−i", repeat(140, (i) => cubeAt(2 ** -i))],
    ["points at 2^−i, each of a hundred", repeat(14_000, (i) => cubeAt(2 ** -(i % 140)))],
    ["boxes of 2^−i at 2^−i", repeat(140, (i) => cubeAt(2 ** -i, 2 ** -i))],
    ["points at ±2^i", repeat(250, (i) => cubeAt((i % 2 ? 1 : -1) * 2 ** (i / 2 - 10)))],
    [
      "points at 2^−i on each axis",
      repeat(420, (i) => [0, 1, 2, 0, 1, 2].map((axis) => (axis === i % 3 ? 2 ** -(i / 3) : 0))),
    ],
  ];
  test.each(steep)(`no deeper than ${MAX_DEPTH} over %s`, (_, bounds) => {
    for (const maxLeaf of MAX_LEAVES) expect(faults(buildBvh(bounds, { maxLeaf }), bounds, maxLeaf)).toEqual([]);
    expect(buildBvh(bounds, { maxLeaf: 1 }).depth).toBeLessThanOrEqual(MAX_DEPTH);
  });
});

describe("building", () => {
  test("leaves the given bounds alone and gives the same tree again", () => {
    const bounds = boxSoup(createRandom(2), 1000);
    const before = bounds.slice();
    const once = buildBvh(bounds);
    expect(bounds).toEqual(before);
    expect(buildBvh(bounds)).toEqual(once);
  });

  test("says which primitive is not finite", () => {
    for (const value of [Number.NaN, Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY]) {
      for (let i = 0; i < 6; i++) {
        const bounds = boxSoup(createRandom(3), 10);
        bounds[6 * 7 + i] = value;
        expect(() => buildBvh(bounds)).toThrow(RangeError);
        expect(() => buildBvh(bounds)).toThrow(/^bounds of primitive 7: expected finite numbers, got \[/);
      }
    }
  });

  test("says which box is inside out, and that numbers are left over", () => {
    expect(() => buildBvh(boxes(cubeAt(0, 1), cubeAt(2, -1)))).toThrow(
      "bounds of primitive 1: expected minima not above maxima, got [2, 2, 2, 1, 1, 1]",
    );
    expect(() => buildBvh(new Float32Array(7))).toThrow("bounds: expected 6 numbers per primitive, got 7 numbers");
  });

  test.each([0, 256, 1.5, Number.NaN])("refuses leaves of %d", (maxLeaf) => {
    expect(() => buildBvh(new Float32Array(6), { maxLeaf })).toThrow(
      `maxLeaf: expected an integer from 1 to 255, got ${maxLeaf}`,
    );
  });

  test("reports progress that grows to 1", () => {
    const fractions: number[] = [];
    buildBvh(boxSoup(createRandom(4), 5000), { onProgress: (fraction) => fractions.push(fraction) });
    expect(fractions.length).toBeGreaterThan(20);
    expect(fractions.every((fraction, i) => fraction > (fractions[i - 1] ?? 0))).toBe(true);
    expect(fractions.at(-1)).toBe(1);
  });
});
