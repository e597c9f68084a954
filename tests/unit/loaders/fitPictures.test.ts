import { expect, test } from "vitest";
import { fitPictures, halved } from "../../../src/loaders/gltf/fitPictures";
import { createRandom } from "../../support/random";

const square = (side: number, copies = 1) => ({ width: side, height: side, copies });
const MIB = 2 ** 20;

test("what fits stays", () => {
  expect(fitPictures([square(4096), square(2048)], 80 * MIB)).toEqual([0, 0]);
  expect(fitPictures([], 0)).toEqual([]);
});

test("the largest are halved first, and no more than needed", () => {
  expect(fitPictures([square(1024), square(4096), square(2048)], 84 * MIB)).toEqual([0, 0, 0]);
  expect(fitPictures([square(1024), square(4096), square(2048)], 84 * MIB - 1)).toEqual([0, 1, 0]);
  expect(fitPictures([square(1024), square(4096), square(2048)], 12 * MIB)).toEqual([0, 2, 1]);
  expect(fitPictures(Array(5).fill(square(4096)), 128 * MIB)).toEqual([1, 1, 1, 1, 0]);
});

test("a picture in several textures counts for each", () => {
  expect(fitPictures([square(1024, 3)], 12 * MIB)).toEqual([0]);
  expect(fitPictures([square(1024, 3)], 12 * MIB - 1)).toEqual([1]);
});

test("no side is longer than a scene allows", () => {
  expect(fitPictures([{ width: 40_000, height: 1, copies: 1 }], 128 * MIB)).toEqual([2]);
  expect(halved({ width: 40_000, height: 1 }, 2)).toEqual([10_000, 1]);
});

test("any pictures fit in the end, seed 5", () => {
  const random = createRandom(5);
  for (let i = 0; i < 100; i++) {
    const side = () => Math.ceil(2 ** (14 * random()));
    const pictures = Array.from({ length: 40 }, () => ({
      width: side(),
      height: side(),
      copies: 1 + Math.floor(3 * random()),
    }));
    const budget = 2 ** (10 + 20 * random());
    const halvings = fitPictures(pictures, budget);
    const bytesOf = (i: number, times: number) => {
      const [width, height] = halved(pictures[i]!, times);
      return 4 * width * height * pictures[i]!.copies;
    };
    const bytes = halvings.reduce((sum, times, i) => sum + bytesOf(i, times), 0);
    expect(bytes).toBeLessThanOrEqual(budget);
    // The last halving was needed: it was of one of the smallest that were halved.
    const gains = halvings.flatMap((times, i) => (times > 0 ? [bytesOf(i, times - 1) - bytesOf(i, times)] : []));
    if (gains.length > 0) expect(bytes + Math.max(...gains)).toBeGreaterThan(budget);
  }
});

test("a hundred thousand pictures take no minutes", () => {
  const start = performance.now();
  fitPictures(
    Array.from({ length: 1e5 }, (_, i) => square(1 + (i % 4096))),
    128 * MIB,
  );
  expect(performance.now() - start).toBeLessThan(4000);
});
