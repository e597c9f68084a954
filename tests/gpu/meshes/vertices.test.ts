// What vertices have beside their places: colours and tangents.

import { describe, expect, test } from "vitest";
import type { Mesh } from "../../../src/scene/meshes";
import type { Material, Scene, SceneObject, Vec3 } from "../../../src/scene/schema";
import { cardScene, WHITE_SKY } from "../../support/card";
import { renderScene } from "../../support/device";

const SIZE = 33; // odd: there is a pixel in the middle

/** A square that fills the picture, under a white sky. */
const quadScene = (material: Material, mesh: Partial<Mesh>, more: Partial<Scene> = {}) =>
  cardScene(material, mesh, { ...WHITE_SKY, ...more });

async function shown(scene: Scene, x = 0.5, y = 0.5): Promise<number[]> {
  const { image } = await renderScene(scene, { size: [SIZE, SIZE], samples: 64 });
  const at = 4 * (Math.floor(y * SIZE) * SIZE + Math.floor(x * SIZE));
  return [...image.subarray(at, at + 3)];
}

function expectColor(color: readonly number[], expected: Vec3, digits: number) {
  for (const c of [0, 1, 2] as const) expect(color[c]).toBeCloseTo(expected[c], digits);
}

describe("colours, seed 1", () => {
  // Red, green, blue and yellow, counter-clockwise.
  const corners = [1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1, 1, 1, 0, 1];

  test("multiply the material's, and are interpolated as light", async () => {
    const scene = quadScene({ baseColor: [1, 0.5, 1] }, { colors: corners });
    expectColor(await shown(scene), [0.5, 0.01, 0.5], 1.6); // halfway between red and blue
    expectColor(await shown(scene, 0.01, 0.98), [0.97, 0.01, 0], 1);
    expectColor(await shown(scene, 0.98, 0.98), [0, 0.48, 0.01], 1);
  });

  test("colour a metal's reflections, and multiply textures", async () => {
    const colors = Array.from({ length: 4 }, () => [0.2, 0.4, 0.6, 1]).flat();
    expectColor(await shown(quadScene({ metallic: 1, roughness: 0 }, { colors })), [0.2, 0.4, 0.6], 4);
    const textures = { t: { width: 1, height: 1, texels: [255, 255, 0, 255] } };
    const textured = quadScene({ baseColorTexture: "t" }, { colors, uvs: [0, 0, 0, 0, 0, 0, 0, 0] }, { textures });
    expectColor(await shown(textured), [0.2, 0.4, 0], 4);
  });

  test("leave meshes without any, and other shapes, as they are", async () => {
    const plain = quadScene({ baseColor: [0.5, 0.25, 0.125] }, {});
    const aside: SceneObject = {
      ...(plain.objects[0] as Mesh),
      positions: [9, 0, 0, 10, 0, 0, 9, 1, 0, 9, 1, 1],
      colors: corners,
    };
    expectColor(await shown({ ...plain, objects: [...plain.objects, aside] }), [0.5, 0.25, 0.125], 4);
    const quad: SceneObject = { type: "quad", corner: [-1, -1, 0], edge1: [2, 0, 0], edge2: [0, 2, 0], material: "m" };
    expectColor(await shown({ ...plain, objects: [quad, aside] }), [0.5, 0.25, 0.125], 4);
  });

  test("have an alpha, which makes holes", async () => {
    const colors = Array.from({ length: 4 }, () => [1, 0, 0, 0.4]).flat();
    expectColor(await shown(quadScene({ alphaMode: "mask" }, { colors })), [1, 1, 1], 4);
    expectColor(await shown(quadScene({ alphaMode: "mask", alphaCutoff: 0.3 }, { colors })), [1, 0, 0], 4);
    expectColor(await shown(quadScene({}, { colors })), [1, 0, 0], 4);
  });

  test("are what an unlit surface shows, and no other emission's", async () => {
    const colors = Array.from({ length: 4 }, () => [0.2, 0.4, 0.6, 1]).flat();
    expectColor(await shown(quadScene({ unlit: true, baseColor: [0.5, 1, 1] }, { colors })), [0.1, 0.4, 0.6], 4);
    const glow: Material = { baseColor: [0, 0, 0], emission: [3, 2, 1] };
    expectColor(await shown(quadScene(glow, { colors })), [3, 2, 1], 4);
  });

  test("of an unlit surface are in the light that it gives", async () => {
    const colors = Array.from({ length: 4 }, () => [0.2, 0.4, 0.6, 1]).flat();
    const lamp = (material: Material, mesh: Partial<Mesh>): Scene => {
      const scene = quadScene(material, mesh, { environment: {} });
      return {
        ...scene,
        camera: { position: [0, 2, 6], target: [0, 0, 2], verticalFov: 1 },
        materials: { ...scene.materials, floor: { ior: 1 } },
        objects: [...scene.objects, { type: "plane", point: [0, -1, 0], normal: [0, 1, 0], material: "floor" }],
      };
    };
    const unlit = await shown(lamp({ unlit: true }, { colors }));
    const glow = await shown(lamp({ baseColor: [0, 0, 0], emission: [0.2, 0.4, 0.6], doubleSided: true }, {}));
    for (const c of [0, 1, 2]) expect(unlit[c]).toBeCloseTo(glow[c]!, 5);
    expect(unlit[2]).toBeGreaterThan(0.01);
  });
});

describe("tangents, seed 1", () => {
  // Every texel leans 45° along growing u; a light from the right, at 45°, as far as it is bright.
  const lean = Math.round(127.5 * (1 + Math.SQRT1_2));
  const textures = { t: { width: 1, height: 1, texels: [lean, 128, lean, 255] } };
  const lights: Scene["lights"] = [{ type: "point", position: [1e4, 0, 1e4], power: [1e10, 1e10, 1e10] }];
  const normals = [0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1];
  const uvs = [0, 1, 1, 1, 1, 0, 0, 0];
  const red = async (tangents?: readonly number[], texels?: readonly number[]) => {
    const given = texels ? { t: { ...textures.t, texels } } : textures;
    const mesh = { normals, uvs, ...(tangents && { tangents: Array.from({ length: 4 }, () => tangents).flat() }) };
    const scene = quadScene({ normalTexture: "t" }, mesh, { textures: given, lights, environment: {} });
    return (await shown(scene))[0]!;
  };

  test("say where a normal texture leans, in place of the texture coordinates", async () => {
    const straight = await red();
    expect(straight).toBeCloseTo(1e10 / (4 * Math.PI * 2e8 * Math.PI), 2); // the normal is the light's direction
    expect(await red([1, 0, 0, 1])).toBeCloseTo(straight, 2);
    expect(await red([-1, 0, 0, 1])).toBeLessThan(0.02 * straight);
    // Turned by a right angle: the normal leans upwards, 60° from the light.
    expect((await red([0, 1, 0, 1])) / straight).toBeCloseTo(0.5, 1);
    // Of no length: the texture coordinates tell.
    expect(await red([0, 0, 0, 0])).toBeCloseTo(straight, 2);
  });

  test("have a handedness, which turns what leans along v", async () => {
    const up = [128, lean, lean, 255]; // along the bitangent
    const lit = await red([0, 1, 0, -1], up); // n × t is −x, and turned it is +x
    expect(lit).toBeGreaterThan(1.2);
    expect(await red([0, 1, 0, 1], up)).toBeLessThan(0.02 * lit);
  });
});
