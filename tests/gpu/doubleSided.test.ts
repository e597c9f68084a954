// Surfaces that emit from both sides, and those that show their colour whatever the light.

import { describe, expect, test } from "vitest";
import type { Material, Scene, SceneObject, Vec3 } from "../../src/scene/schema";
import { cardScene } from "../support/card";
import { renderScene, renderSeeds, seedsFrom } from "../support/device";

const SIZE = 16;
const SEEDS = seedsFrom(1, 8);

const GLOW: Material = { baseColor: [0, 0, 0], ior: 1, emission: [3, 2, 1] };
const material = "lamp";
/** The front looks down. The back of a lamp of two parts is a millimetre above it, so that none hides the other. */
const SHAPES: Readonly<Record<string, (isBack: boolean) => SceneObject>> = {
  triangle: (isBack) => ({ type: "triangle", vertices: corners(isBack), material }),
  quad: (isBack) => {
    const edges = [[2, 0, 0.2] as const, [0, 0.1, 2] as const] as const;
    const [edge1, edge2] = isBack ? [edges[1], edges[0]] : edges;
    return { type: "quad", corner: [-1, isBack ? 0.501 : 0.5, -1], edge1, edge2, material };
  },
  mesh: (isBack) => ({ type: "mesh", positions: corners(isBack).flat(), indices: [0, 1, 2], material }),
};

function corners(isBack: boolean): [Vec3, Vec3, Vec3] {
  const y = isBack ? 0.501 : 0.5;
  const [a, b, c] = [[-1, y, -1] as const, [1, y, -1] as const, [1, y, 1] as const];
  return isBack ? [a, c, b] : [a, b, c];
}

/** A lamp in a glossy room without light, and a lamp that shines downwards only, so that lights are chosen among. */
function room(lamp: readonly SceneObject[], doubleSided: boolean): Scene {
  return {
    camera: { position: [0, 0.6, 4], target: [0, 0.5, 0], verticalFov: 50 },
    materials: { lamp: { ...GLOW, doubleSided }, one: GLOW, wall: { baseColor: [0.6, 0.7, 0.8], roughness: 0.4 } },
    objects: [
      { type: "plane", point: [0, -1, 0], normal: [0, 1, 0], material: "wall" },
      { type: "plane", point: [0, 2, 0], normal: [0, -1, 0], material: "wall" },
      { type: "quad", corner: [1.5, 1, 0], edge1: [0.3, 0, 0], edge2: [0, 0, 0.3], material: "one" },
      ...lamp,
    ],
    maxBounces: 2,
  };
}

async function meanOf(scene: Scene, estimator: "path" | "uniform") {
  const renders = await renderSeeds(scene, { size: [SIZE, SIZE], samples: 64, seeds: SEEDS, settings: { estimator } });
  const means = renders.map(
    ({ image }) => image.reduce((sum, value, i) => (i % 4 === 0 ? sum + value : sum), 0) / SIZE ** 2,
  );
  const mean = means.reduce((sum, value) => sum + value, 0) / SEEDS.length;
  const variance = means.reduce((sum, value) => sum + (value - mean) ** 2, 0) / (SEEDS.length - 1) / SEEDS.length;
  return { mean, variance };
}

describe.each(Object.entries(SHAPES))("a double-sided %s, seeds 1–8", (_name, shape) => {
  test.each(["path", "uniform"] as const)("gives the light of two back to back, estimator %s", async (estimator) => {
    const one = await meanOf(room([shape(false)], true), estimator);
    const two = await meanOf(room([shape(false), shape(true)], false), "path");
    const sigma = Math.sqrt(one.variance + two.variance);
    // Student's t with 7 degrees of freedom is below 5.41 with probability 0.999.
    expect(Math.abs(one.mean - two.mean)).toBeLessThan(5.41 * sigma);
    expect(sigma).toBeLessThan(0.01 * two.mean); // or the comparison would say nothing
  });
});

describe("an unlit surface, seed 1", () => {
  const scene = (card: Material, more: Partial<Scene> = {}) =>
    cardScene(
      { ...card, unlit: true },
      { uvs: [0, 1, 1, 1, 1, 0, 0, 0] },
      {
        lights: [{ type: "point", position: [0, 0, 3], power: [500, 500, 500] }],
        environment: { radiance: [1, 2, 3] },
        ...more,
      },
    );
  const colors = async (shown: Scene) => {
    const { image } = await renderScene(shown, { size: [SIZE, SIZE], samples: 16 });
    return [4, 12].map((x) =>
      [...image.slice(4 * (8 * SIZE + x), 4 * (8 * SIZE + x) + 3)].map((value) => Number(value.toFixed(5))),
    );
  };
  const COLOR = [0.2, 0.6, 0.25] as const;

  test("shows its colour, whatever else it is made of, from both sides", async () => {
    const unlit: Material = { baseColor: COLOR, metallic: 0.5, roughness: 0, emission: [9, 9, 9] };
    expect(await colors(scene(unlit))).toEqual([[...COLOR], [...COLOR]]);
    const behind = { ...scene(unlit).camera, position: [0, 0, -100] } as const;
    expect(await colors(scene(unlit, { camera: behind }))).toEqual([[...COLOR], [...COLOR]]);
  });

  test("shows its texture, and holes where that has some", async () => {
    const texels = [255, 0, 255, 255, 0, 255, 0, 0];
    const textures = { t: { width: 2, height: 1, texels, filter: "nearest" as const } };
    expect(await colors(scene({ baseColor: COLOR, baseColorTexture: "t", alphaMode: "mask" }, { textures }))).toEqual([
      [0.2, 0, 0.25],
      [1, 2, 3],
    ]);
  });
});
