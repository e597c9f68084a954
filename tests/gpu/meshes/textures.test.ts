import { describe, expect, test } from "vitest";
import type { Material, Scene, Texture } from "../../../src/scene/schema";
import { cardScene, WHITE_SKY } from "../../support/card";
import { renderScene } from "../../support/device";

const SIZE = 33; // odd: there is a pixel in the middle

/** A square that fills the picture under a white sky, with texture coordinates from `from` to `to`, v downwards. */
function quadScene(material: Material, textures: Readonly<Record<string, Texture>>, from = 0, to = 1): Scene {
  const uvs = [from, to, to, to, to, from, from, from];
  return cardScene(material, { uvs }, { textures, ...WHITE_SKY });
}

const texel = (...rgb: readonly number[]) => [...rgb, 255];
const linear = (byte: number) => (byte <= 10 ? byte / 255 / 12.92 : ((byte / 255 + 0.055) / 1.055) ** 2.4);

/** A pixel by its place in the picture, from the top left, each in 0…1. */
function pixelAt(image: Float32Array, x: number, y: number): number[] {
  const at = 4 * (Math.floor(y * SIZE) * SIZE + Math.floor(x * SIZE));
  return [...image.subarray(at, at + 3)];
}

const render = async (scene: Scene, samples = 64) => (await renderScene(scene, { size: [SIZE, SIZE], samples })).image;

// Under a white sky a matte surface shows its albedo, whatever direction is sampled: rounding is the only error.
const CLOSE = 4;

describe("base colour, seed 1", () => {
  const corners = [texel(255, 0, 10), texel(128, 64, 200), texel(1, 2, 3), texel(250, 240, 230)];
  const four: Texture = { width: 2, height: 2, texels: corners.flat(), filter: "nearest" };

  test("is sRGB, its rows from the top, and multiplies the material's", async () => {
    const image = await render(quadScene({ baseColor: [1, 0.5, 1], baseColorTexture: "t" }, { t: four }));
    for (const [i, [r, g, b]] of corners.entries()) {
      const shown = pixelAt(image, 0.25 + 0.5 * (i % 2), i < 2 ? 0.25 : 0.75);
      const expected = [linear(r!), 0.5 * linear(g!), linear(b!)];
      for (const c of [0, 1, 2]) expect(shown[c], `texel ${i}`).toBeCloseTo(expected[c]!, CLOSE);
    }
  });

  test("is interpolated as light, not as bytes", async () => {
    const image = await render(quadScene({ baseColorTexture: "t" }, { t: { ...four, filter: "linear" } }));
    const middle = pixelAt(image, 0.5, 0.5);
    for (const c of [0, 1, 2] as const) {
      const mean = corners.reduce((sum, corner) => sum + linear(corner[c]!), 0) / 4;
      expect(middle[c]).toBeCloseTo(mean, 2); // the pixel is a 16th of a texel wide, and its samples are not its middle
    }
  });

  test.each([
    ["repeat", "abababab"],
    ["mirror", "abbaabba"],
    ["clamp", "aaaabbbb"],
  ] as const)("%s continues it beyond its edges", async (wrapU, pattern) => {
    const [a, b] = [255, 0];
    const texture: Texture = {
      width: 2,
      height: 1,
      texels: [...texel(a, a, a), ...texel(b, b, b)],
      wrapU,
      filter: "nearest",
    };
    const from = wrapU === "clamp" ? -1.5 : -2; // from a's beginning, or so that the edges are in the middle
    const image = await render(quadScene({ baseColorTexture: "t" }, { t: texture }, from, from + 4));
    const shown = Array.from(pattern, (_, i) => (pixelAt(image, (i + 0.5) / 8, 0.5)[0]! > 0.5 ? "a" : "b")).join("");
    expect(shown).toBe(pattern);
  });
});

test("green is roughness and blue is metal, linear", async () => {
  const texture: Texture = { width: 1, height: 1, texels: texel(7, 51, 102) };
  const textured = quadScene(
    { ior: 1.5, baseColor: [0.9, 0.5, 0.1], metallic: 1, metallicRoughnessTexture: "t" },
    { t: texture },
  );
  const plain = quadScene({ ior: 1.5, baseColor: [0.9, 0.5, 0.1], roughness: 0.2, metallic: 0.4 }, {});
  const images = [await render(textured), await render(plain)];
  for (const c of [0, 1, 2])
    expect(pixelAt(images[0]!, 0.5, 0.5)[c]).toBeCloseTo(pixelAt(images[1]!, 0.5, 0.5)[c]!, CLOSE);
});

test.each([0, 0.5, 1])("a mirror, metal by %d, is one with a texture too, seed 1", async (metallic) => {
  const texture: Texture = { width: 1, height: 1, texels: texel(255, 128, 64) };
  const mirror: Material = { ior: 1.5, roughness: 0, metallic };
  const images = [
    await render(quadScene({ ...mirror, baseColorTexture: "t" }, { t: texture })),
    await render(quadScene({ ...mirror, baseColor: [1, linear(128), linear(64)] }, {})),
  ];
  for (const c of [0, 1, 2])
    expect(pixelAt(images[0]!, 0.5, 0.5)[c]).toBeCloseTo(pixelAt(images[1]!, 0.5, 0.5)[c]!, CLOSE);
});

test("emission is the texture's colour, seen and as light on others, seed 1", async () => {
  // The left half of the lamp shines.
  const texture: Texture = {
    width: 2,
    height: 1,
    texels: [...texel(255, 255, 255), ...texel(0, 0, 0)],
    filter: "nearest",
  };
  const lamp = quadScene({ baseColor: [0, 0, 0], emission: [3, 2, 1], emissionTexture: "t" }, { t: texture });
  const seen = await render({ ...lamp, environment: {}, maxBounces: 0 });
  expect(pixelAt(seen, 0.25, 0.5)).toEqual([3, 2, 1]);
  expect(pixelAt(seen, 0.75, 0.5)).toEqual([0, 0, 0]);

  const lit = (objects: Scene["objects"], materials: Scene["materials"]): Scene => ({
    camera: { position: [0, 4, 3], target: [0, 0, 3], up: [0, 0, -1] },
    textures: { t: texture },
    materials: { floor: { ior: 1 }, ...materials },
    objects: [...objects, { type: "plane", point: [0, -1.5, 0], normal: [0, 1, 0], material: "floor" }],
    maxBounces: 1,
  });
  const half = { type: "quad", corner: [-1, -1, 0], edge1: [1, 0, 0], edge2: [0, 2, 0], material: "half" } as const;
  const black = { type: "quad", corner: [0, -1, 0], edge1: [1, 0, 0], edge2: [0, 2, 0], material: "dark" } as const;
  const dark = { baseColor: [0, 0, 0], ior: 1 } as const;
  const mean = async (scene: Scene) => {
    const image = await render(scene, 1024);
    return image.reduce((sum, value, i) => (i % 4 === 0 ? sum + value : sum), 0) / SIZE ** 2;
  };
  const textured = await mean(lit(lamp.objects, lamp.materials));
  const halved = await mean(lit([half, black], { dark, half: { ...dark, emission: [3, 2, 1] } }));
  // 10⁶ samples each, of a relative standard deviation below 2: 0.3 % is what chance leaves, with 40 % of room.
  expect(Math.abs(textured / halved - 1)).toBeLessThan(0.004);
});

describe("a normal texture, seed 1", () => {
  // 45° to the right, or upwards; and a light from there.
  const tilted = Math.round(127.5 * (1 + Math.SQRT1_2));
  test.each([
    ["red leans along growing u", texel(tilted, 128, tilted), [1, 0]],
    ["green leans up, along falling v", texel(128, tilted, tilted), [0, 1]],
  ] as const)("%s", async (_, texels, [x, y]) => {
    const scene = quadScene({ normalTexture: "t" }, { t: { width: 1, height: 1, texels } });
    const lightAt = (side: number): Scene => ({
      ...scene,
      environment: {},
      lights: [{ type: "point", position: [side * 100 * x, side * 100 * y, 100], power: [4e5, 4e5, 4e5] }],
    });
    const albedoOverPi = 1 / Math.PI;
    const intensity = 4e5 / (4 * Math.PI) / 2e4;
    // Bytes tell the direction to half a per cent, and the quad is a hundredth of the light's distance.
    expect(pixelAt(await render(lightAt(1)), 0.5, 0.5)[0]! / (albedoOverPi * intensity)).toBeCloseTo(1, 1.7);
    expect(pixelAt(await render(lightAt(-1)), 0.5, 0.5)[0]).toBeLessThan(0.02 * albedoOverPi * intensity);
  });

  test("of no tilt changes nothing", async () => {
    const texels = texel(128, 128, 255);
    const bent = await render(quadScene({ normalTexture: "t" }, { t: { width: 1, height: 1, texels } }));
    expect(pixelAt(bent, 0.5, 0.5)[0]).toBeCloseTo(1, 2);
  });
});
