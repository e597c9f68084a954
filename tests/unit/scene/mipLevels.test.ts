import { describe, expect, test } from "vitest";
import { bsdfColumns } from "../../../src/lobes/lobes";
import { lesserLevels, levelSizes, texelsOfLevels } from "../../../src/scene/mipLevels";
import { COLOR_TEXTURES } from "../../../src/scene/names";
import { parseScene } from "../../../src/scene/parseScene";
import { prepareGeometry } from "../../../src/tree/geometry";
import { cardScene } from "../../support/card";
import { createRandom } from "../../support/random";

const linearOf = (c: number) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
const srgbOf = (c: number) => (c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055);

/** A picture in doubles, as light. */
type Doubles = { readonly width: number; readonly height: number; readonly values: Float64Array };

/** The next level by the definition: of each texel the mean of the rectangle that it covers. */
function boxFiltered({ width, height, values }: Doubles): Doubles {
  const [w, h] = [Math.max(1, Math.floor(width / 2)), Math.max(1, Math.floor(height / 2))];
  const result = new Float64Array(4 * w * h);
  const overlap = (i: number, from: number, to: number) => Math.min(i + 1, to) - Math.max(i, from);
  for (let y = 0; y < h; y++) {
    for (let x = 0; x < w; x++) {
      const [left, right, top, bottom] = [
        (x * width) / w,
        ((x + 1) * width) / w,
        (y * height) / h,
        ((y + 1) * height) / h,
      ];
      for (let j = Math.floor(top); j < bottom; j++) {
        for (let i = Math.floor(left); i < right; i++) {
          const weight = (overlap(i, left, right) * overlap(j, top, bottom)) / ((right - left) * (bottom - top));
          for (let c = 0; c < 4; c++) result[4 * (y * w + x) + c]! += weight * values[4 * (j * width + i) + c]!;
        }
      }
    }
  }
  return { width: w, height: h, values: result };
}

function randomPicture(width: number, height: number, seed: number) {
  const random = createRandom(seed);
  return { width, height, texels: Uint8Array.from({ length: 4 * width * height }, () => Math.floor(256 * random())) };
}

const SIZES = [
  [16, 16],
  [13, 7],
  [5, 1],
  [1, 12],
  [64, 2],
  [1, 1],
] as const;

describe.each(SIZES)("a picture of %i × %i", (width, height) => {
  test("has levels down to one texel", () => {
    const sizes = levelSizes(width, height);
    expect(sizes[0]).toEqual([width, height]);
    expect(sizes.at(-1)).toEqual([1, 1]);
    expect(sizes.length).toBe(1 + Math.floor(Math.log2(Math.max(width, height))));
    expect(texelsOfLevels(width, height)).toBe(sizes.reduce((sum, [w, h]) => sum + w * h, 0));
  });

  test.each([true, false])("has levels that are means of it, as colours: %s, seed 3", async (isColor) => {
    const picture = randomPicture(width, height, 3);
    const isLight = (c: number) => isColor && c % 4 < 3;
    const light = Float64Array.from(picture.texels, (byte, c) => (isLight(c) ? linearOf(byte / 255) : byte / 255));
    let exact: Doubles = { width, height, values: light };
    const levels = await lesserLevels(picture, isColor, undefined);
    expect(levels.length).toBe(levelSizes(width, height).length - 1);
    for (const [i, level] of levels.entries()) {
      exact = boxFiltered(exact);
      expect(level.length).toBe(exact.values.length);
      for (const [c, value] of exact.values.entries()) {
        const byte = 255 * (isLight(c) ? srgbOf(value) : value);
        // Every level rounds by half a byte, and a mean of bytes is off by no more than they are; of light too: the mean of b^1.4, by
        // which b's errors count, is at most that of b^2.4 to the power of 1.4/2.4. The hundredth is for the line that sRGB begins with.
        expect(Math.abs(level[c]! - byte)).toBeLessThanOrEqual(0.5 * (i + 1) + 0.01);
      }
    }
  });
});

test("a picture of one colour has levels of that colour", async () => {
  for (let byte = 0; byte < 256; byte++) {
    const picture = { width: 3, height: 5, texels: new Uint8Array(60).fill(byte) };
    for (const level of await lesserLevels(picture, true, undefined)) expect(new Set(level)).toEqual(new Set([byte]));
  }
});

test("the textures that lobes read as colours are averaged as colours", () => {
  const everything = new Proxy({}, { get: () => true }) as Parameters<typeof bsdfColumns>[0];
  const read = bsdfColumns(everything).flatMap(([, { texture }]) => (texture?.[1] === "color" ? [texture[0]] : []));
  expect(new Set(COLOR_TEXTURES)).toEqual(new Set(["baseColorTexture", "emissionTexture", ...read]));
});

describe("the texels of a scene", () => {
  const checks = { width: 2, height: 1, texels: [0, 0, 0, 255, 255, 255, 255, 255] };
  const prepare = async (material: object, previous?: Awaited<ReturnType<typeof prepareGeometry>>) =>
    prepareGeometry(parseScene(cardScene(material, { uvs: [0, 1, 1, 1, 1, 0, 0, 0] }, { textures: { checks } })), {
      previous,
    });

  test("are averaged as light where a material reads a colour, as bytes elsewhere", async () => {
    const color = await prepare({ baseColorTexture: "checks" });
    const data = await prepare({ normalTexture: "checks" }, color);
    const both = await prepare(
      { baseColorTexture: "checks", normalTexture: { texture: "checks", scale: [2, 2] } },
      data,
    );
    const means = [color, data, both].map((geometry) => geometry!.data.texels!.map((level) => level[0]));
    expect(means).toEqual([
      [0, 188],
      [0, 128],
      [0, 188],
    ]);
  });

  test("stay where only vertices move", async () => {
    const before = await prepare({ baseColorTexture: "checks" });
    const scene = cardScene(
      { baseColorTexture: "checks" },
      { uvs: [0, 1, 1, 1, 1, 0, 0, 1] },
      { textures: { checks } },
    );
    const after = await prepareGeometry(parseScene(scene), { previous: before });
    expect(after).not.toBe(before);
    expect(after!.data.texels).toBe(before!.data.texels);
  });
});
