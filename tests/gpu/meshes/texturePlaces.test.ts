// Textures in places of their own: a set of texture coordinates, scale, turn and offset for each.

import { describe, expect, test } from "vitest";
import { PathTracer } from "../../../src/renderer/pathTracer";
import type { Material, Scene, Texture } from "../../../src/scene/schema";
import { cardScene } from "../../support/card";
import { renderScene, testDevice } from "../../support/device";

type Uv = readonly [number, number];
type Place = { uv?: 0 | 1; offset?: Uv; scale?: Uv; rotation?: number };

const SIZE = 24;
const CORNERS = [
  [0, 1],
  [1, 1],
  [1, 0],
  [0, 0],
] as const;

/** Two sets that have nothing in common, by a place in the picture from its top left, 0…1. */
const SETS = [
  (x: number, y: number): Uv => [x, y],
  (x: number, y: number): Uv => [2 * y - 0.5, 0.25 - 0.5 * x],
] as const;

/** Scaled, then turned counter-clockwise where v points down, then moved. */
function transformed([u, v]: Uv, { offset = [0, 0], scale = [1, 1], rotation = 0 }: Place): Uv {
  const [cos, sin] = [Math.cos((rotation * Math.PI) / 180), Math.sin((rotation * Math.PI) / 180)];
  const [a, b] = [u * scale[0], v * scale[1]];
  return [cos * a + sin * b + offset[0], cos * b - sin * a + offset[1]];
}

/** A square of 2 × 2 that fills the picture. */
function square(
  material: Material,
  textures: Scene["textures"],
  sets: readonly ((x: number, y: number) => Uv)[] = SETS,
): Scene {
  const [uvs, uvs1] = sets.map((set) => CORNERS.flatMap(([x, y]) => set(x, y)));
  return cardScene(material, { uvs: uvs!, ...(uvs1 && { uvs1 }) }, { textures, maxBounces: 0 });
}

/** Pictures of scenes that have one program. */
async function picturesOf(scenes: readonly Scene[], samples: number): Promise<Float32Array[]> {
  const tracer = await PathTracer.create({ scene: scenes[0]!, width: SIZE, height: SIZE, device: await testDevice() });
  const pictures: Float32Array[] = [];
  for (const scene of scenes) {
    await tracer.setScene(scene);
    await tracer.sample(samples);
    pictures.push(await tracer.readRadiance());
  }
  tracer.dispose();
  return pictures;
}

const linear = (byte: number) => (byte <= 10 ? byte / 255 / 12.92 : ((byte / 255 + 0.055) / 1.055) ** 2.4);

/** 4 × 3 texels, each of another grey. */
const [WIDTH, HEIGHT] = [4, 3];
const GREYS = Array.from({ length: WIDTH * HEIGHT }, (_, i) => 25 + 20 * i);
const grid: Texture = {
  width: WIDTH,
  height: HEIGHT,
  texels: GREYS.flatMap((grey) => [grey, grey, grey, 255]),
  filter: "nearest",
};
const glowing = (place: Place): Material => ({
  baseColor: [0, 0, 0],
  emission: [1, 1, 1],
  emissionTexture: { texture: "t", ...place },
});

/** The texel in a row of `count` that texel `i` of an endless row shows. */
function wrapped(i: number, count: number, how: Texture["wrapU"]): number {
  if (how === "clamp") return Math.min(count - 1, Math.max(0, i));
  const within = ((i % (2 * count)) + 2 * count) % (2 * count);
  if (how === "mirror") return within < count ? within : 2 * count - 1 - within;
  return within % count;
}

const PLACES: readonly Place[] = [
  { offset: [0.25, 0] },
  { offset: [-1.5, 2.375] },
  { scale: [2, 0.5] },
  { scale: [-1, 1] },
  { scale: [1.5, -2], offset: [0.125, 0.75] },
  { rotation: 90 },
  { rotation: -90, offset: [0.5, 0] },
  { rotation: 180 },
  { rotation: 30 },
  { rotation: -100, scale: [-3, 2], offset: [0.3, -0.7] },
];

describe.each([
  ["repeat", "repeat"],
  ["mirror", "clamp"],
  ["clamp", "mirror"],
] as const)("a texture that %ss along u and %ss along v", (wrapU, wrapV) => {
  test("lies where scale, rotation and offset put it, on both sets, seed 1", async () => {
    const places = PLACES.flatMap((place) => [place, { ...place, uv: 1 as const }]);
    const textures = { t: { ...grid, wrapU, wrapV } };
    const pictures = await picturesOf(
      places.map((place) => square(glowing(place), textures)),
      4,
    );
    for (const [i, place] of places.entries()) {
      const texelAt = (x: number, y: number): Uv => {
        const [u, v] = transformed(SETS[place.uv ?? 0]!(x / SIZE, y / SIZE), place);
        return [Math.floor(u * WIDTH), Math.floor(v * HEIGHT)];
      };
      let checked = 0;
      for (let y = 0; y < SIZE; y++) {
        for (let x = 0; x < SIZE; x++) {
          // Only pixels that lie in one texel, and further from its edges than rounding moves them.
          const e = 1e-3;
          const texels = [texelAt(x + e, y + e), texelAt(x + 1 - e, y + e), texelAt(x + e, y + 1 - e)];
          const [column, row] = texelAt(x + 1 - e, y + 1 - e);
          if (texels.some((texel) => texel[0] !== column || texel[1] !== row)) continue;
          checked++;
          const grey = GREYS[WIDTH * wrapped(row, HEIGHT, wrapV) + wrapped(column, WIDTH, wrapU)]!;
          const shown = pictures[i]![4 * (SIZE * y + x)]!;
          // Greys differ by 5 % at least.
          expect(Math.abs(shown / linear(grey) - 1), `${JSON.stringify(place)} at ${x}, ${y}`).toBeLessThan(1e-3);
        }
      }
      expect(checked).toBeGreaterThan(SIZE ** 2 / 8);
    }
  });
});

test("the example of KHR_texture_transform: the lower left quadrant, turned clockwise by 90°, seed 1", async () => {
  const texels = Array.from({ length: 16 }, (_, i) => 10 * i + 20);
  const texture: Texture = { width: 4, height: 4, texels: texels.flatMap((t) => [t, t, t, 255]), filter: "nearest" };
  const place = { offset: [0, 1], rotation: 90, scale: [0.5, 0.5] } as const;
  const [picture] = await picturesOf([square(glowing(place), { t: texture })], 4);
  const shown = [0.25, 0.75].flatMap((y) => [0.25, 0.75].map((x) => picture![4 * SIZE * (SIZE * y + x)]!));
  // Of the quadrant's texels 8 9 / 12 13 the lower left one is now at the upper left.
  for (const [i, texel] of [12, 8, 13, 9].entries()) expect(shown[i]).toBeCloseTo(linear(texels[texel]!), 5);
});

test("the second set of a mesh that also has colours, normals and tangents is the same, seed 1", async () => {
  const plain = square(glowing({ uv: 1, scale: [1, 2] }), { t: grid });
  const four = (...values: number[]) => Array.from({ length: 4 }, () => values).flat();
  const more = { colors: four(0.5, 0.25, 1, 1), normals: four(0, 0, 1), tangents: four(1, 0, 0, 1) };
  const full = { ...plain, objects: plain.objects.map((object) => ({ ...object, ...more })) } as Scene;
  const [[expected], [shown]] = [await picturesOf([plain], 4), await picturesOf([full], 4)];
  const difference = shown!.map((value, i) => Math.abs(value - expected![i]!));
  expect(Math.max(...difference)).toBeLessThan(1e-6);
  expect(new Set(expected!.filter((_, i) => i % 4 === 0)).size).toBeGreaterThan(4);
});

test("textures of one material lie in different places and have different texels, seed 1", async () => {
  const color = (...rgb: number[]) => [...rgb, 255];
  const halves: Texture = {
    width: 2,
    height: 1,
    texels: [...color(255, 255, 255), ...color(0, 0, 0)],
    filter: "nearest",
  };
  const scene = square(
    {
      baseColorTexture: { texture: "a", rotation: 90 },
      metallicRoughnessTexture: { texture: "m", scale: [9, 9] },
      emission: [2, 0, 0],
      emissionTexture: "a",
    },
    { m: { width: 1, height: 1, texels: color(0, 255, 0) }, a: halves },
    [SETS[0]],
  );
  const [picture] = await picturesOf([{ ...scene, environment: { radiance: [1, 1, 1] }, maxBounces: 1 }], 16);
  // Turned by 90°, u grows with v: the upper half is white.
  const at = (x: number, y: number) => [0, 1].map((c) => picture![4 * (SIZE * y + x) + c]!);
  for (const [x, y, red, green] of [
    [6, 6, 3, 1],
    [18, 6, 1, 1],
    [6, 18, 2, 0],
    [18, 18, 0, 0],
  ] as const) {
    expect(at(x, y)[0]).toBeCloseTo(red, 4);
    expect(at(x, y)[1]).toBeCloseTo(green, 4);
  }
});

describe("a normal texture", () => {
  // Along the texture's own u and against its v.
  const [red, green, blue] = [190, 90, 220];
  const told = [red, green, blue].map((byte) => (2 * byte) / 255 - 1);
  const length = Math.hypot(...told);
  const places: readonly Place[] = [
    { scale: [10, 10] },
    { scale: [-1, 1] },
    { scale: [1, -3] },
    { scale: [-2, -2], offset: [0.3, 0.1] },
    { rotation: 90 },
    { rotation: -90, scale: [-1, 1] },
    { rotation: 180 },
    { rotation: 30 },
    { rotation: 130, scale: [2, -2] },
    { rotation: 30, scale: [1, 4] },
  ];
  const lights = [
    [100, 0, 100],
    [0, 100, 100],
    [-60, -80, 100],
  ] as const;

  test("leans along its own u and v, scaled, turned or mirrored, on both sets, seed 1", async () => {
    const all = places.flatMap((place) => [place, { ...place, uv: 1 as const }]);
    const scenes = all.flatMap((place) =>
      lights.map((position): Scene => {
        const material = { normalTexture: { texture: "n", ...place } };
        const textures = { n: { width: 1, height: 1, texels: [red, green, blue, 255] } };
        return {
          ...square(material, textures),
          lights: [{ type: "point", position, power: [1e6, 1e6, 1e6] }],
          maxBounces: 1,
        };
      }),
    );
    const pictures = await picturesOf(scenes, 1);
    for (const [i, place] of all.entries()) {
      // How far one goes on the surface for a step along u, the other coordinate kept: the inverse of what a step there makes.
      const own = (x: number, y: number) => transformed(SETS[place.uv ?? 0]!((x + 1) / 2, (1 - y) / 2), place);
      const [o, alongX, alongY] = [own(0, 0), own(1, 0), own(0, 1)];
      const [a, b, c, d] = [alongX[0] - o[0], alongY[0] - o[0], alongX[1] - o[1], alongY[1] - o[1]];
      const determinant = a * d - b * c;
      const size = Math.hypot(d, c) * Math.sign(determinant);
      const tangent = [d / size, -c / size] as const;
      // Square to it, on the side where v falls.
      const fall = (-b * -tangent[1] + a * tangent[0]) / determinant < 0 ? 1 : -1;
      const bitangent = [-tangent[1] * fall, tangent[0] * fall] as const;
      const normal = [0, 1].map((axis) => (told[0]! * tangent[axis]! + told[1]! * bitangent[axis]!) / length);
      for (const [j, [x, y, z]] of lights.entries()) {
        const distance = Math.hypot(x, y, z);
        const cosine = (normal[0]! * x + normal[1]! * y + (told[2]! / length) * z) / distance;
        const expected = (Math.max(0, cosine) * 1e6) / (4 * Math.PI * distance ** 2) / Math.PI;
        const picture = pictures[lights.length * i + j]!;
        // The middle of the picture; the square is a hundredth of the light's distance, so one pixel's place is worth 1e-3.
        const shown = picture[4 * (SIZE * (SIZE / 2) + SIZE / 2)]!;
        const full = 1e6 / (4 * Math.PI * distance ** 2) / Math.PI;
        expect(Math.abs(shown - expected) / full, `${JSON.stringify(place)}, light ${j}`).toBeLessThan(2e-3);
      }
    }
  });
});

describe("light", () => {
  const [on, off] = [
    [255, 255, 255, 255],
    [0, 0, 0, 0],
  ];
  const halves: Texture = { width: 2, height: 1, texels: [...on!, ...off!], filter: "nearest" };

  test("comes from where a texture in its place glows, seed 1", async () => {
    const room = (lamp: Scene["objects"], materials: Scene["materials"]): Scene => ({
      camera: { position: [3, 4, 3], target: [3, 0, 3], up: [0, 0, -1] },
      textures: { t: halves },
      materials: { floor: { ior: 1 }, ...materials },
      objects: [...lamp, { type: "plane", point: [0, -1.5, 0], normal: [0, 1, 0], material: "floor" }],
      maxBounces: 1,
    });
    const mean = async (scene: Scene) => {
      const { image } = await renderScene(scene, { size: [SIZE, SIZE], samples: 1024 });
      return image.reduce((sum, value, i) => (i % 4 === 0 ? sum + value : sum), 0) / SIZE ** 2;
    };
    const lamp = square({ ...glowing({ offset: [0.5, 0], scale: [-1, 1], uv: 1 }), emission: [3, 3, 3] }, {}, [
      () => [0.1, 0.1],
      (x) => [x + 1, 0.5],
    ]);
    const textured = await mean(room(lamp.objects, lamp.materials));
    const dark = { baseColor: [0, 0, 0], ior: 1 } as const;
    const quad = (x: number, material: string) =>
      ({ type: "quad", corner: [x, -1, 0], edge1: [1, 0, 0], edge2: [0, 2, 0], material }) as const;
    const half = (x: number) =>
      room([quad(x, "lit"), quad(-1 - x, "dark")], { dark, lit: { ...dark, emission: [3, 3, 3] } });
    // u = 0.5 − (x + 1) is between −1 and −0.5, where the texture is white, in the left half.
    const [left, right] = [await mean(half(-1)), await mean(half(0))];
    expect(Math.abs(right / left - 1)).toBeGreaterThan(0.05);
    // 6·10⁵ samples each, of a relative standard deviation below 2: 0.4 % is what chance leaves, with 40 % of room.
    expect(Math.abs(textured / left - 1)).toBeLessThan(0.006);
  });

  test("passes where the alpha of a texture in its place leaves holes, seen and as a shadow, seed 1", async () => {
    // Half of a black card hides half of a wall, and shades it; a lamp of irradiance π is far in front.
    const scene = (offset: Uv): Scene => {
      const card = square(
        { baseColor: [0, 0, 0], alphaMode: "mask", baseColorTexture: { texture: "t", offset } },
        { t: halves },
        [SETS[0]],
      );
      return {
        ...card,
        materials: { ...card.materials, wall: { ior: 1 } },
        objects: [
          ...card.objects,
          { type: "quad", corner: [-9, -9, -1], edge1: [18, 0, 0], edge2: [0, 18, 0], material: "wall" },
        ],
        lights: [{ type: "point", position: [0, 0, 1e4], power: [4e8 * Math.PI ** 2, 0, 0] }],
        maxBounces: 1,
      };
    };
    // From behind the card too: its shadow is on the wall.
    const behind = (offset: Uv): Scene => ({
      ...scene(offset),
      camera: { position: [0, 0, -0.01], target: [0, 0, -1], verticalFov: 80 },
    });
    const pictures = await picturesOf([scene([0, 0]), scene([0.5, 0]), behind([0, 0]), behind([0.5, 0])], 4);
    const at = (picture: Float32Array, x: number) => picture[4 * (SIZE * (SIZE / 2) + x)]!;
    for (const [i, [left, right]] of [
      [0, 1],
      [1, 0],
      [0, 1],
      [1, 0],
    ].entries()) {
      expect(at(pictures[i]!, 6)).toBeCloseTo(left!, 3);
      expect(at(pictures[i]!, 18)).toBeCloseTo(right!, 3);
    }
  });
});
