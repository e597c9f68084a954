import { encode } from "fast-png";
import { describe, expect, test } from "vitest";
import { decodeImage } from "../../../src/cli/decodeImage";
import { loadGltf } from "../../../src/loaders/gltf";
import { roughnessPicture } from "../../../src/loaders/gltf/roughnessPicture";
import { parseScene } from "../../../src/scene/parseScene";
import { meshesOf, type Packer, type TriangleJson, triangleFile } from "../../support/gltf";

/** Two texels: red of glossiness 0.2, green of 1. */
const GLOSSY = encode({ width: 2, height: 1, channels: 4, data: Uint8Array.of(255, 0, 0, 51, 0, 255, 0, 255) });

/** The material that one of specular-glossiness becomes, and what is said of it. Its texture 0 is a picture. */
async function load(
  KHR_materials_pbrSpecularGlossiness: object,
  more: object = {},
  change: (json: TriangleJson, packer: Packer) => void = () => {},
) {
  const file = triangleFile((json, packer) => {
    json.extensionsUsed = json.extensionsRequired = ["KHR_materials_pbrSpecularGlossiness"];
    json.images = [{ bufferView: packer.addView(GLOSSY) }];
    json.samplers = [{ wrapS: 33071 }];
    json.textures = [{ source: 0 }, { source: 0, sampler: 0 }];
    json.materials = [{ extensions: { KHR_materials_pbrSpecularGlossiness }, ...more }];
    const [primitive] = json.meshes[0].primitives;
    primitive.material = 0;
    primitive.attributes.TEXCOORD_0 = packer.add(Float32Array.of(0, 0, 1, 0, 0, 1), "VEC2");
    change(json, packer);
  });
  const { scene, warnings } = await loadGltf(file, { decodeImage });
  parseScene(scene); // what comes out is always valid
  const [mesh] = meshesOf(scene);
  return { material: scene.materials![mesh!.material]!, textures: scene.textures!, warnings };
}

/** Reflectance of a dielectric at normal incidence, as KHR_materials_specular has it. */
function reflectanceOf({ ior = 1.5, specularColor = [1, 1, 1] }: Awaited<ReturnType<typeof load>>["material"]) {
  return specularColor.map((channel) => Math.min(1, ((ior - 1) / (ior + 1)) ** 2 * channel));
}

describe("factors", () => {
  test("become a dielectric of that F0, that roughness and that colour", async () => {
    const { material, warnings } = await load({
      diffuseFactor: [0.1, 0.2, 0.3, 0.4],
      specularFactor: [1, 0.766, 0.336],
      glossinessFactor: 0.75,
    });
    expect(material).toMatchObject({ baseColor: [0.1, 0.2, 0.3], metallic: 0, roughness: 0.25 });
    for (const [i, f0] of [1, 0.766, 0.336].entries()) expect(reflectanceOf(material)[i]).toBeCloseTo(f0, 12);
    expect(material).not.toHaveProperty("alpha");
    expect(warnings).toEqual([]);
  });

  test("are a white mirror if they are not given", async () => {
    const { material } = await load({});
    expect(material).toEqual({
      baseColor: [1, 1, 1],
      metallic: 0,
      roughness: 0,
      ior: 1.5,
      specularColor: [25, 25, 25],
    });
  });

  test("out of range are the nearest in it", async () => {
    const { material } = await load({
      diffuseFactor: [2, -1, 0.5, 1],
      specularFactor: [2, -1, 0.04],
      glossinessFactor: 1.5,
    });
    expect(material).toMatchObject({ baseColor: [1, 0, 0.5], specularColor: [25, 0, 1], roughness: 0 });
  });

  test("take the place of metallic-roughness, an ior and a specular colour, which is said of the last", async () => {
    const { material, warnings } = await load(
      { diffuseFactor: [0, 0, 1, 0.5] },
      { alphaMode: "BLEND", pbrMetallicRoughness: { baseColorFactor: [1, 0, 0, 0.1], metallicFactor: 0.5 } },
      (json) => {
        Object.assign(json.materials[0].extensions, {
          KHR_materials_ior: { ior: 2 },
          KHR_materials_specular: { specularColorFactor: [0, 0, 0] },
        });
      },
    );
    expect(material).toMatchObject({ baseColor: [0, 0, 1], metallic: 0, alphaMode: "blend", alpha: 0.5, ior: 1.5 });
    expect(material.specularColor).toEqual([25, 25, 25]);
    expect(warnings).toEqual([expect.stringMatching(/^KHR_materials_specular is left out .*\(materials\[0\]\)$/)]);
  });

  test("lie below the other extensions", async () => {
    const { material } = await load({ specularFactor: [0, 0, 0] }, {}, (json) => {
      json.materials[0].extensions.KHR_materials_clearcoat = { clearcoatFactor: 1 };
    });
    expect(material).toMatchObject({ specularColor: [0, 0, 0], clearcoat: 1 });
  });
});

describe("textures", () => {
  test("are the colour and alpha, the specular colour, and roughness made of glossiness", async () => {
    const { material, textures, warnings } = await load({
      diffuseTexture: { index: 1 },
      specularFactor: [0.5, 0.5, 0.5],
      glossinessFactor: 0.5,
      specularGlossinessTexture: { index: 0 },
    });
    expect(material).toEqual({
      ...{ baseColor: [1, 1, 1], metallic: 0, roughness: 1, ior: 1.5, specularColor: [12.5, 12.5, 12.5] },
      baseColorTexture: "image 0 clamp repeat",
      specularColorTexture: "image 0",
      metallicRoughnessTexture: "image 0 glossiness 0.5",
    });
    const { texels, ...look } = textures["image 0 glossiness 0.5"]!;
    expect(look).toEqual({ width: 2, height: 1, wrapU: "repeat", wrapV: "repeat", filter: "linear" });
    // 1 − 0.5 · 51/255 is 0.9, and 1 − 0.5 is 0.5, to the nearest byte.
    expect([...(texels as Uint8Array)]).toEqual([255, 230, 255, 255, 255, 128, 255, 255]);
    expect([...(textures["image 0"]!.texels as Uint8Array)]).toEqual([255, 0, 0, 51, 0, 255, 0, 255]);
    expect(warnings).toEqual([]);
  });

  test("keep their place", async () => {
    const extensions = { KHR_texture_transform: { offset: [0.5, 0] } };
    const { material } = await load({ specularGlossinessTexture: { index: 1, extensions } });
    expect(material).toMatchObject({
      specularColorTexture: { texture: "image 0 clamp repeat", offset: [0.5, 0] },
      metallicRoughnessTexture: { texture: "image 0 clamp repeat glossiness 1", offset: [0.5, 0] },
    });
  });

  test("that change nothing are not loaded: of no glossiness, of no reflection", async () => {
    const specularGlossinessTexture = { index: 0 };
    const rough = await load({ glossinessFactor: 0, specularGlossinessTexture });
    expect(rough.material).toMatchObject({ roughness: 1, specularColorTexture: "image 0" });
    expect(rough.material).not.toHaveProperty("metallicRoughnessTexture");
    const dull = await load({ specularFactor: [0, 0, 0], specularGlossinessTexture });
    expect(Object.keys(dull.textures)).toEqual(["image 0 glossiness 1"]);
    const neither = await load({ glossinessFactor: 0, specularFactor: [0, 0, 0], specularGlossinessTexture });
    expect(neither.textures).toEqual({});
  });

  test("that are missing leave the factors, the glossiness too", async () => {
    const said = { glossinessFactor: 0.6, specularGlossinessTexture: { index: 0 }, diffuseTexture: { index: 0 } };
    const noUvs = await load(said, {}, (json) => {
      json.meshes[0].primitives[0].attributes = { POSITION: json.meshes[0].primitives[0].attributes.POSITION };
    });
    expect(noUvs.material.roughness).toBeCloseTo(0.4);
    const noSource = await load(said, {}, (json) => {
      json.textures[0] = {};
    });
    expect(noSource.material.roughness).toBeCloseTo(0.4);
    const noPicture = await load(said, {}, (json) => {
      json.images[0] = { uri: "data:image/png;base64,AAAA" };
    });
    expect(noPicture.material).toMatchObject({ roughness: 1, metallicRoughnessTexture: "image 0 glossiness 0.6" });
    expect(Object.keys(noPicture.material)).not.toContain("specularColorTexture");
    const { width, height, texels } = noPicture.textures["image 0 glossiness 0.6"]!;
    expect([width, height, ...(texels as Uint8Array)]).toEqual([1, 1, 255, 102, 255, 255]);
  });

  test("are a texel where the glossiness is the same everywhere, as without an alpha channel", async () => {
    const texels = new Uint8Array(4 * 64).fill(255);
    const roughness = await roughnessPicture({ width: 8, height: 8, texels }, 0.25, undefined);
    expect(roughness).toMatchObject({ width: 1, height: 1, texels: Uint8Array.of(255, 191, 255, 255) });
    texels[7] = 0;
    expect(await roughnessPicture({ width: 8, height: 8, texels }, 0.25, undefined)).toMatchObject({ width: 8 });
  });

  test("are made in slices, which a signal ends", async () => {
    const [width, height] = [2048, 1024];
    const texels = new Uint8Array(4 * width * height);
    texels[3] = 255;
    const image = { width, height, texels };
    const { texels: made } = await roughnessPicture(image, 1, undefined);
    expect(made[1]).toBe(0);
    expect(made.subarray(4).every((byte) => byte === 255)).toBe(true);
    await expect(roughnessPicture(image, 1, AbortSignal.abort(new Error("enough")))).rejects.toThrow("enough");
  });
});
