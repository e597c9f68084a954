import { readFileSync } from "node:fs";
import { afterAll, describe, expect, test } from "vitest";
import type { Scene, SceneObject, Vec3 } from "../../../src/scene/schema";
import { renderScene } from "../../support/device";
import { randomScene } from "../../support/randomScene";
import { LONG } from "../../support/stability";
import { recordStability, type StabilityRow } from "../../support/stabilityRows";

const SIZE = 24;
const SAMPLES = 12;
const rows: StabilityRow[] = [];

describe("no sample is lost, whatever the size of things", () => {
  test("a lamp of 5·10⁻¹⁴ m", async () => {
    const quad: SceneObject = {
      type: "quad",
      corner: [-2.5e-14, 9.9e-14, -2.5e-14],
      edge1: [5e-14, 0, 0],
      edge2: [0, 0, 5e-14],
      material: "lamp",
    };
    const floor: SceneObject = { type: "plane", point: [0, -1e-13, 0], normal: [0, 1, 0], material: "white" };
    await expectNoBadSamples({
      camera: { position: [0, 0, 3.9e-13], target: [0, 0, 0], verticalFov: 39.3 },
      materials: { lamp: { baseColor: [0, 0, 0], ior: 1, emission: [17, 12, 4] }, white: { ior: 1 } },
      objects: [quad, floor],
    });
  });

  test("a mesh of 10⁻¹¹ m that emits, with normals and textures", async () => {
    const texels = [0, 37, 74, 111, 148, 185, 222, 3, 40, 77, 114, 151, 188, 225, 6, 43];
    await expectNoBadSamples({
      camera: { position: [0, 1e-11, 4e-11], target: [0, 5e-12, 0] },
      environment: { radiance: [0.1, 0.2, 0.3] },
      textures: { t: { width: 2, height: 2, texels }, n: { width: 1, height: 1, texels: [200, 100, 180, 255] } },
      materials: {
        tex: {
          baseColorTexture: "t",
          normalTexture: "n",
          metallicRoughnessTexture: "t",
          emission: [1, 1, 1],
          emissionTexture: "t",
        },
      },
      objects: [
        {
          type: "mesh",
          positions: [-5e-12, 0, 5e-12, 5e-12, 0, 5e-12, 0, 1e-11, 5e-12],
          indices: [0, 1, 2],
          uvs: [0, 0, 1, 0, 0, 1],
          normals: [0, 0, 1, 0, 0.3, 1, 0.2, 0, 1],
          material: "tex",
        },
      ],
    });
  });

  test.each([-1, 1])("a mesh that emits, with a vertex at %s·10¹⁸ m", async (side) => {
    const strip: Vec3[] = [
      [side * 1e18, 1.48, 0.06],
      [0.47, 1.47, 0.08],
      [0.3, 1.48, 0.02],
      [0.4, 1.57, -0.01],
      [0.42, 1.4, 0.17],
    ];
    await expectNoBadSamples({
      camera: { position: [0, 3, 4.6], target: [0, 0.75, 0], verticalFov: 36 },
      materials: { warm: { baseColor: [0.3, 0.3, 0.3], ior: 1, emission: [4, 2.8, 1.6] }, white: { ior: 1 } },
      objects: [
        { type: "mesh", positions: strip.flat(), indices: [0, 1, 2, 0, 2, 3, 0, 4, 1], material: "warm" },
        { type: "plane", point: [0, 0, 0], normal: [0, 1, 0], material: "white" },
      ],
    });
  });

  test.each(Array.from({ length: 12 * LONG }, (_, i) => i + 1))("a random scene, seed %d", async (seed) => {
    const { scene } = randomScene(seed);
    await expectNoBadSamples(scene, seed);
  });
});

const cornell = JSON.parse(
  readFileSync(new URL("../../reference/scenes/cornell.json", import.meta.url), "utf8"),
) as Scene;

test.each([-56, -36, 36, 56])("cornell scaled by 2^%d is the same picture, to the bit", async (exponent) => {
  const options = { size: [SIZE, SIZE] as const, samples: SAMPLES };
  // At 2^∓20 both are measured in units of their own, which differ by a power of two.
  const { image: expected } = await renderScene(scaled(cornell, 2 ** (20 * Math.sign(exponent))), options);
  const { image, stats } = await renderScene(scaled(cornell, 2 ** exponent), options);
  expect(stats.badSamples).toBe(0);
  expect(image).toEqual(expected);
  expect(Math.max(...image)).toBeGreaterThan(1);
});

afterAll(() => recordStability("sizes", rows));

async function expectNoBadSamples(scene: Scene, seed?: number): Promise<void> {
  const { image, stats } = await renderScene(scene, { size: [SIZE, SIZE], samples: SAMPLES, ...(seed && { seed }) });
  rows.push({
    case: seed
      ? `A random scene of any size, seed ${seed}`
      : `${expect.getState().currentTestName!.split("> ").at(-1)}`,
    asserted: "0 bad samples",
    inputs: SIZE * SIZE * SAMPLES,
    worst: `${stats.badSamples} bad samples`,
  });
  expect(stats.badSamples).toBe(0);
  expect(image.every(Number.isFinite)).toBe(true);
}

function scaled({ camera, objects, ...rest }: Scene, factor: number): Scene {
  const point = (p: Vec3) => p.map((x) => x * factor) as unknown as Vec3;
  return {
    ...rest,
    camera: { ...camera, position: point(camera.position), target: point(camera.target ?? [0, 0, 0]) },
    objects: objects!.map((object) => {
      if (object.type === "quad") {
        const { corner, edge1, edge2 } = object;
        return { ...object, corner: point(corner), edge1: point(edge1), edge2: point(edge2) };
      }
      if (object.type === "box") return { ...object, center: point(object.center), size: point(object.size) };
      throw new RangeError(`cornell has no ${object.type}`);
    }),
  };
}
