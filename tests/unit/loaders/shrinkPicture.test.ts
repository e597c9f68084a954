import { expect, test } from "vitest";
import { shrinkPicture } from "../../../src/loaders/gltf/shrinkPicture";
import { isKept } from "../../../src/scene/keptBytes";
import { createRandom } from "../../support/random";

const linearOf = (c: number) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
const srgbOf = (c: number) => (c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055);

/** The mean of the rectangle that a texel covers, by the definition. */
function meanOf(value: (x: number, y: number) => number, [left, right]: number[], [top, bottom]: number[]): number {
  let sum = 0;
  for (let y = Math.floor(top!); y < bottom!; y++) {
    for (let x = Math.floor(left!); x < right!; x++) {
      const columns = Math.min(x + 1, right!) - Math.max(x, left!);
      const rows = Math.min(y + 1, bottom!) - Math.max(y, top!);
      sum += columns * rows * value(x, y);
    }
  }
  return sum / ((right! - left!) * (bottom! - top!));
}

test.each([
  [
    [8, 8],
    [4, 4],
  ],
  [
    [8, 6],
    [2, 1],
  ],
  [
    [7, 5],
    [3, 2],
  ],
  [
    [13, 1],
    [3, 1],
  ],
  [
    [9, 30],
    [1, 3],
  ],
] as const)(
  "%j to %j is the mean of what each texel covers, of light and of data, seed 1",
  async ([w, h], [width, height]) => {
    const random = createRandom(1);
    const texels = Uint8Array.from({ length: 4 * w * h }, () => Math.floor(256 * random()));
    for (const isColor of [true, false]) {
      const small = await shrinkPicture({ width: w, height: h, texels }, [width, height], isColor, undefined);
      expect([small.width, small.height, small.texels.length]).toEqual([width, height, 4 * width * height]);
      const expected = Array.from(small.texels, (_, i) => {
        const [x, y, channel] = [Math.floor(i / 4) % width, Math.floor(i / 4 / width), i % 4];
        const isLight = isColor && channel < 3;
        const value = (column: number, row: number) => {
          const byte = texels[4 * (row * w + column) + channel]!;
          return isLight ? linearOf(byte / 255) : byte;
        };
        const mean = meanOf(
          value,
          [(x * w) / width, ((x + 1) * w) / width],
          [(y * h) / height, ((y + 1) * h) / height],
        );
        return Math.round(isLight ? 255 * srgbOf(mean) : mean);
      });
      expect([...small.texels]).toEqual(expected);
    }
  },
);

test("black and white are half the light, and half as data", async () => {
  const texels = Uint8Array.of(0, 0, 0, 0, 255, 255, 255, 255);
  const colour = await shrinkPicture({ width: 2, height: 1, texels }, [1, 1], true, undefined);
  expect([...colour.texels]).toEqual([188, 188, 188, 128]);
  const data = await shrinkPicture({ width: 2, height: 1, texels }, [1, 1], false, undefined);
  expect([...data.texels]).toEqual([128, 128, 128, 128]);
});

test("a picture of one value keeps it, whatever it is", async () => {
  for (let byte = 0; byte < 256; byte++) {
    const texels = new Uint8Array(4 * 7 * 7).fill(byte);
    const small = await shrinkPicture({ width: 7, height: 7, texels }, [3, 3], true, undefined);
    expect(new Set(small.texels)).toEqual(new Set([byte]));
  }
});

test("the result is not copied again when it is shown", async () => {
  const image = { width: 2, height: 2, texels: new Uint8Array(16) };
  expect(isKept((await shrinkPicture(image, [1, 1], false, undefined)).texels)).toBe(true);
});

test("a signal ends it, between slices", async () => {
  const image = { width: 2048, height: 2048, texels: new Uint8Array(4 * 2048 * 2048) };
  const controller = new AbortController();
  const shrinking = shrinkPicture(image, [1024, 1024], true, controller.signal);
  setTimeout(() => controller.abort(new Error("enough")));
  await expect(shrinking).rejects.toThrow("enough");
});

test("no slice of a large picture takes long", async () => {
  const image = { width: 4096, height: 1024, texels: new Uint8Array(4 * 4096 * 1024) };
  let isDone = false;
  let longestMs = 0;
  const watch = async () => {
    while (!isDone) {
      const start = process.cpuUsage();
      await new Promise((resolve) => setImmediate(resolve));
      longestMs = Math.max(longestMs, process.cpuUsage(start).user / 1000);
    }
  };
  const watching = watch();
  await shrinkPicture(image, [2048, 512], true, undefined);
  isDone = true;
  await watching;
  expect(longestMs).toBeLessThan(100); // 16 slices of about 5 ms, or one of 80 and more
});
