import { afterAll, describe, expect, test } from "vitest";
import type { Material, Vec3 } from "../../../src/scene/schema";
import { type BsdfInput, evaluateBsdf, sampleBsdf } from "../../support/deviceBsdf";
import { normalize } from "../../support/directionBins";
import { gltfBrdf, lobeAlbedo, schlickWeight } from "../../support/microfacets";
import { createRandom, randomDirection } from "../../support/random";
import { LONG } from "../../support/stability";
import { recordStability, type StabilityRow } from "../../support/stabilityRows";

const COLOR = [1, 0.5, 0.1] as const;
const ROUGHNESS = [0.03, 0.1, 0.3, 0.6, 1];
const MATERIALS: Readonly<Record<string, Material>> = {
  "a metal": { metallic: 1, baseColor: COLOR },
  "a dielectric": { baseColor: COLOR },
  "a dielectric of ior 3": { ior: 3, baseColor: COLOR },
  "a half metal": { metallic: 0.5, baseColor: COLOR },
  "a half metal of ior 1": { metallic: 0.5, ior: 1, baseColor: COLOR },
  "a Schlick–Beckmann metal": { metallic: 1, baseColor: COLOR, masking: "schlick-beckmann" },
  "a Schlick–Beckmann dielectric": { baseColor: COLOR, masking: "schlick-beckmann" },
  "a Lambert surface": { ior: 1, baseColor: COLOR },
};
const withRoughness = (material: Material) => ROUGHNESS.map((roughness): Material => ({ ...material, roughness }));

const rows: StabilityRow[] = [];
afterAll(() => recordStability("bsdf", rows));

describe.each(Object.keys(MATERIALS))("%s, seed 2,", (name) => {
  const materials = withRoughness(MATERIALS[name]!);

  test("reflects what glTF says, and as much with wo and wi exchanged", async () => {
    const random = createRandom(2);
    const inputs = Array.from({ length: 10000 * LONG }, (_, i): BsdfInput => {
      const material = i % materials.length;
      const wo = upward(random);
      // Half of them close to the mirror direction, where narrow lobes are.
      const spread = materials[material]!.roughness! ** 2 * 4;
      const aside = randomDirection(random).map((component) => component * spread);
      const mirror = normalize([aside[0]! - wo[0], aside[1]! - wo[1], Math.abs(wo[2] + aside[2]!)]);
      return { material, wo, x: rounded(random() < 0.5 ? upward(random) : mirror) };
    }).filter(({ x }) => x[2] > 1e-3);
    const there = await evaluateBsdf(materials, inputs);
    const back = await evaluateBsdf(
      materials,
      inputs.map(({ material, wo, x }) => ({ material: material!, wo: x, x: wo })),
    );
    let [worst, asymmetry] = [0, 0];
    for (const [i, { material, wo, x: wi }] of inputs.entries()) {
      // f32 makes vectors unit to 2⁻²³, and so wo·h good to 2⁻²²/|wo + wi|. F changes 5 times as much, and 1 − F, which
      // goes to 0 with wo·h = |wo + wi|/2 itself, by twice that over |wo + wi|. D changes by up to 2/α per radian of h.
      const length = Math.hypot(wo[0] + wi[0], wo[1] + wi[1], wo[2] + wi[2]);
      const alpha = materials[material!]!.roughness! ** 2;
      const allowed = TERMS + 10 / length + 4 / length ** 2;
      for (const c of [0, 1, 2]) {
        const f = there[4 * i + c]! / wi[2];
        const exact = gltfBrdf(materials[material!]!, COLOR[c]!, wo, wi);
        worst = Math.max(worst, Math.abs(f / exact - 1) / (2 ** -23 * (allowed + 2 / alpha / length)));
        const difference = Math.abs(f / (back[4 * i + c]! / wo[2]) - 1);
        asymmetry = Math.max(asymmetry, difference / (2 ** -23 * allowed));
      }
    }
    expect(worst).toBeLessThan(1);
    expect(asymmetry).toBeLessThan(1); // wo + wi, and with it D, is the same either way
    rows.push({
      case: `${name}: f(wo, wi) = f(wi, wo), roughness 0.03 to 1`,
      asserted: `relative difference < (${TERMS} + 10/s + 4/s²) · 2⁻²³, s = |wo + wi| (worst is in units of that bound)`,
      inputs: inputs.length,
      worst: asymmetry,
    });
  });
});

// D 24, visibility 14, F 6, products and the sum with the diffuse part 6: as in precision.test.ts.
const TERMS = 50;

const ANGLES = [0, 30, 60, 75, 85, 89];
const SAMPLES = 16384;

describe.each([
  ["a white metal", { metallic: 1 }],
  ["a gold metal", { metallic: 1, baseColor: COLOR }],
  ["a white dielectric", {}],
  ["a white dielectric of ior 3", { ior: 3 }],
  ["half a white metal", { metallic: 0.5 }],
] as [string, Material][])("%s, seed 4,", (name, base) => {
  const materials = withRoughness(base);

  test("sampled by its density, reflects what quadrature says; no lobe gives more than it gets", async () => {
    const measured = await measureAlbedo(materials, 4);
    let [worst, most, mostLobe] = [0, 0, 0];
    for (const { material, cosO, mean, standardError } of measured) {
      for (const c of [0, 1, 2]) {
        const { albedo, lobe } = albedoOf(materials[material]!, c, cosO);
        worst = Math.max(worst, Math.abs(mean[c]! - albedo) / (4 * standardError[c]! + 5e-4 * albedo));
        most = Math.max(most, albedo);
        mostLobe = Math.max(mostLobe, lobe);
      }
    }
    console.log(`${name}: largest albedo ${most.toFixed(4)}`);
    expect(worst).toBeLessThan(1);
    expect(mostLobe).toBeLessThanOrEqual(1 + 1e-9);
    // glTF's dielectric is (1 − F)·Lambert + F·GGX with F at the half vector. Seen at a grazing angle F is near 1 for the
    // highlight and near 0 for the rest: the sum passes 1, by the format's definition.
    if (!name.includes("dielectric") && base !== undefined && !name.includes("half"))
      expect(most).toBeLessThanOrEqual(1);
    rows.push({
      case: `${name}: E[f·cos/pdf] and ∫f·cos, roughness 0.03 to 1, 0° to 89°`,
      asserted: `difference ≤ 4σ; largest albedo ${most.toFixed(3)} (worst is in units of that bound)`,
      inputs: measured.length * SAMPLES,
      worst,
    });
  });
});

describe("multiple scattering, seed 5,", () => {
  test("never lets a metal, white or not, give more than it gets, and a white one 99 % of it", async () => {
    const materials = [1, 0.5].flatMap((gray) =>
      withRoughness({ metallic: 1, baseColor: [gray, gray, gray], multiscatter: true }),
    );
    for (const { material, mean, standardError } of await measureAlbedo(materials, 5)) {
      expect(mean[0]).toBeLessThanOrEqual(1 + 4 * standardError[0]! + 5e-4);
      if (material < ROUGHNESS.length) expect(mean[0]).toBeGreaterThan(0.99 - 4 * standardError[0]!);
    }
  });

  test("leaves a half metal no brighter than its dielectric half and a full mirror would be", async () => {
    const halves = withRoughness({ metallic: 0.5, ior: 2, multiscatter: true });
    for (const { material, cosO, mean, standardError } of await measureAlbedo(halves, 6)) {
      const { albedo } = albedoOf({ ...halves[material]!, metallic: 0 }, 0, cosO);
      expect(mean[0]).toBeLessThanOrEqual((1 + albedo) / 2 + 4 * standardError[0]! + 5e-4);
    }
  });

  test("does not touch a dielectric", async () => {
    const random = createRandom(7);
    const inputs = Array.from({ length: 1000 }, (_, i) => ({ material: i % 5, wo: upward(random), x: upward(random) }));
    const [plain, asking] = [withRoughness({}), withRoughness({ multiscatter: true })];
    expect(await evaluateBsdf(asking, inputs)).toEqual(await evaluateBsdf(plain, inputs));
  });
});

test("a white metal with α = 1 reflects 1 − ln 2 of the light from above, seed 8", async () => {
  const [{ mean, standardError } = UNMEASURED] = await measureAlbedo([{ metallic: 1 }], 8, [0]);
  expect(Math.abs(mean[0]! - (1 - Math.LN2))).toBeLessThan(4 * standardError[0]!);
  expect(standardError[0]).toBeLessThan(0.003);
  expect(lobeAlbedo(1, 1).one).toBeCloseTo(1 - Math.LN2, 5);
});

type Measured = {
  readonly material: number;
  readonly cosO: number;
  readonly mean: readonly number[];
  readonly standardError: readonly number[];
};

const UNMEASURED: Measured = { material: 0, cosO: 1, mean: [], standardError: [] };

/** The mean weight of samples, per material and angle. */
async function measureAlbedo(materials: readonly Material[], seed: number, angles = ANGLES): Promise<Measured[]> {
  const random = createRandom(seed);
  const unit = () => Math.floor(random() * 2 ** 24) / 2 ** 24;
  const configurations = materials.flatMap((_, material) =>
    angles.map((degrees) => ({ material, cosO: Math.cos((degrees * Math.PI) / 180) })),
  );
  const drawn = await sampleBsdf(
    materials,
    configurations.flatMap(({ material, cosO }) =>
      Array.from({ length: SAMPLES }, () => ({
        material,
        wo: [Math.sqrt(1 - cosO ** 2), 0, cosO] as const,
        x: [unit(), unit(), unit()] as const,
      })),
    ),
  );
  return configurations.map((configuration, i) => {
    const sums = [0, 0, 0];
    const squares = [0, 0, 0];
    for (let k = i * SAMPLES; k < (i + 1) * SAMPLES; k++) {
      for (const c of [0, 1, 2]) {
        sums[c]! += drawn[8 * k + 4 + c]!;
        squares[c]! += drawn[8 * k + 4 + c]! ** 2;
      }
    }
    const mean = sums.map((sum) => sum / SAMPLES);
    const standardError = squares.map((square, c) =>
      Math.sqrt(Math.max(square / SAMPLES - mean[c]! ** 2, 0) / SAMPLES),
    );
    return { ...configuration, mean, standardError };
  });
}

/** ∫ f·cos dω by quadrature, and the part of it that its microfacets reflect. */
function albedoOf(material: Material, channel: number, cosO: number): { albedo: number; lobe: number } {
  const { baseColor = [1, 1, 1], metallic = 0, roughness = 1, ior = 1.5 } = material;
  const { one, weight } = lobeOf(cosO, roughness ** 2);
  const f0 = ((ior - 1) / (ior + 1)) ** 2;
  const glossy = (F0: number) => F0 * one + (1 - F0) * weight;
  const body = baseColor[channel]! * (1 - f0) * (1 - meanWeight(cosO));
  const lobe = metallic * glossy(baseColor[channel]!) + (1 - metallic) * glossy(f0);
  return { albedo: lobe + (1 - metallic) * body, lobe };
}

const lobeOf = memoize((cosO, alpha) => lobeAlbedo(cosO, alpha));

/** Mean of Schlick's weight of wo·h over cosine-distributed wi, h halfway between them; midpoint rule. */
const meanWeight = memoize((cosO) => {
  const steps = 256;
  let sum = 0;
  for (let i = 0; i < steps; i++) {
    const sin2 = (i + 0.5) / steps;
    for (let j = 0; j < steps; j++) {
      const aside = Math.sqrt((1 - cosO ** 2) * sin2) * Math.cos((Math.PI * (j + 0.5)) / steps);
      sum += schlickWeight(Math.sqrt((1 + aside + cosO * Math.sqrt(1 - sin2)) / 2));
    }
  }
  return sum / steps ** 2;
});

function memoize<T>(compute: (a: number, b: number) => T): (a: number, b?: number) => T {
  const known = new Map<string, T>();
  return (a, b = 0) => {
    const key = `${a} ${b}`;
    if (!known.has(key)) known.set(key, compute(a, b));
    return known.get(key)!;
  };
}

function upward(random: () => number): Vec3 {
  const [x, y, z] = randomDirection(random);
  return rounded(normalize([x, y, Math.max(Math.abs(z), 1e-3)]));
}

function rounded([x, y, z]: Vec3): Vec3 {
  return [Math.fround(x), Math.fround(y), Math.fround(z)];
}
