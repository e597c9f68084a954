import { encode } from "fast-png";
import { describe, expect, test } from "vitest";
import { decodeImage } from "../../../src/cli/decodeImage";
import { loadGltf } from "../../../src/loaders/gltf";
import { Materials } from "../../../src/loaders/gltf/materials";
import type { GltfJson } from "../../../src/loaders/gltf/schema";
import { Textures } from "../../../src/loaders/gltf/textures";
import { Warnings } from "../../../src/loaders/warnings";
import { parseScene } from "../../../src/scene/parseScene";
import { meshesOf, type Packer, roundedNumbers, type TriangleJson, triangleFile } from "../../support/gltf";
import { growthOf, LINEAR } from "../../support/growth";

const load = async (change: (json: TriangleJson, packer: Packer) => void) => {
  const { scene, warnings } = await loadGltf(triangleFile(change), { decodeImage });
  parseScene(scene); // what comes out is always valid
  const [mesh] = meshesOf(scene);
  return { scene, warnings, mesh: mesh!, material: scene.materials![mesh!.material]! };
};

describe("factors", () => {
  const loadMaterial = (material: object) =>
    load((json) => {
      json.materials = [material];
      json.meshes[0].primitives[0].material = 0;
    });

  test("without a material a mesh is as glTF has it: white, metallic and rough", async () => {
    const { material, mesh } = await load(() => {});
    expect(mesh.material).toBe("default");
    expect(material).toEqual({ baseColor: [1, 1, 1], metallic: 1, roughness: 1, ior: 1.5 });
  });

  test("metallic-roughness factors are ours", async () => {
    const { material, mesh, warnings } = await loadMaterial({
      name: "Old gold",
      pbrMetallicRoughness: { baseColorFactor: [0.1, 0.2, 0.3, 1], metallicFactor: 0.4, roughnessFactor: 0.5 },
      doubleSided: true,
    });
    expect(mesh.material).toBe("Old gold");
    expect(material).toEqual({ baseColor: [0.1, 0.2, 0.3], metallic: 0.4, roughness: 0.5, ior: 1.5 });
    expect(warnings).toEqual([]);
  });

  test("emission is the factor times KHR_materials_emissive_strength, as radiance", async () => {
    const { material } = await loadMaterial({
      emissiveFactor: [1, 0.5, 0],
      extensions: { KHR_materials_emissive_strength: { emissiveStrength: 20 } },
    });
    expect(material.emission).toEqual([20, 10, 0]);
  });

  test("an emitter may have two sides, and a surface none of the light", async () => {
    const emissiveFactor = [1, 1, 1];
    expect((await loadMaterial({ doubleSided: true, emissiveFactor })).material).toMatchObject({ doubleSided: true });
    expect((await loadMaterial({ doubleSided: true })).material).not.toHaveProperty("doubleSided");
    const { material, warnings } = await loadMaterial({ extensions: { KHR_materials_unlit: {} } });
    expect(material).toMatchObject({ unlit: true });
    expect(warnings).toEqual([]);
  });

  test("alpha is a mask with its cutoff, or blends; of an opaque material it says nothing", async () => {
    const pbrMetallicRoughness = { baseColorFactor: [1, 1, 1, 0.25] };
    const made = async (more: object) => (await loadMaterial({ pbrMetallicRoughness, ...more })).material;
    expect(await made({ alphaMode: "MASK" })).toMatchObject({ alphaMode: "mask", alpha: 0.25 });
    expect(await made({ alphaMode: "MASK", alphaCutoff: 0.1 })).toMatchObject({ alphaMode: "mask", alphaCutoff: 0.1 });
    expect(await made({ alphaMode: "BLEND" })).toMatchObject({ alphaMode: "blend", alpha: 0.25 });
    expect(await made({})).not.toHaveProperty("alpha");
  });

  test("materials of one name, whatever it is, stay apart", async () => {
    const names = ["a", "a", "__proto__", "__proto__", "constructor", "ground", ""];
    const { scene } = await load((json) => {
      json.materials = names.map((name, i) => ({ name, pbrMetallicRoughness: { metallicFactor: i / 10 } }));
      const { attributes } = json.meshes[0].primitives[0];
      json.meshes[0].primitives = names.map((_, material) => ({ attributes, material }));
    });
    const { materials } = parseScene(scene);
    const metallic = meshesOf(scene).map(({ material }) => materials[material]!.metallic);
    expect(metallic).toEqual(names.map((_, i) => i / 10));
    expect(Reflect.has({}, "metallic")).toBe(false);
  });

  test("a material whose name is taken gets a number, the first that is free", async () => {
    const { scene } = await load((json) => {
      json.materials = ["glass", "glass", "glass 3", "glass"].map((name) => ({ name }));
      const { attributes } = json.meshes[0].primitives[0];
      json.meshes[0].primitives = json.materials.map((_: unknown, material: number) => ({ attributes, material }));
    });
    expect(meshesOf(scene).map(({ material }) => material)).toEqual(["glass", "glass 2", "glass 3", "glass 4"]);
  });

  test("thirty thousand names that are taken, numbers and all, take no minutes", async () => {
    // The first half takes the numbers that the second half would look at first.
    const choose = (count: number) => {
      const named = (name: string) => ({ name }) as GltfJson["materials"][number];
      const materials = Array.from({ length: count }, (_, i) => named(i < count / 2 ? `m ${i + 2 + count / 2}` : "m"));
      const json = { materials } as GltfJson;
      const warnings = new Warnings();
      const chosen = new Materials(json, new Textures(json, warnings), warnings);
      for (let i = 0; i < count; i++) chosen.choose(i, new Map());
      expect(Object.keys(chosen.all)).toHaveLength(count);
    };
    expect(await growthOf(choose, 2000)).toBeLessThan(LINEAR);
  });
});

describe("textures", () => {
  const RED_GREEN = encode({ width: 2, height: 1, channels: 4, data: Uint8Array.of(255, 0, 0, 0, 0, 255, 0, 255) });
  const UVS = Float32Array.of(0, 0, 1, 0, 0, 1);

  /** Adds a picture, two ways to repeat it, texture coordinates and a material. */
  function addTexture(json: TriangleJson, packer: Packer, material: object): void {
    const picture = { bufferView: packer.addView(RED_GREEN), mimeType: "image/png" };
    json.images = [picture];
    json.samplers = [{ wrapS: 33071, wrapT: 33648, magFilter: 9728 }];
    json.textures = [{ source: 0 }, { source: 0, sampler: 0 }];
    json.materials = [material];
    const [primitive] = json.meshes[0].primitives;
    primitive.material = 0;
    primitive.attributes.TEXCOORD_0 = packer.add(UVS, "VEC2");
    primitive.attributes.TEXCOORD_1 = packer.add(Float32Array.of(5, 5, 6, 6, 7, 7), "VEC2");
  }
  const loadTextured = (material: object, change: (json: TriangleJson) => void = () => {}) =>
    load((json, packer) => {
      addTexture(json, packer, material);
      change(json);
    });

  test("each has its place, its picture and its way to repeat", async () => {
    const { scene, mesh, material, warnings } = await loadTextured({
      pbrMetallicRoughness: { baseColorTexture: { index: 0 }, metallicRoughnessTexture: { index: 1 } },
      normalTexture: { index: 0, scale: 0.5 },
      emissiveTexture: { index: 0 },
      emissiveFactor: [1, 1, 1],
    });
    expect(material).toMatchObject({
      baseColorTexture: "image 0",
      metallicRoughnessTexture: "image 0 clamp mirror nearest",
      normalTexture: "image 0",
      normalScale: 0.5,
      emissionTexture: "image 0",
      emission: [1, 1, 1],
    });
    const texels = Uint8Array.of(255, 0, 0, 0, 0, 255, 0, 255);
    const picture = { width: 2, height: 1, texels };
    expect(scene.textures).toEqual({
      "image 0": { ...picture, wrapU: "repeat", wrapV: "repeat", filter: "linear" },
      "image 0 clamp mirror nearest": { ...picture, wrapU: "clamp", wrapV: "mirror", filter: "nearest" },
    });
    expect(roundedNumbers(mesh.uvs)).toEqual([...UVS]);
    expect(warnings).toEqual([]);
  });

  test("KHR_texture_transform is the place of its texture alone, in degrees", async () => {
    const transform = { offset: [0, 1], rotation: Math.PI / 2, scale: [0.5, 0.5] };
    const { mesh, material, warnings } = await loadTextured({
      pbrMetallicRoughness: {
        baseColorTexture: { index: 0 },
        metallicRoughnessTexture: { index: 1, extensions: { KHR_texture_transform: { scale: [1, 1], rotation: 0 } } },
      },
      normalTexture: { index: 0, extensions: { KHR_texture_transform: transform } },
    });
    expect(material).toMatchObject({
      baseColorTexture: "image 0",
      metallicRoughnessTexture: "image 0 clamp mirror nearest",
      normalTexture: { texture: "image 0", offset: [0, 1], rotation: 90, scale: [0.5, 0.5] },
    });
    expect(roundedNumbers(mesh.uvs)).toEqual([...UVS]);
    expect(mesh.uvs1).toBeUndefined();
    expect(warnings).toEqual([]);
  });

  test("two sets of texture coordinates are the mesh's two; one alone is its first", async () => {
    const two = await loadTextured({
      pbrMetallicRoughness: { baseColorTexture: { index: 0, texCoord: 1 } },
      normalTexture: { index: 0 },
    });
    expect(two.material).toMatchObject({
      baseColorTexture: { texture: "image 0", uv: 1 },
      normalTexture: "image 0",
    });
    expect(roundedNumbers(two.mesh.uvs)).toEqual([...UVS]);
    expect(roundedNumbers(two.mesh.uvs1)).toEqual([5, 5, 6, 6, 7, 7]);
    expect(two.warnings).toEqual([]);

    // The extension's texCoord takes precedence.
    const extensions = { KHR_texture_transform: { texCoord: 1 } };
    const one = await loadTextured({ normalTexture: { index: 0, texCoord: 0, extensions } });
    expect(one.material.normalTexture).toBe("image 0");
    expect(roundedNumbers(one.mesh.uvs)).toEqual([5, 5, 6, 6, 7, 7]);
    expect(one.mesh.uvs1).toBeUndefined();
  });

  test("a texture that asks for a third set is left out, and that is said", async () => {
    const { mesh, material, warnings } = await load((json, packer) => {
      addTexture(json, packer, {
        name: "brick",
        pbrMetallicRoughness: {
          baseColorTexture: { index: 0, texCoord: 2 },
          metallicRoughnessTexture: { index: 0 },
        },
        normalTexture: { index: 0, texCoord: 1 },
        emissiveTexture: { index: 0, texCoord: 2 },
        emissiveFactor: [1, 1, 1],
      });
      json.meshes[0].primitives[0].attributes.TEXCOORD_2 = packer.add(Float32Array.of(8, 8, 9, 9, 3, 3), "VEC2");
    });
    expect(material).toMatchObject({
      baseColorTexture: { texture: "image 0", uv: 1 },
      normalTexture: "image 0",
      emissionTexture: { texture: "image 0", uv: 1 },
    });
    expect(material.metallicRoughnessTexture).toBeUndefined();
    expect(roundedNumbers(mesh.uvs)).toEqual([5, 5, 6, 6, 7, 7]);
    expect(roundedNumbers(mesh.uvs1)).toEqual([8, 8, 9, 9, 3, 3]);
    expect(warnings).toEqual([
      'A texture is left out because others of its material have two sets of texture coordinates already (materials[0] "brick", metallicRoughnessTexture)',
    ]);
  });

  test("a texture in a place of its own whose picture is missing is left out like any other", async () => {
    const extensions = { KHR_texture_transform: { scale: [2, 2] } };
    const { material, warnings } = await loadTextured({ normalTexture: { index: 0, extensions } }, (json) => {
      json.images = [{ uri: "data:image/png;base64,AAAA" }];
    });
    expect(material.normalTexture).toBeUndefined();
    expect(warnings).toEqual([expect.stringContaining("A picture is left out")]);
  });

  test("a mesh without texture coordinates shows the material without its textures, and that is said", async () => {
    const { scene, warnings } = await load((json, packer) => {
      addTexture(json, packer, { name: "m", pbrMetallicRoughness: { baseColorTexture: { index: 0 } } });
      const { POSITION } = json.meshes[0].primitives[0].attributes;
      json.meshes[0].primitives.push({ attributes: { POSITION }, material: 0 });
    });
    const [textured, bare] = meshesOf(scene);
    expect(scene.materials![textured!.material]!.baseColorTexture).toBe("image 0");
    expect(scene.materials![bare!.material]!.baseColorTexture).toBeUndefined();
    expect(bare!.uvs).toBeUndefined();
    expect(warnings).toEqual([expect.stringMatching(/left out on meshes that lack its texture coordinates .*"m"/)]);
  });

  test("pictures that nothing shows are not decoded: emission of strength 0, unused materials", async () => {
    const { scene } = await loadTextured({ emissiveTexture: { index: 0 } }, (json) => {
      json.materials.push({ normalTexture: { index: 0 } });
    });
    expect(scene.textures).toEqual({});
  });

  test("without a decoder the error says how to give one", async () => {
    const file = triangleFile((json, packer) => addTexture(json, packer, { normalTexture: { index: 0 } }));
    await expect(loadGltf(file)).rejects.toThrow(
      "the file has pictures, for which there is no decoder outside of a browser; give one in the option decodeImage",
    );
  });
});

test("what is not supported is listed, with the places", async () => {
  const { warnings } = await load((json, packer) => {
    json.extensionsUsed = ["KHR_materials_volume_scatter", "KHR_xmp_json_ld", "KHR_materials_ior"];
    json.animations = [{}];
    json.nodes[0].skin = 0;
    json.meshes[0].name = "Body";
    const [primitive] = json.meshes[0].primitives;
    primitive.targets = [{}];
    primitive.attributes.COLOR_0 = packer.add(new Uint8Array(12), "VEC4");
    primitive.attributes.NORMAL = packer.add(Float32Array.of(0, 0, 1, 0, 0, 1, 0, 0, 1), "VEC3");
    primitive.attributes.TANGENT = packer.add(new Float32Array(12), "VEC4");
    primitive.material = 0;
    json.materials = [{ doubleSided: true, emissiveFactor: [1, 1, 1], normalTexture: { index: 0 } }];
    json.textures = [{}];
  });
  expect(warnings).toEqual([
    'The scattering of light within a material is not shown ("KHR_materials_volume_scatter")',
    "Animations are not supported: the pose at rest is shown",
    "Skins are not supported: the mesh is shown unbent (nodes[0])",
    'Morph targets are not supported: the base shape is shown (meshes[0] "Body")',
    "A texture is left out on meshes that lack its texture coordinates (materials[0], normalTexture)",
  ]);
});
