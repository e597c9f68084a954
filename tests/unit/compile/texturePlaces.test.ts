import { expect, test } from "vitest";
import { compileScene } from "../../../src/compile/compileScene";
import { linkProgram } from "../../../src/compile/linkProgram";
import { parseScene } from "../../../src/scene/parseScene";
import type { Material } from "../../../src/scene/schema";
import { prepareGeometry } from "../../../src/tree/geometry";

const MESH = {
  type: "mesh",
  positions: [0, 0, 0, 1, 0, 0, 0, 1, 0],
  indices: [0, 1, 2],
  uvs: [0, 0, 1, 0, 0, 1],
} as const;
const PICTURE = { width: 2, height: 1, texels: [0, 0, 0, 255, 9, 9, 9, 255] };

const hex = (bytes: ArrayBuffer) => Buffer.from(bytes).toString("hex");

async function compiled(material: Material, more: object = {}) {
  const scene = parseScene({
    camera: { position: [0, 0, 5] },
    textures: { a: PICTURE, b: PICTURE },
    materials: { m: material },
    objects: [{ ...MESH, material: "m", ...more }],
  });
  const geometry = await prepareGeometry(scene);
  const settings = { estimator: "path", sampler: "sobol", lightSamples: 1 } as const;
  const { sceneModule, features, uniform } = compileScene(scene, settings, undefined, geometry);
  const { items, vertices, texels } = geometry!.data;
  return {
    text: await linkProgram(sceneModule, features),
    values: hex(uniform),
    data: [hex(items), hex(vertices!), ...texels!.map((bytes) => hex(bytes.slice().buffer))],
  };
}

test("a reference that says no more than a name costs nothing: the same program and bytes", async () => {
  const named = await compiled({ baseColorTexture: "b", normalTexture: "a" });
  const placed = await compiled({
    baseColorTexture: { texture: "b" },
    normalTexture: { texture: "a", uv: 0, offset: [0, 0], scale: [1, 1], rotation: 0 },
  });
  expect(placed.text).toBe(named.text);
  expect(placed.values).toBe(named.values);
  expect(placed.data).toEqual(named.data);
  expect(named.text).not.toMatch(/toU|UVS1_AT/);
});

test("places of textures are values: another one needs no other program, nor other texels or vertices", async () => {
  const uvs1 = { uvs1: MESH.uvs };
  const one = await compiled({ normalTexture: { texture: "a", scale: [2, 2] } }, uvs1);
  const other = await compiled({ normalTexture: { texture: "a", uv: 1, rotation: 30, offset: [1, 0] } }, uvs1);
  expect(other.text).toBe(one.text);
  expect(other.values).not.toBe(one.values);
  expect(other.data).toEqual(one.data);
});

test("one place of a texture is one row, whoever names it, and its texels are there once", async () => {
  const rows = async (material: Material) => {
    const { text, data } = await compiled(material);
    expect(data).toHaveLength(2 + 2);
    return Number(/textures: array<Texture, (\d+)>/.exec(text)![1]);
  };
  const place = { texture: "a", scale: [2, 2] } as const;
  expect(await rows({ normalTexture: "a" })).toBe(2);
  expect(await rows({ normalTexture: place, baseColorTexture: place, emissionTexture: { ...place, uv: 0 } })).toBe(3);
  expect(await rows({ normalTexture: place, baseColorTexture: { ...place, rotation: 1 } })).toBe(4);
});
