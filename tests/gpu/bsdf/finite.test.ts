import { afterAll, describe, expect, test } from "vitest";
import type { Material, Vec3 } from "../../../src/scene/schema";
import { type BsdfInput, evaluateBsdf, sampleBsdf } from "../../support/deviceBsdf";
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
};

const COSINES = [0, 1e-38, 1e-30, 1e-20, 1e-12, 1e-7, 1e-4, 0.01, 0.3, 0.8, 1 - 2 ** -24, 1];
const AZIMUTHS = [0, 1e-6, 0.5, 3, Math.PI];
// u.x turns the cap, u.y is its height; the lobe's choice.
const EXTREMES = [0, 2 ** -24, 0.25, 0.5, 1 - 2 ** -24];

const VIEWERS = COSINES.map((cosine) => directionAt(cosine, 0));
const LIGHTS = [...COSINES, -1e-7, -0.5, -1].flatMap((cosine) => AZIMUTHS.map((phi) => directionAt(cosine, phi)));

const rows: StabilityRow[] = [];
afterAll(() => recordStability("bsdf-finite", rows));

describe.each(Object.keys(MATERIALS))("%s", (name) => {
  const materials = ROUGHNESS.map((roughness): Material => ({ ...MATERIALS[name]!, roughness }));

  test("reflects a finite, non-negative share of light from any direction", async () => {
    const inputs = everyMaterial((material) =>
      VIEWERS.flatMap((wo) => [...LIGHTS, wo, negate(wo)].map((x) => ({ material, wo, x }))),
    );
    const values = await evaluateBsdf(materials, inputs);
    expect(faults(inputs, values, 4)).toEqual([]);
    // Nothing is reflected through the surface, and nothing seen from below.
    expect(inputs.filter(({ x }, i) => x[2] < 0 && !Object.is(values[4 * i + 3], 0))).toEqual([]);
    record(`${name}: f and its density, roughness down to 1e-30, grazing, wi = ±wo`, inputs);
  });

  test("is sampled without a number that is not finite, whatever the random numbers", async () => {
    const inputs = everyMaterial((material) =>
      VIEWERS.flatMap((wo) =>
        EXTREMES.flatMap((u) =>
          EXTREMES.flatMap((v) => EXTREMES.map((lobe) => ({ material, wo, x: [u, v, lobe] as const }))),
        ),
      ),
    );
    const values = await sampleBsdf(materials, inputs);
    // wi may point down when the sample fails; density and weight may not be negative.
    expect(
      faults(
        inputs,
        values.map((value, i) => (i % 8 < 3 ? Math.abs(value) : value)),
        8,
      ),
    ).toEqual([]);
    const odd = inputs.filter(({ wo }, i) => {
      const [x, y, z, pdf] = values.subarray(8 * i, 8 * i + 4) as unknown as [number, number, number, number];
      const isUnitAbove = Math.abs(Math.hypot(x, y, z) - 1) < 1e-6 && z > 0;
      return pdf !== 0 && wo[2] !== 0 && !isUnitAbove;
    });
    expect(odd).toEqual([]);
    record(`${name}: samples, random numbers at 0 and 1 − 2⁻²⁴`, inputs);
  });
});

function record(what: string, inputs: readonly BsdfInput[]): void {
  rows.push({ case: what, asserted: "0 values that are not finite or negative", inputs: inputs.length, worst: 0 });
}

function everyMaterial(inputs: (material: number) => BsdfInput[]): BsdfInput[] {
  return ROUGHNESS.flatMap((_, i) => inputs(i));
}

/** The first few inputs with a value that is not finite or negative. */
function faults(inputs: readonly BsdfInput[], values: Float32Array, stride: number): unknown[] {
  return inputs
    .map((input, i) => ({ ...input, values: Array.from(values.subarray(stride * i, stride * (i + 1))) }))
    .filter((row) => !row.values.every((value) => Number.isFinite(value) && value >= 0))
    .map(({ material, wo, x, values: found }) => ({ roughness: ROUGHNESS[material!], wo, x, found }))
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
