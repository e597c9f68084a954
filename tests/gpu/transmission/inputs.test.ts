// Glass in glTF files as they are found: transmission_pane.gltf among those handed to us, and others of its kind.

import { describe, expect, test } from "vitest";
import { decodeImage } from "../../../src/cli/decodeImage";
import { loadGltf } from "../../../src/loaders/gltf";
import type { Scene } from "../../../src/scene/schema";
import { renderScene } from "../../support/device";
import { fresnel, schlick } from "../../support/glass";
import { Packer } from "../../support/gltf";
import { cube, insideOut, type MeshData, placed } from "../../support/meshes";

const glass = (extensions: object, more: object = {}) => ({
  pbrMetallicRoughness: { baseColorFactor: [1, 1, 1, 1], metallicFactor: 0, roughnessFactor: 0 },
  extensions: { KHR_materials_transmission: { transmissionFactor: 1 }, ...extensions },
  ...more,
});
const red = {
  pbrMetallicRoughness: { baseColorFactor: [0.8, 0.1, 0.1, 1], metallicFactor: 0, roughnessFactor: 1 },
  extensions: { KHR_materials_ior: { ior: 1 } },
};
const glow = {
  pbrMetallicRoughness: { baseColorFactor: [0, 0, 0, 1], metallicFactor: 0 },
  emissiveFactor: [0.75, 0.5, 0.25],
  extensions: { KHR_materials_ior: { ior: 1 } },
};

const square = (size: number, z: number, tilt = 0): MeshData => {
  const [x, dz] = [size * Math.cos(tilt), size * Math.sin(tilt)];
  return {
    positions: [-x, -size, z - dz, x, -size, z + dz, x, size, z + dz, -x, size, z - dz],
    indices: [0, 1, 2, 0, 2, 3],
  };
};

/** A file of meshes with a material each, a camera 8 m up the z axis and, if it is lit, a lamp of 300 cd. */
function file(parts: readonly (readonly [MeshData, object])[], lamp?: readonly number[]): Uint8Array {
  const packer = new Packer();
  const meshes = parts.map(([{ positions, indices, normals }], material) => {
    const attributes = {
      POSITION: packer.add(Float32Array.from(positions), "VEC3"),
      ...(normals && { NORMAL: packer.add(Float32Array.from(normals), "VEC3") }),
    };
    return { primitives: [{ attributes, indices: packer.add(Uint16Array.from(indices), "SCALAR"), material }] };
  });
  const light = { translation: lamp, extensions: { KHR_lights_punctual: { light: 0 } } };
  const nodes = [
    ...meshes.map((_, mesh) => ({ mesh })),
    { camera: 0, translation: [0, 0, 8] },
    ...(lamp ? [light] : []),
  ];
  return packer.file({
    meshes,
    materials: parts.map(([, material]) => material),
    cameras: [{ type: "perspective", perspective: { yfov: 2e-5, znear: 0.01 } }],
    ...(lamp && { extensions: { KHR_lights_punctual: { lights: [{ type: "point", intensity: 300 }] } } }),
    nodes,
    scenes: [{ nodes: nodes.map((_, i) => i) }],
  });
}

/** What the camera sees in its middle. */
async function middle(bytes: Uint8Array, more: Partial<Scene> = {}): Promise<readonly number[]> {
  const { scene, warnings } = await loadGltf(bytes, { decodeImage });
  expect(warnings).toEqual([]);
  const { image, stats } = await renderScene({ ...scene, maxBounces: 16, ...more }, { size: [16, 16], samples: 256 });
  expect(stats.badSamples).toBe(0);
  return [0, 1, 2].map((c) => image.reduce((sum, value, i) => (i % 4 === c ? sum + value : sum), 0) / 256);
}

// As in transmission_pane.gltf: a red wall at z = −1, a lamp to the upper right, and 2 m before the wall what lets light through.
const LAMP = [3, 4, 6] as const;
const wall = [square(3, -1), red] as const;
const distance = Math.hypot(3, 4, 7);
const E = (300 * (7 / distance)) / distance ** 2;

describe("a red wall behind clear glass", () => {
  // How much light goes through, on its way to the wall and from there; and the angles at which it meets the glass.
  test.each<[string, MeshData, object, number]>([
    ["the pane of the file", square(1.5, 1), glass({}), (1 - schlick(7 / distance)) * (1 - schlick(1))],
    [
      "a pane at an angle, double sided",
      square(1.5, 1, 0.5),
      glass({}, { doubleSided: true }),
      (1 - schlick((7 * Math.cos(0.5) - 3 * Math.sin(0.5)) / distance)) * (1 - schlick(Math.cos(0.5))),
    ],
    [
      "a pane with two faces",
      placed(cube(), 1.5, [0, 0, 2.5]),
      glass({}),
      // What light gets in by its upper face.
      (1 - schlick(7 / distance)) * (1 - schlick(4 / distance)) * (1 - schlick(1)) ** 2,
    ],
    [
      "a windscreen with normals of its own",
      { ...square(1.5, 1), normals: [-0.6, 0, 0.8, 0.6, 0, 0.8, 0.6, 0, 0.8, -0.6, 0, 0.8] },
      glass({}, { doubleSided: true }),
      (1 - schlick(7 / distance)) * (1 - schlick(1)),
    ],
    [
      "coloured glass",
      square(1.5, 1),
      glass({}, { pbrMetallicRoughness: { baseColorFactor: [0.5, 1, 1, 1], metallicFactor: 0, roughnessFactor: 0 } }),
      0.25 * (1 - schlick(7 / distance)) * (1 - schlick(1)),
    ],
  ])("is seen and lit through %s, seed 1", async (_name, mesh, material, passes) => {
    const [r, g, b] = await middle(file([[mesh, material], wall], LAMP));
    const expected = ((0.8 * E) / Math.PI) * passes;
    // Of the light that the wall sends back the glass returns 9 % at the most from all sides, 0.8 of which the wall reflects.
    expect(r! / expected).toBeGreaterThan(0.985);
    expect(r! / expected).toBeLessThan(1.08);
    expect(Math.abs(g! - b!)).toBeLessThan(1e-2);
  });
});

describe("a glowing wall is seen through", () => {
  const volume = (thicknessFactor: number) => ({
    KHR_materials_volume: { thicknessFactor, attenuationColor: [0.5, 0.25, 1], attenuationDistance: 2 },
    KHR_materials_ior: { ior: 1.5 },
  });
  const a = (length: number) => [0.5, 0.25, 1].map((color) => color ** (length / 2));
  const F = fresnel(1, 1.5);
  const behind = [square(30, -9), glow] as const;
  // Without the sky that a file without lamps is shown under.
  const DARK = { environment: { radiance: [0, 0, 0] }, lights: [] } as const;
  // Each interface passes 1 − F; what two of them throw to and fro in a slab that absorbs a.
  const slab = (a: number) => ((1 - F) ** 2 * a) / (1 - (F * a) ** 2);

  test("a block of coloured glass, with what it reflects in itself, seed 1", async () => {
    const L = await middle(file([[cube(), glass(volume(1))], behind]), DARK);
    for (const [i, through] of a(2).entries())
      expect(Math.abs(L[i]! / (glow.emissiveFactor[i]! * slab(through)) - 1)).toBeLessThan(0.01);
  });

  test("a bottle, which light goes through twice, seed 1", async () => {
    const bottle = {
      ...cube(),
      positions: [...cube().positions, ...cube().positions.map((x) => x * 0.5)],
      indices: [...cube().indices, ...insideOut(cube()).indices.map((i) => i + 8)],
    };
    const L = await middle(file([[bottle, glass(volume(1))], behind]), DARK);
    for (const [i, through] of a(0.5).entries()) {
      const T = slab(through);
      const R = F + ((1 - F) ** 2 * F * through ** 2) / (1 - (F * through) ** 2);
      expect(Math.abs(L[i]! / ((glow.emissiveFactor[i]! * T ** 2) / (1 - R ** 2)) - 1)).toBeLessThan(0.01);
    }
  });

  test("an open square with a thickness: light gets into what it bounds and stays there, seed 1", async () => {
    const L = await middle(file([[square(2, 1), glass(volume(0.1))], behind]), DARK);
    for (const [i, through] of a(10).entries())
      expect(Math.abs(L[i]! / (glow.emissiveFactor[i]! * (1 - F) * through) - 1)).toBeLessThan(0.01);
  });
});
