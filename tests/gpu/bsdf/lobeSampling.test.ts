import { afterAll, describe, expect, test } from "vitest";
import type { Material, Vec3 } from "../../../src/scene/schema";
import { CHART_BINS, type Chart, evenChart, normalsChart } from "../../support/charts";
import { chiSquareTest, sidakLevel } from "../../support/chiSquare";
import { type BsdfInput, evaluateBsdf, sampleBsdf } from "../../support/deviceBsdf";
import { etaOf } from "../../support/interfaces";
import { alphasOf } from "../../support/khrMaterials";
import { createRandom } from "../../support/random";
import { recordStability } from "../../support/stabilityRows";

// Samples of the lobes of glTF's extensions, alone and together, follow their density over all directions.
const SIGNIFICANCE = 0.01;
const SAMPLES = 8192;
/** Nodes per bin and dimension. */
const STEPS = 4;

const ROUGHNESS = [0.05, 0.2, 0.4, 0.7, 1];
const ANGLES = [1, 30, 60, 80, 89];
const GLASS: Material = { transmission: 1, thickness: 1 };
const WALL: Material = { transmission: 1 };
const GROOVES = 0.7;

type Case = {
  readonly name: string;
  readonly base: Material;
  readonly roughness?: readonly number[];
  readonly angles?: readonly number[];
  /** The field that takes the roughnesses. */
  readonly field?: "roughness" | "clearcoatRoughness" | "sheenRoughness";
  readonly front?: boolean;
  /** How the lobe below the surface is narrow, where it is. */
  readonly narrow?: "pass" | "refract";
};

const CASES: readonly Case[] = [
  { name: "rough refraction into glass", base: GLASS, narrow: "refract" },
  { name: "rough refraction out of glass", base: GLASS, front: false, narrow: "refract" },
  {
    name: "rough refraction out of diamond",
    base: { ...GLASS, ior: 2.4 },
    front: false,
    narrow: "refract",
    angles: [1, 30, 80],
  },
  { name: "a rough wall", base: WALL, narrow: "pass" },
  { name: "an anisotropic metal", base: { metallic: 1, anisotropy: GROOVES } },
  { name: "anisotropic glass", base: { ...GLASS, anisotropy: GROOVES }, narrow: "refract" },
  { name: "anisotropic glass from inside", base: { ...GLASS, anisotropy: GROOVES }, front: false, narrow: "refract" },
  { name: "an anisotropic wall", base: { ...WALL, anisotropy: GROOVES }, narrow: "pass", angles: [1, 60, 89] },
  { name: "a rough coat on metal", base: { metallic: 1, roughness: 0.5, clearcoat: 1 }, field: "clearcoatRoughness" },
  { name: "a rough coat on a mirror", base: { metallic: 1, roughness: 0, clearcoat: 1 }, field: "clearcoatRoughness" },
  { name: "fibres on Lambert", base: { ior: 1, sheenColor: [0.8, 0.4, 0.4] }, field: "sheenRoughness" },
  {
    name: "fibres on a mirror",
    base: { metallic: 1, roughness: 0, sheenColor: [0.8, 0.4, 0.4] },
    field: "sheenRoughness",
  },
  { name: "diffuse transmission", base: { diffuseTransmission: 0.6, diffuseTransmissionColor: [1, 0.5, 0.2] } },
  {
    name: "a smooth solid under a rough coat",
    base: { ...GLASS, roughness: 0, clearcoat: 0.5 },
    field: "clearcoatRoughness",
  },
  {
    name: "everything at once",
    base: {
      ...{ ...GLASS, transmission: 0.5, diffuseTransmission: 0.5, metallic: 0.2, anisotropy: 0.5, iridescence: 0.5 },
      ...{ sheenColor: [0.5, 0.5, 0.5], sheenRoughness: 0.5, clearcoat: 0.7, clearcoatRoughness: 0.4, specular: 0.8 },
    },
    roughness: [0.7, 1],
  },
];

const level = sidakLevel(
  SIGNIFICANCE,
  CASES.reduce((sum, { roughness = ROUGHNESS, angles = ANGLES }) => sum + roughness.length * angles.length, 0),
);
const pValues: number[] = [];
let worstShare = 0;

describe(`${SAMPLES} samples follow their density (χ², p > ${level.toExponential(1)}), seed 21:`, () => {
  test.each(CASES)("$name", async ({ base, roughness = ROUGHNESS, angles = ANGLES, field = "roughness", ...rest }) => {
    const { front = true, narrow } = rest;
    const materials = roughness.map((value): Material => ({ ...base, [field]: value }));
    const configurations = materials.flatMap((material, i) =>
      angles.map((degrees) => {
        const wo = directionAt(degrees);
        return { i, degrees, wo, charts: chartsOf(material, wo, front, field, narrow) };
      }),
    );
    const random = createRandom(21);
    const samples = configurations.flatMap(({ i, wo }) =>
      Array.from({ length: SAMPLES }, (): BsdfInput => {
        return { material: i, wo, x: [unit(random), unit(random), unit(random)], front };
      }),
    );
    const nodes = configurations.flatMap(({ i, wo, charts }) =>
      charts.flatMap((chart) =>
        chart.nodes.map(({ direction }): BsdfInput => ({ material: i, wo, x: direction, front })),
      ),
    );
    const drawn = await sampleBsdf(materials, samples);
    const densities = await evaluateBsdf(materials, nodes);
    let [sample, node] = [0, 0];
    for (const { i, degrees, charts } of configurations) {
      const observed = new Float64Array(charts.length * CHART_BINS);
      let failures = 0;
      for (const end = sample + SAMPLES; sample < end; sample++) {
        const [x, y, z, pdf, weight] = drawn.subarray(8 * sample, 8 * sample + 5) as unknown as number[];
        // One that a lobe has drawn for the other side has no weight.
        const bin = pdf! > 0 && (charts.length === 1 || weight! > 0) ? binIn(charts, [x!, y!, z!]) : undefined;
        if (bin === undefined) failures++;
        else observed[bin]!++;
      }
      const expected = new Float64Array(charts.length * CHART_BINS);
      for (const [c, chart] of charts.entries()) {
        for (const { bin, solidAngle } of chart.nodes) {
          expected[c * CHART_BINS + bin]! += SAMPLES * solidAngle * densities[4 * node++ + 3]!;
        }
      }
      const what = `${field} ${materials[i]![field]}, ${degrees}°`;
      // What is left are samples without a direction or a density.
      const share = 1 - expected.reduce((sum, count) => sum + count, 0) / SAMPLES;
      const noise = 4 * Math.sqrt(Math.max(share * (1 - share), 1 / SAMPLES) / SAMPLES);
      worstShare = Math.max(worstShare, Math.abs(failures / SAMPLES - share));
      const p = chiSquareTest(observed, expected, SLIVER);
      pValues.push(p);
      expect.soft(Math.abs(failures / SAMPLES - share), what).toBeLessThan(QUADRATURE + noise);
      expect.soft(p, what).toBeGreaterThan(level);
    }
  });
});

// The midpoint rule on 384 · 16 directions of each side, for a density of the width of the finest bins, or one that is cut.
const QUADRATURE = 4e-3;
/** Of the samples: in bins that all nodes miss because a horizon cuts them. */
const SLIVER = 5e-4;

afterAll(() => {
  const worst = Math.min(...pValues);
  console.log(
    `χ²: ${pValues.length} configurations, least p-value ${worst.toFixed(4)}, level ${level.toExponential(2)}; failures off by ${worstShare.toFixed(4)} at most`,
  );
  recordStability("lobe-sampling", [
    {
      case: "samples of refraction, walls, grooves, coats, fibres and diffuse transmission against their density",
      asserted: `χ², p ≥ ${level.toExponential(1)} (worst is the least p-value)`,
      inputs: pValues.length * SAMPLES,
      worst,
    },
  ]);
});

function chartsOf(material: Material, wo: Vec3, front: boolean, field: Case["field"], narrow: Case["narrow"]): Chart[] {
  const eta = etaOf(material, front) ?? 1;
  const coat = material.clearcoatRoughness! ** 2;
  const alphas = field === "clearcoatRoughness" ? ([coat, coat] as const) : alphasOf(material);
  const above = field === "sheenRoughness" ? evenChart(1, STEPS) : normalsChart(wo, alphas, "reflect", STEPS);
  const hasBelow = material.transmission || material.diffuseTransmission;
  if (!hasBelow) return [above];
  if (!narrow) return [above, evenChart(-1, STEPS)];
  return [above, normalsChart(wo, alphas, narrow === "pass" ? "pass" : { eta }, STEPS)];
}

function binIn(charts: readonly Chart[], direction: Vec3): number | undefined {
  for (const [c, chart] of charts.entries()) {
    const bin = chart.binOf(direction);
    if (bin !== undefined) return c * CHART_BINS + bin;
  }
  return undefined;
}

/** Unit, at an angle to the normal and aslant to the grooves, rounded to f32. */
function directionAt(degrees: number): Vec3 {
  const angle = (degrees * Math.PI) / 180;
  const sine = Math.sin(angle);
  return [Math.fround(sine * Math.cos(0.6)), Math.fround(sine * Math.sin(0.6)), Math.fround(Math.cos(angle))];
}

/** As the shader's sampler gives them: multiples of 2⁻²⁴ below 1. */
function unit(random: () => number): number {
  return Math.floor(random() * 2 ** 24) / 2 ** 24;
}
