import { describe, expect, test } from "vitest";
import type { Material, Vec3 } from "../../../src/scene/schema";
import { type BsdfInput, sampleBsdf } from "../../support/deviceBsdf";
import { dielectricReflectance, interfaceOf, refracted } from "../../support/interfaces";
import { coatReflectance } from "../../support/khrMaterials";

// Surfaces without microfacets send light in one or two directions: those of Snell's law, with the shares of Fresnel's equations.

const ULP = 2 ** -23;
// Both directions, whatever their shares: the lobe's choice at its ends and between them.
const CHOICES = Array.from({ length: 64 }, (_, i) => i / 64).concat(2 ** -24, 1 - 2 ** -24);

type Outcome = { readonly wi: Vec3; readonly weight: Vec3; readonly share: number };

/** What a smooth surface does with a direction: every outcome with the share of the choices that it takes. */
async function outcomesOf(material: Material, views: readonly { wo: Vec3; front: boolean }[]): Promise<Outcome[][]> {
  const inputs = views.flatMap(({ wo, front }) =>
    CHOICES.map((choice): BsdfInput => ({ wo, front, x: [0.3, 0.6, choice] })),
  );
  const drawn = await sampleBsdf([material], inputs);
  return views.map((_, v) => {
    const found = new Map<string, Outcome>();
    for (let i = v * CHOICES.length; i < (v + 1) * CHOICES.length; i++) {
      const [x, y, z, pdf, r, g, b] = drawn.subarray(8 * i, 8 * i + 7) as unknown as number[];
      expect(pdf).toBe(0);
      const key = [x, y, z, r, g, b].join();
      const share = (found.get(key)?.share ?? 0) + 1 / CHOICES.length;
      found.set(key, { wi: [x!, y!, z!], weight: [r!, g!, b!], share });
    }
    return [...found.values()];
  });
}

const IORS = [1.5, 1.33, 2.4, 1.001, 1.01, 0.7, 3];
const DEGREES = [0, 1, 20, 40, 60, 80, 89, 89.9, 89.999];

describe.each(IORS)("glass of ior %d", (ior) => {
  const tint = [1, 0.5, 0.25] as const;
  const glass: Material = { ior, roughness: 0, transmission: 1, thickness: 1, baseColor: tint };
  const views = [true, false].flatMap((front) => DEGREES.map((degrees) => ({ wo: directionAt(degrees), front })));

  test("reflects and refracts by Snell and Fresnel, each with a weight that its probability makes up for", async () => {
    const seen = await outcomesOf(glass, views);
    for (const [v, { wo, front }] of views.entries()) {
      const eta = front ? ior : 1 / ior;
      const F = dielectricReflectance(wo[2], eta);
      const bent = refracted(wo, N, eta);
      for (const { wi, weight, share } of seen[v]!) {
        if (wi[2] > 0) {
          expectNear(wi, [-wo[0], -wo[1], wo[2]], 2 * ULP);
        } else {
          // Snell's law makes 1/cos of an error of the sine; the square of the cosine is good to a few ULP.
          const steepness = 1 / Math.max(Math.abs(bent![2]), 1e-3);
          expectNear(wi, bent!, 8 * ULP * Math.max(1, 1 / eta) * steepness);
          expect(Math.hypot(...wi)).toBeCloseTo(1, 6);
        }
        if (weight[0] === 0) continue;
        // The weight's luminance times the probability is the luminance of the share.
        const [part, color] = wi[2] > 0 ? [F, [1, 1, 1] as const] : [1 - F, tint];
        const probability = luminance([color[0] * part, color[1] * part, color[2] * part]) / totalOf(F, tint);
        expect(Math.abs(share - probability)).toBeLessThan(2 / 64 + 1e-6);
        for (const c of [0, 1, 2]) {
          // F is good to a few ULP over cos and over its own cancellation near ior 1, the probability of what is left to an ULP of 1.
          const allowed = 32 * ULP * (1 / Math.abs(ior - 1) + 1 / wo[2]) + (2 * ULP) / probability;
          expect(Math.abs((weight[c]! * probability) / (color[c]! * part) - 1)).toBeLessThan(allowed);
        }
      }
      // Nothing is lost: what is not refracted is reflected.
      const sum = seen[v]!.reduce((total, { weight, share }) => total + luminance(weight) * share, 0);
      expect(Math.abs(sum - totalOf(F, tint))).toBeLessThan(3 / 64);
      if (!bent) expect(seen[v]!.map(({ wi }) => wi[2] > 0)).toEqual([true]);
    }
  });
});

describe("near the critical angle, from inside", () => {
  test.each([1.5, 1.33, 2.4, 1.01])(
    "glass of ior %d reflects all light beyond it and refracts before it",
    async (ior) => {
      const glass: Material = { ior, roughness: 0, transmission: 1, thickness: 1 };
      const critical = Math.asin(1 / ior);
      // f32 knows sin² − 1/eta² to a few ULP, which the slope 2·sin·cos makes an angle of.
      const unsure = (8 * ULP) / (2 * Math.sin(critical) * Math.cos(critical)) / Math.min(ior - 1, 1);
      const offsets = [1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3].flatMap((offset) => [-offset, offset]);
      const views = offsets.map((offset) => ({ wo: directionAt(((critical + offset) * 180) / Math.PI), front: false }));
      const seen = await outcomesOf(glass, views);
      for (const [v, offset] of offsets.entries()) {
        const outcomes = seen[v]!;
        const isTotal = outcomes.every(({ wi, weight }) => wi[2] > 0 || weight[0] === 0);
        if (Math.abs(offset) > unsure) {
          const F = dielectricReflectance(Math.cos(critical + offset), 1 / ior);
          if (offset > 0) expect(isTotal).toBe(true);
          if (offset > 0) expect(outcomes).toHaveLength(1);
          if (offset < 0 && 1 - F > 0.05) expect(isTotal).toBe(false);
        }
        for (const { wi, weight, share } of outcomes) {
          expect([...wi, ...weight].every(Number.isFinite)).toBe(true);
          if (share > 0.1) expect(weight[0]).toBeCloseTo(1, 2); // F and 1 − F are drawn in proportion to themselves
        }
      }
    },
  );
});

test.each([true, false])("glass of ior 1 lets light pass straight, all of it; from the front: %s", async (front) => {
  const views = DEGREES.map((degrees) => ({ wo: directionAt(degrees), front }));
  for (const base of [{}, { roughness: 0.5 }, { roughness: 0 }] satisfies Material[]) {
    const seen = await outcomesOf({ ...base, ior: 1, transmission: 1, thickness: 1 }, views);
    for (const [v, { wo }] of views.entries()) {
      expect(seen[v]).toHaveLength(1);
      expectNear(seen[v]![0]!.wi, [-wo[0], -wo[1], -wo[2]], 4 * ULP);
      expect(seen[v]![0]!.weight).toEqual([1, 1, 1]);
    }
  }
});

describe("a mirror coat", () => {
  const bases: Readonly<Record<string, Material>> = {
    "a mirror": { metallic: 1, roughness: 0, baseColor: [1, 0.5, 0.25] },
    "smooth glass": { roughness: 0, transmission: 1, thickness: 1 },
  };
  test.each(Object.keys(bases))("on %s reflects its share, and dims what is below it both ways", async (name) => {
    const material: Material = { ...bases[name]!, clearcoat: 0.8 };
    const views = DEGREES.map((degrees) => ({ wo: directionAt(degrees), front: true }));
    const seen = await outcomesOf(material, views);
    for (const [v, { wo }] of views.entries()) {
      const Fc = coatReflectance(material, wo[2]);
      const { F, through } = interfaceOf(material, wo[2]);
      const bent = refracted(wo, N, 1.5)!;
      // Coat and interface reflect in one direction; each is an outcome.
      const above = Fc + (1 - Fc) ** 2 * F[0];
      const under = name === "smooth glass" ? through * (1 - Fc) * (1 - coatReflectance(material, bent[2])) : 0;
      const sumOf = (side: number) =>
        seen[v]!.reduce((sum, { wi, weight, share }) => sum + (side * wi[2] > 0 ? weight[0] * share : 0), 0);
      // Three shares, each counted to 1/64.
      const most = Math.max(...seen[v]!.map(({ weight }) => weight[0]));
      expect(Math.abs(sumOf(1) - above)).toBeLessThan((most * 3) / 64);
      expect(Math.abs(sumOf(-1) - under)).toBeLessThan((most * 3) / 64);
      for (const { weight } of seen[v]!) expect(weight[0]).toBeLessThanOrEqual(1.5);
    }
  });
});

const N: Vec3 = [0, 0, 1];

function luminance([r, g, b]: Vec3): number {
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

function totalOf(F: number, tint: Vec3): number {
  return F + (1 - F) * luminance(tint);
}

function expectNear(actual: Vec3, expected: Vec3, tolerance: number): void {
  const distance = Math.hypot(...actual.map((component, k) => component - expected[k]!));
  expect(distance, `${actual} against ${expected}`).toBeLessThan(tolerance);
}

/** Unit to f32, at an angle to the normal. */
function directionAt(degrees: number): Vec3 {
  const angle = (degrees * Math.PI) / 180;
  const sine = Math.sin(angle);
  return [Math.fround(sine * Math.cos(0.6)), Math.fround(sine * Math.sin(0.6)), Math.fround(Math.cos(angle))];
}
