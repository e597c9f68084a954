import { describe, expect, test } from "vitest";
import { EFFECTS, EMISSION, hasMasking, SURFACE } from "../../../src/panel/materialTable";
import { defaultsOf } from "../../../src/scene/containers";
import { type Material, MaterialSchema, type ResolvedMaterial } from "../../../src/scene/schema";

const DEFAULTS = defaultsOf(MaterialSchema) as ResolvedMaterial;

/** The knobs that the panel shows for a material, those of an effect as `sheen: colour`. */
function shownFor(material: Material): string[] {
  const resolved = { ...DEFAULTS, ...material } as ResolvedMaterial;
  const effects = EFFECTS.filter(({ matters }) => matters(resolved)).flatMap(({ title, knobs }) =>
    knobs.map((knob) => ({ ...knob, label: `${title}: ${knob.label}` })),
  );
  const shown = [...SURFACE, ...EMISSION, ...effects].filter(({ matters }) => matters?.(resolved) ?? true);
  return shown.map(({ label }) => label);
}

const OPENERS = [
  "transmission: amount",
  "translucency: amount",
  "specular: amount",
  "coat: amount",
  "sheen: colour",
  "film: amount",
];

describe("knobs that would change nothing are hidden", () => {
  test("of effects that are off all but the one that turns them on", () => {
    const shown = shownFor({});
    expect(shown).toEqual(expect.arrayContaining(OPENERS));
    expect(
      shown.filter((label) => /thickness|fades|dispersion|coat: rough|sheen: rough|film: ior/.test(label)),
    ).toEqual([]);
  });

  test.each<readonly [Material, readonly string[]]>([
    [{ transmission: 1 }, ["transmission: thickness"]],
    [{ diffuseTransmission: 1 }, ["translucency: colour", "transmission: thickness"]],
    [
      { transmission: 1, thickness: 1 },
      ["transmission: thickness", "transmission: fades over", "transmission: dispersion"],
    ],
    [
      { diffuseTransmission: 1, thickness: 1 },
      ["translucency: colour", "transmission: thickness", "transmission: fades over"],
    ],
    [
      { transmission: 1, thickness: 1, attenuationDistance: 1 },
      ["transmission: thickness", "transmission: fades over", "transmission: fades to", "transmission: dispersion"],
    ],
    [{ clearcoat: 0.1 }, ["coat: roughness"]],
    [{ sheenColor: [0, 0, 0.1] }, ["sheen: roughness"]],
    [{ iridescence: 0.1 }, ["film: ior", "film: thickness"]],
    [{ roughness: 0.5 }, ["anisotropy: amount"]],
    [{ roughness: 0.5, anisotropy: 0.1 }, ["anisotropy: amount", "anisotropy: rotation"]],
    [{ metallicRoughnessTexture: "picture" }, ["anisotropy: amount"]],
    [{ emission: [1, 0, 0] }, ["emission"]],
  ])("%j shows %j too", (material, more) => {
    const plain = new Set(shownFor({}));
    expect(shownFor(material).filter((label) => !plain.has(label))).toEqual(expect.arrayContaining([...more]));
    expect(shownFor(material)).toHaveLength(plain.size + more.length);
  });

  test.each<readonly [Material, RegExp]>([
    [{ metallic: 1 }, /^ior|^trans|^specular/],
    [{ ior: 1 }, /^specular/],
    [{ specular: 0 }, /^specular: (colour|strength)/],
    [{ unlit: true }, /^(?!colour$)/],
  ])("%j shows fewer: not %s", (material, hidden) => {
    expect(shownFor(material)).toEqual(shownFor({}).filter((label) => !hidden.test(label)));
  });

  test("but a texture may leave some texels of a metal dielectric", () => {
    expect(shownFor({ metallic: 1, metallicRoughnessTexture: "picture" })).toEqual(expect.arrayContaining(["ior"]));
  });

  test("masking is of rough surfaces that reflect", () => {
    const masks = (material: Material) => hasMasking({ ...DEFAULTS, ...material } as ResolvedMaterial);
    expect(masks({})).toBe(true);
    for (const material of [{ roughness: 0 }, { ior: 1 }, { specular: 0 }, { unlit: true }]) {
      expect(masks(material)).toBe(false);
      expect(masks({ ...material, metallic: 1 })).toBe(!("roughness" in material || "unlit" in material));
    }
    expect(masks({ ior: 0.7 })).toBe(true);
  });
});

test("no field has two knobs, but for those that are a hue and a strength", () => {
  const fields = [...SURFACE, ...EMISSION, ...EFFECTS.flatMap(({ knobs }) => knobs)].map(({ field }) => field);
  expect(fields.filter((field, i) => fields.indexOf(field) !== i)).toEqual(["emission", "specularColor"]);
});
