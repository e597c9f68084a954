// Surfaces that are there in part. What a ray of light meets is told by closed forms: 1 − α of it passes each layer.

import { describe, expect, test } from "vitest";
import { PathTracer } from "../../src/renderer/pathTracer";
import type { Material, Scene, SceneObject, Texture } from "../../src/scene/schema";
import { renderScene, testDevice } from "../support/device";

const SIZE = 16;
const SAMPLES = 256;

const BLACK: Material = { baseColor: [0, 0, 0], ior: 1 };
const [OWN, BEHIND] = [2, 1];
/** Emits `OWN` from its front where it is there. */
const layer = (alpha: number): Material => ({ ...BLACK, emission: [OWN, OWN, OWN], alpha, alphaMode: "blend" });
const wall: SceneObject = {
  type: "quad",
  corner: [-50, -50, -9],
  edge1: [100, 0, 0],
  edge2: [0, 100, 0],
  material: "wall",
};

const material = "layer";
/** Each fills the picture; how often a ray meets it, its front first. */
const SHAPES: Readonly<Record<string, readonly [crossings: number, object: SceneObject]>> = {
  quad: [1, { type: "quad", corner: [-3, -3, 0], edge1: [6, 0, 0], edge2: [0, 6, 0], material }],
  triangle: [
    1,
    {
      type: "triangle",
      vertices: [
        [-9, -9, 0],
        [9, -9, 0],
        [0, 9, 0],
      ],
      material,
    },
  ],
  plane: [1, { type: "plane", point: [0, 0, 0], normal: [0.1, 0, 1], material }],
  sphere: [2, { type: "sphere", center: [0, 0, -2], radius: 3, material }],
  box: [2, { type: "box", center: [0, 0, -2], size: [6, 6, 2], material }],
  "turned box": [2, { type: "box", center: [0, 0, -3], size: [6, 6, 4], rotationY: 20, material }],
  mesh: [1, { type: "mesh", positions: [-9, -9, 0, 9, -9, 0, 0, 9, 0], indices: [0, 1, 2], material }],
};
/** So many that they are in a tree, below everything. */
const CROWD = Array.from(
  { length: 40 },
  (_, i): SceneObject => ({ type: "sphere", center: [i - 20, -30, 0], radius: 0.4, material: "wall" }),
);

function through(objects: readonly SceneObject[], alpha: number): Scene {
  return {
    camera: { position: [0, 0, 5], target: [0, 0, 0], verticalFov: 20 },
    materials: { layer: layer(alpha), wall: { ...BLACK, emission: [BEHIND, BEHIND, BEHIND] } },
    objects: [...objects, wall],
    maxBounces: 0,
  };
}

/** The mean of each scene's picture; quick where they differ in values only. */
async function meansOf(scenes: readonly Scene[], samples = SAMPLES): Promise<number[]> {
  const device = await testDevice();
  const tracer = await PathTracer.create({ scene: scenes[0]!, width: SIZE, height: SIZE, device });
  const means: number[] = [];
  for (const scene of scenes) {
    await tracer.setScene(scene);
    await tracer.sample(samples);
    const image = await tracer.readRadiance();
    means.push(image.reduce((sum, value, i) => (i % 4 === 0 ? sum + value : sum), 0) / SIZE ** 2);
  }
  tracer.dispose();
  return means;
}

const ALPHAS = [0, 0.25, 1];

/** Four standard deviations of the mean of values of which each is `a` with probability p, else `b`; and the rounding of f32. */
const chance = (p: number, a: number, b: number) =>
  4 * Math.abs(a - b) * Math.sqrt((p * (1 - p)) / (SIZE ** 2 * SAMPLES)) + 1e-6;

describe.each(Object.entries(SHAPES))("a %s of alpha α, seed 1", (name, [crossings, object]) => {
  test.each([
    ["unrolled", []],
    ...(/^(quad|sphere|box|mesh)$/.test(name) ? [["in a tree", CROWD] as const] : []),
  ] as const)("shows α of itself and lets the rest through, %s", async (_where, others) => {
    const means = await meansOf(ALPHAS.map((alpha) => through([object, ...others], alpha)));
    for (const [i, alpha] of ALPHAS.entries()) {
      const passes = (1 - alpha) ** crossings;
      const expected = alpha * OWN + passes * BEHIND;
      // Layers are met independently, and the far side of a closed shape, which does not emit, is black.
      expect(Math.abs(means[i]! - expected), `α = ${alpha}`).toBeLessThanOrEqual(
        chance(alpha, OWN, 0) + chance(passes, BEHIND, 0),
      );
    }
  });
});

test.each([
  ["one behind the other", 0.001],
  ["in the same place", 0],
])("of 64 layers %s (1 − α)⁶⁴ of the light passes, seed 1", async (_name, gap) => {
  const layers = Array.from(
    { length: 64 },
    (_, i): SceneObject => ({ type: "quad", corner: [-3, -3, -i * gap], edge1: [6, 0, 0], edge2: [0, 6, 0], material }),
  );
  const scene = through(layers, 0.02);
  const passes = 0.98 ** 64;
  const dark = {
    ...scene,
    materials: { ...scene.materials, layer: { ...BLACK, alpha: 0.02, alphaMode: "blend" as const } },
  };
  const [shown] = await meansOf([dark]);
  expect(Math.abs(shown! - passes * BEHIND)).toBeLessThanOrEqual(chance(passes, BEHIND, 0));
});

describe("light", () => {
  // A lamp 10 m above a white floor; what hides it is in between, and too small and black to give light itself.
  const lit = (between: readonly SceneObject[], alpha: number, light?: Scene["lights"]): Scene => ({
    camera: { position: [0, 5, 0.01], target: [0, 0, 0], verticalFov: 0.5 },
    materials: { floor: { ior: 1 }, layer: { ...BLACK, alpha, alphaMode: "blend" } },
    objects: [{ type: "plane", point: [0, 0, 0], normal: [0, 1, 0], material: "floor" }, ...between],
    lights: light ?? [{ type: "point", position: [3, 10, 0], power: [1000, 1000, 1000] }],
    maxBounces: 1,
  });
  const card: SceneObject = { type: "quad", corner: [1, 5, -1], edge1: [0, 0, 2], edge2: [2, 0, 0], material };
  const ball: SceneObject = { type: "sphere", center: [1.5, 5, 0], radius: 0.9, material };
  const sphereLight: Scene["lights"] = [
    { type: "sphere", position: [3, 10, 0], radius: 0.3, power: [1000, 1000, 1000] },
  ];

  test.each<[string, readonly SceneObject[], number, Scene["lights"] | undefined]>([
    ["a card", [card], 1, undefined],
    ["a ball, twice", [ball], 2, undefined],
    ["a card before a lamp with a size", [card], 1, sphereLight],
    ["a card in a tree", [card, ...CROWD], 1, undefined],
  ])("is dimmed by %s, seed 1", async (_name, between, crossings, lights) => {
    const others = between.filter((object) => object.type === "sphere" && object.material === "wall");
    const materials = (alpha: number) => ({ ...lit([], alpha).materials, wall: BLACK });
    const [open] = await meansOf([{ ...lit(others, 1, lights), materials: materials(1) }]);
    const means = await meansOf(
      ALPHAS.map((alpha) => ({ ...lit(between, alpha, lights), materials: materials(alpha) })),
    );
    for (const [i, alpha] of ALPHAS.entries()) {
      const passes = (1 - alpha) ** crossings;
      // A lamp with a size is found in two ways, each of which is hidden with its own chance: more noise than one has, not twice.
      expect(Math.abs(means[i]! / open! - passes), `α = ${alpha}`).toBeLessThanOrEqual(2 * chance(passes, 1, 0) + 2e-3);
    }
  });

  test("of an emitter with holes is α of the whole one's, seed 1", async () => {
    const scene = (alpha: number): Scene => ({
      camera: { position: [0, 1, 0.01], target: [0, 0, 0], verticalFov: 20 },
      materials: { floor: { ior: 1 }, layer: layer(alpha) },
      objects: [
        { type: "plane", point: [0, 0, 0], normal: [0, 1, 0], material: "floor" },
        { type: "quad", corner: [-4, 2, -4], edge1: [8, 0, 0], edge2: [0, 0, 8], material },
      ],
      maxBounces: 1,
    });
    const [whole, half] = await meansOf([scene(1), scene(0.5)], 1024);
    // 2.6·10⁵ paths, whose light is 0 or OWN: a standard deviation of 0.4 % at most.
    expect(half! / whole!).toBeGreaterThan(0.49);
    expect(half! / whole!).toBeLessThan(0.51);
  });
});

describe("a mask", () => {
  const TEXELS = [0, 127, 128, 255];
  const texture: Texture = {
    width: 4,
    height: 1,
    texels: TEXELS.flatMap((alpha) => [255, 255, 255, alpha]),
    filter: "nearest",
  };
  const card = (masked: Material): Scene => ({
    ...through([], 1),
    textures: { t: texture },
    materials: {
      layer: { ...layer(1), ...masked, baseColorTexture: "t" },
      wall: { ...BLACK, emission: [BEHIND, BEHIND, BEHIND] },
    },
    objects: [
      // Texels are four columns of the picture.
      {
        type: "mesh",
        positions: [-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0],
        indices: [0, 1, 2, 0, 2, 3],
        uvs: [0, 1, 1, 1, 1, 0, 0, 0],
        material,
      },
      wall,
    ],
    camera: { position: [0, 0, 100], target: [0, 0, 0], verticalFov: (360 / Math.PI) * Math.atan(1 / 100) },
  });
  const columns = async (scene: Scene) => {
    const { image } = await renderScene(scene, { size: [SIZE, SIZE], samples: 16 });
    return TEXELS.map((_, i) => image[4 * (SIZE * 8 + 4 * i + 2)]);
  };

  test("is there where alpha is the cutoff or more, of texture and factor together, seed 1", async () => {
    const mask = { alphaMode: "mask" } as const;
    expect(await columns(card(mask))).toEqual([BEHIND, BEHIND, OWN, OWN]);
    expect(await columns(card({ ...mask, alphaCutoff: 127 / 255 }))).toEqual([BEHIND, OWN, OWN, OWN]);
    expect(await columns(card({ ...mask, alpha: 0.75 }))).toEqual([BEHIND, BEHIND, BEHIND, OWN]);
    expect(await columns(card({ ...mask, alphaCutoff: 1.5 }))).toEqual([BEHIND, BEHIND, BEHIND, BEHIND]);
    expect(await columns(card({ ...mask, alphaCutoff: 0 }))).toEqual([OWN, OWN, OWN, OWN]);
    expect(await columns(card({ alphaMode: "opaque", alpha: 0 }))).toEqual([OWN, OWN, OWN, OWN]);
  });

  test("is picked where it is there, and what is behind it elsewhere", async () => {
    const scene = card({ alphaMode: "mask" });
    const tracer = await PathTracer.create({ scene, width: SIZE, height: SIZE, device: await testDevice() });
    const picked = await Promise.all([2, 14].map((x) => tracer.pick(x, SIZE / 2)));
    expect(picked).toMatchObject([
      { kind: "object", index: 1 },
      { kind: "object", index: 0 },
    ]);
    tracer.dispose();
  });
});
