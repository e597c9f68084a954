import { describe, expect, test, vi } from "vitest";
import { decodeImage } from "../../../src/cli/decodeImage";
import { loadGltf } from "../../../src/loaders/gltf";
import { parseScene } from "../../../src/scene/parseScene";
import { container, meshesOf, type Packer, roundedNumbers, type TriangleJson, triangleFile } from "../../support/gltf";
import { addSurface, type Extensions, FULL_EXTENSIONS } from "../../support/gltfSurfaces";
import { createRandom } from "../../support/random";

const PLAIN = { baseColor: [1, 1, 1], metallic: 1, roughness: 1, ior: 1.5 };

/** The material that a material with these extensions becomes, and what is said of it. */
async function load(
  extensions: Extensions,
  more: object = {},
  change: (json: TriangleJson, packer: Packer) => void = () => {},
) {
  const file = triangleFile((json, packer) => {
    addSurface(json, packer, extensions, more);
    change(json, packer);
  });
  const { scene, warnings } = await loadGltf(file, { decodeImage });
  parseScene(scene); // what comes out is always valid
  const [mesh] = meshesOf(scene);
  return { material: scene.materials![mesh!.material]!, mesh: mesh!, textures: scene.textures!, warnings };
}

describe("each extension has its fields and textures", () => {
  const { KHR_materials_transmission, KHR_materials_volume, KHR_materials_dispersion } = FULL_EXTENSIONS;
  const cases: Readonly<Record<string, readonly [Extensions, object]>> = {
    ior: [{ KHR_materials_ior: FULL_EXTENSIONS.KHR_materials_ior }, { ior: 1.7 }],
    transmission: [{ KHR_materials_transmission }, { transmission: 0.9, transmissionTexture: "image 0" }],
    volume: [
      { KHR_materials_transmission, KHR_materials_volume },
      {
        ...{ transmission: 0.9, transmissionTexture: "image 0" },
        ...{ thickness: 0.02, attenuationDistance: 0.5, attenuationColor: [0.9, 0.5, 0.1] },
      },
    ],
    dispersion: [
      { KHR_materials_transmission, KHR_materials_volume, KHR_materials_dispersion },
      {
        ...{ transmission: 0.9, transmissionTexture: "image 0", dispersion: 0.36 },
        ...{ thickness: 0.02, attenuationDistance: 0.5, attenuationColor: [0.9, 0.5, 0.1] },
      },
    ],
    "diffuse transmission": [
      { KHR_materials_diffuse_transmission: FULL_EXTENSIONS.KHR_materials_diffuse_transmission },
      {
        ...{ diffuseTransmission: 0.25, diffuseTransmissionTexture: "image 1" },
        ...{ diffuseTransmissionColor: [1, 0.9, 0.8], diffuseTransmissionColorTexture: "image 2" },
      },
    ],
    specular: [
      { KHR_materials_specular: FULL_EXTENSIONS.KHR_materials_specular },
      {
        ...{ specular: 0.75, specularTexture: "image 3" },
        ...{ specularColor: [2, 1, 0.5], specularColorTexture: "image 4" },
      },
    ],
    clearcoat: [
      { KHR_materials_clearcoat: FULL_EXTENSIONS.KHR_materials_clearcoat },
      {
        ...{ clearcoat: 0.6, clearcoatTexture: "image 5" },
        ...{ clearcoatRoughness: 0.3, clearcoatRoughnessTexture: "image 6" },
        ...{ clearcoatNormalTexture: "image 7", clearcoatNormalScale: 0.5 },
      },
    ],
    sheen: [
      { KHR_materials_sheen: FULL_EXTENSIONS.KHR_materials_sheen },
      {
        ...{ sheenColor: [0.1, 0.2, 0.3], sheenColorTexture: "image 8" },
        ...{ sheenRoughness: 0.4, sheenRoughnessTexture: "image 9" },
      },
    ],
    "anisotropy, in degrees": [
      { KHR_materials_anisotropy: FULL_EXTENSIONS.KHR_materials_anisotropy },
      { anisotropy: 0.7, anisotropyRotation: 90, anisotropyTexture: "image 10" },
    ],
    iridescence: [
      { KHR_materials_iridescence: FULL_EXTENSIONS.KHR_materials_iridescence },
      {
        ...{ iridescence: 0.8, iridescenceTexture: "image 11", iridescenceIor: 1.8 },
        ...{ iridescenceThickness: 700, iridescenceThicknessMinimum: 200 },
        iridescenceThicknessTexture: "image 12",
      },
    ],
  };

  test.each(Object.keys(cases))("%s", async (name) => {
    const [extensions, expected] = cases[name]!;
    const { material, warnings } = await load(extensions);
    expect(material).toEqual({ ...PLAIN, ...expected });
    expect(warnings).toEqual([]);
  });

  test("all at once", async () => {
    const { material, textures, warnings } = await load(FULL_EXTENSIONS);
    expect(material).toEqual(Object.assign({ ...PLAIN }, ...Object.values(cases).map(([, fields]) => fields)));
    expect(Object.keys(textures)).toHaveLength(13);
    expect(warnings).toEqual([]);
  });
});

describe("an extension that says nothing", () => {
  test("has its defaults, and no effect", async () => {
    const empty = Object.fromEntries(Object.keys(FULL_EXTENSIONS).map((name) => [name, {}]));
    const { material, warnings } = await load(empty);
    expect(material).toEqual(PLAIN);
    expect(warnings).toEqual([]);
  });

  test("but how strong it is has the extension's defaults", async () => {
    const { material } = await load({
      KHR_materials_transmission: { transmissionFactor: 1 },
      KHR_materials_volume: { thicknessFactor: 1 },
      KHR_materials_diffuse_transmission: { diffuseTransmissionFactor: 1 },
      KHR_materials_clearcoat: { clearcoatFactor: 1 },
      KHR_materials_sheen: { sheenColorFactor: [1, 1, 1] },
      KHR_materials_anisotropy: { anisotropyStrength: 1 },
      KHR_materials_iridescence: { iridescenceFactor: 1 },
    });
    expect(material).toEqual({
      ...PLAIN,
      ...{ transmission: 1, thickness: 1, diffuseTransmission: 1, diffuseTransmissionColor: [1, 1, 1] },
      ...{ clearcoat: 1, clearcoatRoughness: 0, sheenColor: [1, 1, 1], sheenRoughness: 0 },
      ...{ anisotropy: 1, anisotropyRotation: 0 },
      ...{ iridescence: 1, iridescenceIor: 1.3, iridescenceThickness: 400 },
    });
  });
});

describe("textures that change nothing are not loaded", () => {
  const without = (changes: Readonly<Record<string, object>>): Extensions =>
    Object.fromEntries(Object.entries(FULL_EXTENSIONS).map(([name, said]) => [name, { ...said, ...changes[name] }]));

  test("of an effect whose strength is 0", async () => {
    const { material, textures } = await load(
      without({
        KHR_materials_transmission: { transmissionFactor: 0 },
        KHR_materials_diffuse_transmission: { diffuseTransmissionFactor: 0 },
        KHR_materials_specular: { specularFactor: 0 },
        KHR_materials_clearcoat: { clearcoatFactor: 0 },
        KHR_materials_sheen: { sheenColorFactor: [0, 0, 0] },
        KHR_materials_anisotropy: { anisotropyStrength: 0 },
        KHR_materials_iridescence: { iridescenceFactor: 0 },
      }),
    );
    expect(textures).toEqual({});
    expect(material).toEqual({ ...PLAIN, ior: 1.7, specular: 0, specularColor: [2, 1, 0.5] });
  });

  test("of a factor that is 0", async () => {
    const { textures } = await load(
      without({
        KHR_materials_diffuse_transmission: { diffuseTransmissionColorFactor: [0, 0, 0] },
        KHR_materials_specular: { specularColorFactor: [0, 0, 0] },
        KHR_materials_clearcoat: { clearcoatRoughnessFactor: 0 },
        KHR_materials_sheen: { sheenRoughnessFactor: 0 },
        KHR_materials_iridescence: { iridescenceThicknessMinimum: 700 },
      }),
    );
    const left = [0, 1, 3, 5, 7, 8, 10, 11].map((i) => `image ${i}`);
    expect(new Set(Object.keys(textures))).toEqual(new Set(left));
  });

  test("of what is unlit: it shows its colour", async () => {
    const more = { pbrMetallicRoughness: { baseColorTexture: { index: 3 } }, normalTexture: { index: 4 } };
    const { material } = await load({ ...FULL_EXTENSIONS, KHR_materials_unlit: {} }, more);
    expect(material).toEqual({ baseColor: [1, 1, 1], unlit: true, baseColorTexture: "image 3" });
  });

  test("by a thickness texture: light goes its real way", async () => {
    const decode = vi.fn(decodeImage);
    const extensions = {
      KHR_materials_transmission: { transmissionFactor: 1 },
      KHR_materials_volume: FULL_EXTENSIONS.KHR_materials_volume,
    };
    const file = triangleFile((json, packer) => addSurface(json, packer, extensions));
    const { warnings } = await loadGltf(file, { decodeImage: decode });
    expect(decode).not.toHaveBeenCalled();
    expect(warnings).toEqual([]);
  });
});

describe("textures", () => {
  test("of colours are sRGB, and averaged as light when they are made smaller; all others are data", async () => {
    const file = triangleFile((json, packer) => addSurface(json, packer, FULL_EXTENSIONS));
    const { scene } = await loadGltf(file, { decodeImage, maxTexelBytes: 4 * 13 });
    const [color, data] = [
      [188, 188, 188, 128],
      [128, 128, 128, 128],
    ];
    for (let i = 0; i < 13; i++) {
      const isColor = [2, 4, 8].includes(i); // of diffuse transmission, specular reflection, sheen
      expect([...scene.textures![`image ${i}`]!.texels], `image ${i}`).toEqual(isColor ? color : data);
    }
  });

  test("have their place, and two sets of texture coordinates", async () => {
    const KHR_texture_transform = { scale: [2, 2], rotation: Math.PI / 2, texCoord: 1 };
    const { material, mesh, warnings } = await load({
      KHR_materials_sheen: {
        sheenColorFactor: [1, 1, 1],
        sheenColorTexture: { index: 0 },
        sheenRoughnessFactor: 1,
        sheenRoughnessTexture: { index: 1, extensions: { KHR_texture_transform } },
      },
      KHR_materials_clearcoat: { clearcoatFactor: 1, clearcoatNormalTexture: { index: 2, texCoord: 1 } },
    });
    expect(material).toMatchObject({
      sheenColorTexture: "image 0",
      sheenRoughnessTexture: { texture: "image 1", uv: 1, scale: [2, 2], rotation: 90 },
      clearcoatNormalTexture: { texture: "image 2", uv: 1 },
    });
    expect(roundedNumbers(mesh.uvs)).toEqual([0, 0, 1, 0, 0, 1]);
    expect(roundedNumbers(mesh.uvs1)).toEqual([5, 5, 6, 6, 7, 7]);
    expect(warnings).toEqual([]);
  });

  test("of the surface itself get their texture coordinates before those of extensions", async () => {
    const { material, warnings } = await load(
      { KHR_materials_clearcoat: { clearcoatFactor: 1, clearcoatTexture: { index: 2, texCoord: 2 } } },
      { normalTexture: { index: 0 }, pbrMetallicRoughness: { metallicRoughnessTexture: { index: 1, texCoord: 1 } } },
      (json) => Object.assign(json.meshes[0].primitives[0].attributes, { TEXCOORD_2: 1 }),
    );
    expect(material).toMatchObject({ clearcoat: 1, normalTexture: "image 0" });
    expect(material.clearcoatTexture).toBeUndefined();
    expect(warnings).toEqual([
      "A texture is left out because others of its material have two sets of texture coordinates already (materials[0], clearcoatTexture)",
    ]);
  });

  test("that are missing leave the factors: a film as thick as its maximum, highlights along the tangent, a flat coat", async () => {
    const { material, warnings } = await load(FULL_EXTENSIONS, {}, (json) => {
      json.images = json.images.map(() => ({ uri: "data:image/png;base64,AAAA" }));
    });
    expect(Object.keys(material).filter((field) => /Texture$/.test(field))).toEqual([]);
    expect(material).toMatchObject({ transmission: 0.9, anisotropy: 0.7, iridescenceThickness: 700, clearcoat: 0.6 });
    expect(warnings).toEqual([expect.stringMatching(/^A picture is left out.* and 10 more\)$/)]);
  });

  test("are left out on a mesh without texture coordinates, one line for all", async () => {
    const { material, warnings } = await load(FULL_EXTENSIONS, {}, (json) => {
      const { POSITION } = json.meshes[0].primitives[0].attributes;
      json.meshes[0].primitives[0].attributes = { POSITION };
    });
    expect(Object.keys(material).filter((field) => /Texture$/.test(field))).toEqual([]);
    expect(warnings).toEqual([expect.stringMatching(/lack its texture coordinates .* and 10 more\)$/)]);
  });

  test("are not needed for a mesh to keep the texture coordinates that say where anisotropy points", async () => {
    const KHR_materials_anisotropy = { anisotropyStrength: 1 };
    const { mesh } = await load({ KHR_materials_anisotropy });
    expect(roundedNumbers(mesh.uvs)).toEqual([0, 0, 1, 0, 0, 1]);
    const isotropic = await load({ KHR_materials_anisotropy: { anisotropyStrength: 0 } });
    expect(isotropic.mesh.uvs).toBeUndefined();
  });
});

describe("numbers that glTF does not allow", () => {
  test("are the nearest that it does", async () => {
    const { material } = await load({
      KHR_materials_ior: { ior: 2 },
      KHR_materials_transmission: { transmissionFactor: 1.5 },
      KHR_materials_volume: { thicknessFactor: 1, attenuationColor: [2, -1, 0.5], attenuationDistance: 1e-30 },
      KHR_materials_dispersion: { dispersion: -1 },
      KHR_materials_diffuse_transmission: { diffuseTransmissionFactor: 9, diffuseTransmissionColorFactor: [2, -1, 0] },
      KHR_materials_specular: { specularFactor: 7, specularColorFactor: [-1, 3, 1e18] },
      KHR_materials_clearcoat: { clearcoatFactor: 1.5, clearcoatRoughnessFactor: -0.5 },
      KHR_materials_sheen: { sheenColorFactor: [3, -1, 0.5], sheenRoughnessFactor: 2 },
      KHR_materials_anisotropy: { anisotropyStrength: 3, anisotropyRotation: 1e18 },
      KHR_materials_iridescence: {
        iridescenceFactor: 4,
        iridescenceIor: 0.5,
        iridescenceThicknessMaximum: -1,
      },
    });
    expect(material).toEqual({
      ...PLAIN,
      ...{ ior: 2, transmission: 1, thickness: 1, attenuationColor: [1, 0, 0.5], attenuationDistance: 1e-18 },
      ...{ diffuseTransmission: 1, diffuseTransmissionColor: [1, 0, 0], specular: 1, specularColor: [0, 3, 1e8] },
      ...{ clearcoat: 1, clearcoatRoughness: 0, sheenColor: [1, 0, 0.5], sheenRoughness: 1 },
      ...{ anisotropy: 1, anisotropyRotation: expect.any(Number) },
      ...{ iridescence: 1, iridescenceIor: 1, iridescenceThickness: 0 },
    });
    expect(Math.abs(material.anisotropyRotation!)).toBeLessThan(360);
  });

  test("below 0 for a strength are 0", async () => {
    const { material } = await load({
      KHR_materials_transmission: { transmissionFactor: -1 },
      KHR_materials_clearcoat: { clearcoatFactor: -1 },
      KHR_materials_sheen: { sheenColorFactor: [-1, 0, 0] },
      KHR_materials_anisotropy: { anisotropyStrength: -1 },
      KHR_materials_iridescence: { iridescenceFactor: -1 },
      KHR_materials_specular: { specularFactor: -1 },
    });
    expect(material).toEqual({ ...PLAIN, specular: 0 });
  });
});

describe("a solid", () => {
  const solid = (volume: object, extensions: Extensions = {}, more: object = {}) =>
    load(
      {
        KHR_materials_transmission: { transmissionFactor: 1 },
        KHR_materials_volume: { thicknessFactor: 1, attenuationColor: [0.5, 0.5, 0.5], ...volume },
        ...extensions,
      },
      more,
    );

  test.each([
    ["is absent", {}],
    ["is infinite", { attenuationDistance: "INFINITE" }],
    ["is null, as JavaScript writes infinity", { attenuationDistance: null }],
    ["is the largest float", { attenuationDistance: 3.4028235e38 }],
  ])("absorbs nothing where the distance %s", async (_, volume) => {
    const file = triangleFile((json, packer) => {
      addSurface(json, packer, {
        KHR_materials_transmission: { transmissionFactor: 1 },
        KHR_materials_volume: { thicknessFactor: 1, attenuationColor: [0.5, 0.5, 0.5], ...volume },
      });
    });
    const { scene, warnings } = await loadGltf(withJson(file, (text) => text.replace('"INFINITE"', "1e999")));
    expect(scene.materials!["material 0"]).toEqual({ ...PLAIN, transmission: 1, thickness: 1 });
    expect(warnings).toEqual([]);
  });

  test.each([0, -1])(
    "absorbs nothing where the distance is %d, which some mean by that and glTF does not allow",
    async (attenuationDistance) => {
      const { material, warnings } = await solid({ attenuationDistance });
      expect(material).toEqual({ ...PLAIN, transmission: 1, thickness: 1 });
      expect(warnings).toEqual([
        `KHR_materials_volume: an attenuationDistance of ${attenuationDistance} is not allowed, so nothing is absorbed (materials[0])`,
      ]);
    },
  );

  test("of thickness 0 is a thin wall, which absorbs and disperses nothing", async () => {
    const { material } = await solid(
      { thicknessFactor: 0, attenuationDistance: 1 },
      { KHR_materials_dispersion: { dispersion: 1 } },
    );
    expect(material).toEqual({ ...PLAIN, transmission: 1 });
  });

  test("that lets no light in is left out", async () => {
    const { material } = await solid(
      { attenuationDistance: 1 },
      { KHR_materials_transmission: { transmissionFactor: 0 } },
    );
    expect(material).toEqual(PLAIN);
  });

  test("may be entered by diffuse transmission alone", async () => {
    const { material } = await solid(
      {},
      { KHR_materials_transmission: {}, KHR_materials_diffuse_transmission: { diffuseTransmissionFactor: 1 } },
    );
    expect(material).toMatchObject({ diffuseTransmission: 1, thickness: 1 });
  });

  test("has no second side: doubleSided says nothing of it", async () => {
    const { material, warnings } = await solid({}, {}, { doubleSided: true });
    expect(material).toEqual({ ...PLAIN, transmission: 1, thickness: 1 });
    expect(warnings).toEqual([]);
  });
});

describe("KHR_materials_ior", () => {
  test("of 0 reflects all light, as far as the specular colour lets it", async () => {
    const KHR_materials_ior = { ior: 0 };
    expect((await load({ KHR_materials_ior })).material).toEqual({ ...PLAIN, specularColor: [25, 25, 25] });
    const KHR_materials_specular = { specularColorFactor: [1, 0.5, 0.04], specularColorTexture: { index: 4 } };
    const { material, warnings } = await load({ KHR_materials_ior, KHR_materials_specular });
    expect(material).toEqual({ ...PLAIN, specularColor: [25, 12.5, 1], specularColorTexture: "image 4" });
    expect(warnings).toEqual([]);
  });

  test("of 0 on a solid says what its refraction is", async () => {
    const { warnings } = await load({
      KHR_materials_ior: { ior: 0 },
      KHR_materials_transmission: { transmissionFactor: 1 },
      KHR_materials_volume: { thicknessFactor: 1 },
    });
    expect(warnings).toEqual([
      expect.stringMatching(/^KHR_materials_ior: 0 stands for infinity.* refracts as with 1.5 /),
    ]);
  });

  test.each([
    [0.75, 0.75, "KHR_materials_ior: 0.75 is not allowed, and shown as it is: as if what is around were denser"],
    [1e-30, 1e-3, "KHR_materials_ior: 1e-30 is not allowed, and shown as it is: as if what is around were denser"],
    [-2, 1.5, "KHR_materials_ior: -2 is not allowed: 1.5 takes its place"],
  ])("of %d, which glTF does not allow, is %d, and that is said", async (ior, shown, said) => {
    const { material, warnings } = await load({ KHR_materials_ior: { ior } });
    expect(material).toEqual({ ...PLAIN, ior: shown });
    expect(warnings).toEqual([`${said} (materials[0])`]);
  });

  test("of 1 and more is ours", async () => {
    expect((await load({ KHR_materials_ior: { ior: 1 } })).material.ior).toBe(1);
    expect((await load({ KHR_materials_ior: { ior: 2.42 } })).material.ior).toBe(2.42);
  });
});

describe("what is of the wrong type is refused, with its path", () => {
  const refusal = async (extensions: Extensions) => {
    const file = triangleFile((json, packer) => addSurface(json, packer, extensions));
    const error: Error = await loadGltf(file, { decodeImage }).then(
      () => new Error("it was read"),
      (reason) => reason,
    );
    return error.message;
  };
  const at = "the file: materials[0].extensions";

  test.each<readonly [Extensions, string]>([
    [
      { KHR_materials_transmission: { transmissionFactor: "all" } },
      'KHR_materials_transmission.transmissionFactor: expected number, got "all"',
    ],
    [
      { KHR_materials_volume: { attenuationDistance: "Infinity" } },
      'KHR_materials_volume.attenuationDistance: expected number, got "Infinity"',
    ],
    [{ KHR_materials_sheen: { sheenColorFactor: 1 } }, "KHR_materials_sheen.sheenColorFactor: expected Array, got 1"],
    [{ KHR_materials_sheen: { sheenColorFactor: [1, 1] } }, "KHR_materials_sheen.sheenColorFactor[2]: is missing"],
    [{ KHR_materials_clearcoat: 1 as never }, "KHR_materials_clearcoat: expected Object, got 1"],
    [
      { KHR_materials_specular: { specularTexture: 0 } },
      "KHR_materials_specular.specularTexture: expected Object, got 0",
    ],
    [
      { KHR_materials_iridescence: { iridescenceTexture: { index: 13 } } },
      "KHR_materials_iridescence.iridescenceTexture.index: expected the index of one of 13 textures, got 13",
    ],
  ])("%j", async (extensions, said) => {
    expect(await refusal(extensions)).toBe(`${at}.${said}`);
  });

  test("or shown, whatever value of the material is replaced, seed 9", async () => {
    const file = triangleFile((json, packer) => addSurface(json, packer, FULL_EXTENSIONS));
    const random = createRandom(9);
    const odd = [-1, 0, 1e18, 1e300, 0.5, null, "", "x", [], {}, [[]], true, 99, [1, 1, 1]];
    const complaints = new Set<string>();
    for (let i = 0; i < 300; i++) {
      const bytes = withJson(file, (text) => {
        const json = JSON.parse(text);
        const slots = slotsOf(json.materials);
        const [holder, key] = slots[Math.floor(random() * slots.length)]!;
        Reflect.set(holder, key, odd[Math.floor(random() * odd.length)]);
        return JSON.stringify(json);
      });
      const loaded = await loadGltf(bytes, { decodeImage }).catch((error) => error);
      if (loaded instanceof Error) {
        expect(loaded).toMatchObject({ name: "LoadError" });
        complaints.add(loaded.message);
      } else parseScene(loaded.scene);
    }
    expect(complaints.size).toBeGreaterThan(50); // it got further than the first check
  });
});

/** A .glb with the text of its JSON changed. */
function withJson(file: Uint8Array, change: (text: string) => string): Uint8Array {
  const end = 20 + new DataView(file.buffer, file.byteOffset).getUint32(12, true);
  return container(change(new TextDecoder().decode(file.subarray(20, end))), file.subarray(end + 8));
}

/** Every place in some JSON where a value is. */
function slotsOf(json: object): (readonly [holder: object, key: string])[] {
  return Object.entries(json).flatMap(([key, value]) => {
    const within = typeof value === "object" && value !== null ? slotsOf(value) : [];
    return [[json, key] as const, ...within];
  });
}
