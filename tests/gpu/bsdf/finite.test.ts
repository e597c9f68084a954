import { afterAll, describe, expect, test } from "vitest";
import type { Material, Vec3 } from "../../../src/scene/schema";
import { type BsdfInput, evaluateBsdf, expectBsdf, sampleBsdf } from "../../support/deviceBsdf";
import { normalize } from "../../support/directionBins";
import { recordStability, type StabilityRow } from "../../support/stabilityRows";

// No input of the domain, however extreme, gives a number that is not finite, or a negative one.

const ROUGHNESS = [1e-30, 1e-10, 1e-5, 1e-4, 2.4e-4, 2.5e-4, 1e-3, 0.01, 0.03, 0.1, 0.5, 1];
const MATERIALS: Readonly<Record<string, Material>> = {
  "a metal": { metallic: 1, baseColor: [1, 0.5, 0] },
  "a metal with multiple scattering": { metallic: 1, multiscatter: true },
  "a dielectric": { ior: 1.5 },
  "a dielectric of ior 1 + 2⁻⁵²": { ior: 1 + 2 ** -52 },
  "a dielectric of ior 1e6": { ior: 1e6 },
  "a half metal of ior 1": { ior: 1, metallic: 0.5 },
  "a trace of metal, ior 1": { ior: 1, metallic: 1e-30 },
  "a black half metal of ior 1": { ior: 1, metallic: 0.5, baseColor: [0, 0, 0] },
  "Schlick–Beckmann masking": { metallic: 0.5, masking: "schlick-beckmann" },
  "an anisotropic metal": { metallic: 1, anisotropy: 1 },
  "a slightly anisotropic metal with multiple scattering": { metallic: 1, anisotropy: 1e-3, multiscatter: true },
  "a tinted dielectric": { specular: 0.5, specularColor: [0, 1, 1e6] },
  "a dielectric without reflection": { specular: 0 },
  "upright fibres": { sheenColor: [1, 0, 1], sheenRoughness: 0 },
  "fibres in all directions, on metal": { metallic: 1, sheenColor: [1, 1, 1], sheenRoughness: 1 },
  "a mirror coat": { clearcoat: 1 },
  "a rough coat": { clearcoat: 1, clearcoatRoughness: 1 },
  "a narrow coat on metal": { metallic: 1, clearcoat: 0.5, clearcoatRoughness: 2.5e-4 },
  "a film of no thickness": { metallic: 1, iridescence: 1, iridescenceThickness: 0 },
  "a thin film of ior 3 on a black metal": {
    ...{ metallic: 1, baseColor: [0, 0, 0], iridescence: 1, iridescenceIor: 3, iridescenceThickness: 10 },
  },
  "a thick film on a dielectric": { iridescence: 1, iridescenceThickness: 1e4 },
};

// Of the lobes of glTF's extensions.
const PLAIN = ["metallic", "baseColor", "ior", "masking", "multiscatter"];
const FEW = [1e-30, 2.5e-4, 0.01, 0.5, 1];

// Those that let light through: what is scattered below is finite too, from both sides.
const GLASS: Material = { transmission: 1, thickness: 1 };
const OPEN: Readonly<Record<string, Material>> = {
  glass: GLASS,
  "glass of ior 1.001": { ...GLASS, ior: 1.001 },
  "glass of ior 0.999": { ...GLASS, ior: 0.999 },
  "glass of ior 1 + 2⁻⁵²": { ...GLASS, ior: 1 + 2 ** -52 },
  "glass of ior 3": { ...GLASS, ior: 3 },
  "glass of ior 1e6": { ...GLASS, ior: 1e6 },
  "tinted glass": { ...GLASS, specularColor: [0, 0, 1] },
  "tinted glass of ior 10": { ...GLASS, ior: 10, specularColor: [0, 0, 1] },
  "glass without reflection": { ...GLASS, specular: 0 },
  "anisotropic glass": { ...GLASS, anisotropy: 1 },
  "iridescent glass": { ...GLASS, iridescence: 1, iridescenceThickness: 10 },
  "a wall": { transmission: 1 },
  "an anisotropic wall of ior 1": { transmission: 1, ior: 1, anisotropy: 1 },
  "diffuse transmission": { diffuseTransmission: 1 },
  "everything at once": {
    ...{ ...GLASS, transmission: 0.5, diffuseTransmission: 0.5, metallic: 0.2, anisotropy: 0.5, iridescence: 0.5 },
    ...{ sheenColor: [0.5, 0.5, 0.5], sheenRoughness: 0.1, clearcoat: 0.7, clearcoatRoughness: 0.1, specular: 0.8 },
  },
};

const COSINES = [0, 1e-38, 1e-30, 1e-20, 1e-12, 1e-7, 1e-4, 0.01, 0.3, 0.8, 1 - 2 ** -24, 1];
const AZIMUTHS = [0, 1e-6, 0.5, 3, Math.PI];
// u.x turns the cap, u.y is its height; the lobe's choice.
const EXTREMES = [0, 2 ** -24, 0.25, 0.5, 1 - 2 ** -24];

const VIEWERS = COSINES.map((cosine) => directionAt(cosine, 0));
const LIGHTS = [...COSINES, -1e-7, -0.5, -1].flatMap((cosine) => AZIMUTHS.map((phi) => directionAt(cosine, phi)));

const SOME_LIGHTS = LIGHTS.filter((_, i) => i % 3 === 0).flatMap(([x, y, z]): Vec3[] => [
  [x, y, z],
  [x, y, -z],
]);

const rows: StabilityRow[] = [];
afterAll(() => recordStability("bsdf-finite", rows));

describe.each(Object.keys({ ...MATERIALS, ...OPEN }))("%s", (name) => {
  const base = MATERIALS[name] ?? OPEN[name]!;
  const isPlain = Object.keys(base).every((key) => PLAIN.includes(key));
  const roughnesses = isPlain ? ROUGHNESS : FEW;
  const materials = roughnesses.map((roughness): Material => ({ ...base, roughness }));
  const everyMaterial = (inputs: (material: number) => BsdfInput[]) => roughnesses.flatMap((_, i) => inputs(i));
  const isOpen = name in OPEN;
  const fronts = base.thickness ? [true, false] : [true];

  test("reflects a finite, non-negative share of light from any direction", async () => {
    const inputs = everyMaterial((material) =>
      VIEWERS.flatMap((wo) => {
        const lights = [...LIGHTS, wo, negate(wo)];
        const all = isOpen ? [...lights, ...lights.map(([x, y, z]): Vec3 => [x, y, -z])] : lights;
        return all.flatMap((x) => fronts.map((front) => ({ material, wo, x, front })));
      }),
    );
    const values = await evaluateBsdf(materials, inputs);
    expect(faults(materials, inputs, values, 4)).toEqual([]);
    // Nothing is reflected through the surface, and nothing seen from below.
    if (!isOpen) expect(inputs.filter(({ x }, i) => x[2] < 0 && !Object.is(values[4 * i + 3], 0))).toEqual([]);
    record(`${name}: f and its density, roughness down to 1e-30, grazing, wi = ±wo`, inputs);
  });

  test("is sampled without a number that is not finite, whatever the random numbers", async () => {
    const inputs = everyMaterial((material) =>
      VIEWERS.flatMap((wo) =>
        EXTREMES.flatMap((u) =>
          EXTREMES.flatMap((v) =>
            EXTREMES.flatMap((lobe) => fronts.map((front) => ({ material, wo, x: [u, v, lobe] as const, front }))),
          ),
        ),
      ),
    );
    const values = await sampleBsdf(materials, inputs);
    // wi may point down when the sample fails; density and weight may not be negative.
    expect(
      faults(
        materials,
        inputs,
        values.map((value, i) => (i % 8 < 3 ? Math.abs(value) : value)),
        8,
      ),
    ).toEqual([]);
    const odd = inputs.filter(({ wo }, i) => {
      const [x, y, z, pdf] = values.subarray(8 * i, 8 * i + 4) as unknown as [number, number, number, number];
      const isUnit = Math.abs(Math.hypot(x, y, z) - 1) < 1e-6;
      return pdf !== 0 && wo[2] !== 0 && !(isUnit && (z > 0 || isOpen));
    });
    expect(odd).toEqual([]);
    record(`${name}: samples, random numbers at 0 and 1 − 2⁻²⁴`, inputs);
  });

  test("is expected to scatter a finite share of a ball of light, and something wherever it scatters any", async () => {
    const inputs = everyMaterial((material) =>
      VIEWERS.flatMap((wo) =>
        SOME_LIGHTS.flatMap((x) =>
          fronts.flatMap((front) => [0, 0.5, 1e3].map((size) => ({ material, wo, x, front, size }))),
        ),
      ),
    );
    const expected = await expectBsdf(materials, inputs);
    expect(faults(materials, inputs, expected, 4)).toEqual([]);
    const values = await evaluateBsdf(materials, inputs);
    // f·cos above what the shader may flush.
    const missed = inputs.filter(
      (_, i) => Math.max(...values.subarray(4 * i, 4 * i + 3)) > 1e-30 && !(expected[4 * i]! > 0),
    );
    expect(missed.slice(0, 3)).toEqual([]);
  });
});

function record(what: string, inputs: readonly BsdfInput[]): void {
  rows.push({ case: what, asserted: "0 values that are not finite or negative", inputs: inputs.length, worst: 0 });
}

/** The first few inputs with a value that is not finite or negative. */
function faults(
  materials: readonly Material[],
  inputs: readonly BsdfInput[],
  values: Float32Array,
  stride: number,
): unknown[] {
  return inputs
    .map((input, i) => ({ ...input, values: Array.from(values.subarray(stride * i, stride * (i + 1))) }))
    .filter((row) => !row.values.every((value) => Number.isFinite(value) && value >= 0))
    .map(({ material, values: found, ...input }) => ({ ...input, roughness: materials[material!]!.roughness, found }))
    .slice(0, 3);
}

function directionAt(cosine: number, phi: number): Vec3 {
  const sine = Math.sqrt(1 - cosine ** 2);
  const v = [sine * Math.cos(phi), sine * Math.sin(phi), cosine] as const;
  return Math.abs(cosine) < 1e-6 ? v : normalize(v);
}

function negate(v: Vec3): Vec3 {
  return [-v[0], -v[1], -v[2]];
}
