import { afterAll, beforeAll, describe, expect, test } from "vitest";
import type { Material, Vec3 } from "../../../src/scene/schema";
import { type BsdfInput, sampleBsdf, sampleUniformly } from "../../support/deviceBsdf";
import { sheenAlbedoOf } from "../../support/deviceSheen";
import { albedoOf, LEAST_SHEEN_ROUGHNESS, type SheenAlbedo } from "../../support/khrMaterials";
import { createRandom } from "../../support/random";
import { recordStability, type StabilityRow } from "../../support/stabilityRows";

// What lobes scatter of light from all around: samples against quadrature in doubles, and never more than they get.

const SAMPLES = 4096;
const ANGLES = [0, 45, 75, 88];
const ROUGHNESS = [0.1, 0.5, 1];
const COLOR = [1, 0.6, 0.2] as const;
const WHITE = [1, 1, 1] as const;
const GLASS: Material = { transmission: 1, thickness: 1 };

type Case = {
  readonly name: string;
  readonly base: Material;
  readonly field?: "roughness" | "clearcoatRoughness" | "sheenRoughness";
  readonly values?: readonly number[];
  readonly fronts?: readonly boolean[];
  /** What it may scatter of what it gets; 1 but for glTF's dielectrics. */
  readonly most?: number;
};

// glTF's dielectric is (1 − F)·Lambert + F·GGX with F at the half vector. Seen at a grazing angle F is near 1 for the highlight and
// near 0 for the rest: they pass 1, by the format's definition. See albedo.test.ts. A white one of roughness 0.1 reflects so much.
const GLTF = 1.72;

const BOTH = [true, false];
const MIRROR: Material = { metallic: 1, roughness: 0 };
const CASES: readonly Case[] = [
  { name: "glass", base: GLASS, fronts: BOTH },
  { name: "diamond", base: { ...GLASS, ior: 2.4 }, fronts: BOTH },
  { name: "coloured, tinted glass", base: { ...GLASS, baseColor: COLOR, specularColor: [0.2, 1, 3], specular: 0.9 } },
  { name: "a rough wall", base: { transmission: 1 } },
  { name: "diffuse transmission", base: { diffuseTransmission: 0.5 }, most: GLTF },
  { name: "a tinted dielectric", base: { specular: 0.5, specularColor: [0.5, 1, 4] }, most: GLTF },
  { name: "an anisotropic metal", base: { metallic: 1, anisotropy: 0.8 } },
  { name: "anisotropic glass", base: { ...GLASS, anisotropy: 0.8 }, fronts: BOTH },
  { name: "an iridescent metal", base: { metallic: 1, baseColor: COLOR, iridescence: 1 } },
  {
    name: "iridescent glass",
    base: { ...GLASS, iridescence: 1, iridescenceThickness: 300 },
    values: [0.1, 0.7],
    fronts: BOTH,
  },
  { name: "a coat on a white metal", base: { metallic: 1, roughness: 0.3, clearcoat: 1 }, field: "clearcoatRoughness" },
  {
    name: "a coat on a white mirror",
    base: { ...MIRROR, clearcoat: 1 },
    field: "clearcoatRoughness",
    values: [0, 0.3, 1],
  },
  { name: "a coat on white paper", base: { ior: 1, clearcoat: 1 }, field: "clearcoatRoughness", values: [0, 0.3, 1] },
  {
    name: "a coat on glass",
    base: { ...GLASS, roughness: 0.3, clearcoat: 1 },
    field: "clearcoatRoughness",
    fronts: BOTH,
  },
  {
    name: "a coat on smooth glass",
    base: { ...GLASS, roughness: 0, clearcoat: 1 },
    field: "clearcoatRoughness",
    values: [0, 0.5],
  },
  {
    name: "white fibres on white paper",
    base: { ior: 1, sheenColor: WHITE },
    field: "sheenRoughness",
    values: [0, 0.15, 0.3, 0.6, 1],
  },
  {
    name: "coloured fibres on a mirror",
    base: { ...MIRROR, sheenColor: [1, 0.5, 0] },
    field: "sheenRoughness",
    values: [0, 0.3, 1],
  },
  {
    name: "white paper under white fibres under a coat",
    base: { ior: 1, sheenColor: WHITE, clearcoat: 1, clearcoatRoughness: 0.3 },
    field: "sheenRoughness",
    values: [0, 0.15, 0.3, 0.6, 1],
  },
  {
    name: "fibres on glass",
    base: { ...GLASS, roughness: 0.4, sheenColor: WHITE },
    field: "sheenRoughness",
    values: [0.2, 1],
    fronts: BOTH,
  },
  {
    name: "half of everything",
    base: {
      ...{ ...GLASS, transmission: 0.5, diffuseTransmission: 0.5, anisotropy: 0.5, iridescence: 0.5, specular: 0.8 },
      ...{ sheenColor: [0.5, 0.5, 0.5], sheenRoughness: 0.5, clearcoat: 0.7, clearcoatRoughness: 0.4 },
    },
    values: [0.5],
    fronts: BOTH,
    most: GLTF,
  },
];

let albedos: ReadonlyMap<number, SheenAlbedo>;
beforeAll(async () => {
  const roughnesses = [...new Set(CASES.flatMap(({ base, values = [] }) => [...values, base.sheenRoughness ?? 0]))];
  const tables = await sheenAlbedoOf(roughnesses.map((value) => Math.max(value, LEAST_SHEEN_ROUGHNESS)));
  albedos = new Map(roughnesses.map((roughness, i) => [roughness, tables[i]!]));
});

const rows: StabilityRow[] = [];
afterAll(() => recordStability("lobe-albedo", rows));

describe.each(CASES)(
  "$name, seed 23,",
  ({ name, base, field = "roughness", values = ROUGHNESS, fronts = [true], most = 1 }) => {
    const materials = values.map((value): Material => ({ ...base, [field]: value }));
    const configurations = materials.flatMap((surface, material) =>
      fronts.flatMap((front) =>
        ANGLES.map((degrees) => {
          const wo = directionAt(degrees);
          return {
            material,
            front,
            wo,
            what: `${field} ${surface[field]}, ${degrees}°, ${front ? "front" : "inside"}`,
          };
        }),
      ),
    );

    test("scatters what quadrature says, above and below, and no more than it gets", async () => {
      const measured = await measure(materials, configurations, sampleBsdf);
      let [worst, brightest, where, offset] = [0, 0, "", 0];
      for (const [i, { material, front, wo, what }] of configurations.entries()) {
        const surface = materials[material]!;
        const exact = albedoOf(surface, wo, front, albedos.get(surface.sheenRoughness ?? 0));
        for (const side of ["above", "below"] as const) {
          for (const c of [0, 1, 2]) {
            const { mean, deviation } = measured[i]![side];
            const difference = Math.abs(mean[c]! - exact[side][c]!);
            offset = Math.max(offset, difference);
            const allowed = 4.5 * deviation[c]! + QUADRATURE;
            if (difference / allowed > worst) worst = difference / allowed;
            expect
              .soft(difference, `${what}, ${side}, ${c}: ${mean[c]} against ${exact[side][c]}`)
              .toBeLessThan(allowed);
          }
        }
        const sum = Math.max(...exact.sum);
        if (sum > brightest) [brightest, where] = [sum, what];
      }
      console.log(
        `${name}: largest albedo ${brightest.toFixed(4)} (${where}); off by ${offset.toFixed(4)}, ${worst.toFixed(2)} of the bound`,
      );
      rows.push({
        case: `${name}: E[f·cos/pdf] above and below against ∫f·cos, 0° to 88°`,
        asserted: `difference ≤ 4.5σ; largest albedo ${brightest.toFixed(3)} (worst is in units of that bound)`,
        inputs: configurations.length * SAMPLES,
        worst,
      });
      expect(brightest, where).toBeLessThanOrEqual(most + (most === 1 ? 1e-4 : 0));
    });
  },
);

// The midpoint rule on 48 · 96 normals and as many directions.
const QUADRATURE = 4e-3;

test.each(CASES.filter(({ field }) => field))(
  "the baseline estimator draws $name as much, seed 24",
  async ({ base, field }) => {
    const material: Material = { ...base, [field!]: 1 };
    const configurations = [0, 45].map((degrees) => ({ material: 0, front: true, wo: directionAt(degrees) }));
    const measured = await measure([material], configurations, sampleUniformly);
    for (const [i, { wo }] of configurations.entries()) {
      const exact = albedoOf(material, wo, true, albedos.get(material.sheenRoughness ?? 0));
      for (const side of ["above", "below"] as const) {
        const { mean, deviation } = measured[i]![side];
        expect(Math.abs(mean[0]! - exact[side][0])).toBeLessThan(5 * deviation[0]! + QUADRATURE);
      }
    }
  },
);

type Configuration = { readonly material: number; readonly front: boolean; readonly wo: Vec3 };

/** Means of the samples' weights, with their standard errors, of directions above and below. */
async function measure(materials: readonly Material[], all: readonly Configuration[], sample: typeof sampleBsdf) {
  const random = createRandom(23);
  const unit = () => Math.floor(random() * 2 ** 24) / 2 ** 24;
  // The lobe's choice in strata, which takes the noise of shares away.
  const drawn = await sample(
    materials,
    all.flatMap(({ material, front, wo }) =>
      Array.from({ length: SAMPLES }, (_, k): BsdfInput => {
        const lobe = Math.min((k + random()) / SAMPLES, 1 - 2 ** -24);
        return { material, front, wo, x: [unit(), unit(), lobe] };
      }),
    ),
  );
  return all.map((_, i) => {
    const [above, below] = [1, -1].map((side) => {
      const sums = [0, 0, 0];
      const squares = [0, 0, 0];
      for (let k = i * SAMPLES; k < (i + 1) * SAMPLES; k++) {
        if (side * drawn[8 * k + 2]! <= 0) continue;
        for (const c of [0, 1, 2]) {
          sums[c]! += drawn[8 * k + 4 + c]!;
          squares[c]! += drawn[8 * k + 4 + c]! ** 2;
        }
      }
      const mean = sums.map((sum) => sum / SAMPLES);
      const deviation = mean.map((m, c) => Math.sqrt(Math.max(squares[c]! / SAMPLES - m ** 2, 0) / SAMPLES));
      return { mean, deviation };
    });
    return { above: above!, below: below! };
  });
}

/** Unit, at an angle to the normal and aslant to the grooves, rounded to f32. */
function directionAt(degrees: number): Vec3 {
  const angle = (degrees * Math.PI) / 180;
  const sine = Math.sin(angle);
  return [Math.fround(sine * Math.cos(0.6)), Math.fround(sine * Math.sin(0.6)), Math.fround(Math.cos(angle))];
}
