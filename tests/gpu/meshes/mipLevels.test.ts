// Which mip level a look-up takes: told from a texture of checks, which are black and white in level 0 and grey in all others.

import { describe, expect, test } from "vitest";
import type { Texture } from "../../../src/scene/schema";
import { cardScene } from "../../support/card";
import { renderScene } from "../../support/device";

const SIZE = 64;
/** The byte nearest to half the light, and its light. */
const GREY = ((188 / 255 + 0.055) / 1.055) ** 2.4;

/** Black and green checks of one texel, all of them red. */
function checks(width: number, height: number, look: Partial<Texture> = {}): Texture {
  const texels = Array.from({ length: width * height }, (_, i) => {
    const isLit = ((i % width) + Math.floor(i / width)) % 2 === 0;
    return [255, isLit ? 255 : 0, 0, 255];
  });
  return { width, height, texels: texels.flat(), filter: "nearest", ...look };
}

/**
 * The share of grey among the pixels of a card that show the texture, and their number. The picture shows `texels` of it by its side,
 * of a card that is turned away until it is `cosine` as high.
 */
async function greyOf(
  texture: Texture,
  texels: number,
  { cosine = 1, samples = 1, from = 0, orthographic = false } = {},
) {
  const [u, v] = [texels / texture.width, texels / texture.height];
  const tilt = Math.sqrt(1 - cosine ** 2);
  const scene = cardScene(
    { baseColor: [0, 0, 0], emission: [1, 1, 1], emissionTexture: "checks" },
    {
      positions: [-1, -cosine, -tilt, 1, -cosine, -tilt, 1, cosine, tilt, -1, cosine, tilt],
      uvs: [from, from + v, from + u, from + v, from + u, from, from, from],
    },
    { textures: { checks: texture }, maxBounces: 0 },
  );
  const camera = orthographic ? { ...scene.camera, orthographicHeight: 2 } : scene.camera;
  const { image } = await renderScene({ ...scene, camera }, { size: [SIZE, SIZE], samples });
  let [grey, count] = [0, 0];
  for (let i = 0; i < image.length; i += 4) {
    if (image[i]! < 0.999) continue; // beside the card
    count++;
    if (Math.abs(image[i + 1]! - GREY) < 1e-4) grey++;
  }
  return { share: grey / count, count };
}

/** Four standard errors of a share, and what the perspective of a camera 100 away from a card of 2 does to the logarithm of distances. */
const tolerance = (share: number, count: number) => 4 * Math.sqrt((share * (1 - share)) / count) + 0.015;

describe("the first sample of a pixel", () => {
  test.each([
    [1, 1],
    [1.2, 1],
    [1.5, 1],
    [1.9, 1],
    [1, 0.5],
    [1, 0.3],
    [0.5, 0.25],
    [0.25, 0.5],
  ])(
    "that %f texels are as wide as, seen at a cosine of %f, takes the level of its area, seed 1",
    async (perPixel, cosine) => {
      for (const orthographic of [false, true]) {
        const { share, count } = await greyOf(checks(8, 8), perPixel * SIZE, { cosine, orthographic });
        // Of a pixel's area in texels, the level is half the logarithm; between two levels it says how often the larger one is taken.
        const level = Math.log2((perPixel * perPixel) / cosine) / 2;
        const expected = Math.min(Math.max(level, 0), 1);
        expect(count).toBeGreaterThan(0.9 * cosine * SIZE * SIZE);
        expect(Math.abs(share - expected)).toBeLessThanOrEqual(tolerance(expected, count));
      }
    },
  );

  test("of a card as large as its texture takes none but level 0, seed 1", async () => {
    expect((await greyOf(checks(SIZE, SIZE), SIZE)).share).toBe(0);
    expect((await greyOf(checks(8, 8), SIZE / 4)).share).toBe(0);
  });

  test.each(["repeat", "mirror", "clamp"] as const)("sees no seams of far textures that %s, seed 1", async (wrap) => {
    for (const [width, height] of [
      [8, 8],
      [6, 10],
      [1, 8],
      [12, 1],
    ] as const) {
      const texture = checks(width, height, { wrapU: wrap, wrapV: wrap, filter: "linear" });
      expect((await greyOf(texture, 4 * SIZE, { from: -2.5 })).share).toBe(1);
    }
  });
});

test("an edge is blurred within a pixel in the first sample, and no more than between its texels in the end, seed 1", async () => {
  const [width, half] = [4 * SIZE, 2 * SIZE];
  const texels = Array.from({ length: width }, (_, x) => (x < half ? [255, 0, 0, 255] : [255, 255, 0, 255])).flat();
  const scene = cardScene(
    { baseColor: [0, 0, 0], emission: [1, 1, 1], emissionTexture: "halves" },
    // As many texels high as wide: one row again and again.
    { uvs: [0, width, 1, width, 1, 0, 0, 0] },
    { textures: { halves: { width, height: 1, texels, wrapU: "clamp" } }, maxBounces: 0 },
  );
  const besideEdge = async (samples: number) => {
    const { image } = await renderScene(scene, { size: [SIZE, SIZE], samples });
    let sum = 0;
    for (let y = 0; y < SIZE; y++) sum += image[4 * (SIZE * y + SIZE / 2 - 1) + 1]! / SIZE;
    return sum;
  };
  // Half of a texel beside the edge, light grows to one half: an eighth of what a texel is wide. In the first sample that is the pixel;
  // of 64 rows' means of such a value, which scatters by 0.17, four standard errors are 0.083.
  expect(Math.abs((await besideEdge(1)) - 1 / 8)).toBeLessThan(0.083);
  // In the end a texel is a quarter of the pixel. Of 1024 samples 2 · 8 stood for more than that.
  expect(Math.abs((await besideEdge(1024)) - 1 / 32)).toBeLessThan(16 / 1024 / 8 + 0.002);
});
