import { describe, expect, test } from "vitest";
import { loadGltf } from "../../../src/loaders/gltf";
import { meshesOf, type TriangleJson, triangleFile } from "../../support/gltf";

const load = async (change: (json: TriangleJson) => void, variant?: string) => {
  const loaded = await loadGltf(triangleFile(change), variant === undefined ? {} : { variant });
  return { ...loaded, materials: meshesOf(loaded.scene).map(({ material }) => material) };
};

describe("an extension that is not supported", () => {
  const requiring = (...extensionsRequired: string[]) =>
    load((json) => Object.assign(json, { extensionsRequired, extensionsUsed: extensionsRequired }));

  test.each([
    ["KHR_materials_volume_scatter", "The scattering of light within a material is not shown"],
    ["KHR_materials_something", "What an extension says of materials is not shown"],
    ["ACME_materials_glitter", "What an extension says of materials is not shown"],
    ["EXT_lights_image_based", "The light of the file's surroundings is not shown"],
    ["KHR_animation_pointer", "Animations are not supported: the pose at rest is shown"],
    ["KHR_xmp_json", "Metadata of an extension is not read"],
    ["KHR_interactivity", "What an extension says of sound, motion or behaviour has no effect"],
  ])(
    "is required, %s, and leaves shapes as they are: the file is shown, and what is lost is said",
    async (name, loss) => {
      const { scene, warnings } = await requiring(name);
      expect(meshesOf(scene)).toHaveLength(1);
      expect(warnings).toEqual([`${loss} ("${name}")`]);
    },
  );

  test("is said once, though it is used and required", async () => {
    const { warnings } = await load((json) => {
      json.extensionsUsed = ["KHR_materials_volume_scatter"];
      json.extensionsRequired = ["KHR_materials_volume_scatter"];
    });
    expect(warnings).toHaveLength(1);
  });

  test.each(["EXT_mesh_quantum", "KHR_accessor_float16", "KHR_gaussian_splatting", "toString"])(
    "is required, %s, and may change shapes: the file is refused",
    async (name) => {
      await expect(requiring("KHR_materials_volume_scatter", name)).rejects.toMatchObject({
        name: "LoadError",
        message: `the file requires "${name}", which is not supported and may change its shapes`,
      });
    },
  );
});

describe("KHR_materials_variants", () => {
  const shoe = (json: TriangleJson) => {
    json.extensionsUsed = json.extensionsRequired = ["KHR_materials_variants"];
    json.extensions = {
      KHR_materials_variants: { variants: [{ name: "Beach" }, { name: "Street" }, { name: "Night" }] },
    };
    json.materials = [{ name: "blue" }, { name: "black" }, { name: "white" }];
    const [{ attributes }] = json.meshes[0].primitives;
    const mappings = [
      { material: 1, variants: [1, 2] },
      { material: 2, variants: [0] },
    ];
    json.meshes[0].primitives = [
      { attributes, material: 0, extensions: { KHR_materials_variants: { mappings } } },
      { attributes, material: 2 },
      { attributes, extensions: { KHR_materials_variants: { mappings: [{ material: 0, variants: [2] }] } } },
    ];
  };

  test.each([
    [undefined, ["blue", "white", "default"]],
    ["Beach", ["white", "white", "default"]],
    ["Street", ["black", "white", "default"]],
    ["Night", ["black", "white", "blue"]],
  ])("%s has its materials", async (variant, expected) => {
    const { materials, variants, warnings } = await load(shoe, variant);
    expect(materials).toEqual(expected);
    expect(variants).toEqual(["Beach", "Street", "Night"]);
    expect(warnings).toEqual([]);
  });

  test("a variant that is not there is said, with those that are", async () => {
    const { materials, warnings } = await load(shoe, "Moon");
    expect(materials).toEqual(["blue", "white", "default"]);
    expect(warnings).toEqual(['The file has no variant "Moon": it has "Beach", "Street", "Night"']);
    const bare = await load(() => {}, "Moon");
    expect(bare.variants).toEqual([]);
    expect(bare.warnings).toEqual(['The file has no variant "Moon": it has none']);
  });

  test("of hundreds of variants twenty are named", async () => {
    const { warnings } = await load((json) => {
      const variants = Array.from({ length: 300 }, (_, i) => ({ name: `Look ${i}` }));
      json.extensions = { KHR_materials_variants: { variants } };
    }, "Moon");
    expect(warnings).toEqual([expect.stringMatching(/: it has "Look 0", .*, "Look 19", 280 more$/)]);
  });
});
