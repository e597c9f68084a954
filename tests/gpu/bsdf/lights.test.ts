import { afterAll, describe, expect, test } from "vitest";
import type { Vec3 } from "../../../src/scene/schema";
import { chiSquareTest, sidakLevel } from "../../support/chiSquare";
import { normalize } from "../../support/directionBins";
import { runProbe } from "../../support/probe";
import { createRandom, randomDirection } from "../../support/random";
import { recordStability, type StabilityRow } from "../../support/stabilityRows";

// Points on lights are uniform in what they claim to be uniform in, and their density is one over its measure.
const SAMPLES = 65536;
const BINS = 16;

/** One light sample: direction, distance, 1/density and density. */
type Sample = { readonly wi: Vec3; readonly distance: number; readonly solidAngle: number; readonly pdf: number };

const SPHERES = [
  { what: "touching", distance: 1 + 2 ** -20, radius: 1 },
  { what: "near", distance: 1.1, radius: 1 },
  { what: "at some distance", distance: 4, radius: 1 },
  { what: "far", distance: 1e4, radius: 1 },
  { what: "tiny", distance: 2, radius: 1e-4 },
];

// Degrees.
const SUNS = [0.01, 0.53, 30, 179];

type Flat = {
  readonly what: string;
  readonly kind: "quad" | "triangle";
  readonly edges: readonly [Vec3, Vec3];
  readonly corner: Vec3;
};

const FLATS: readonly Flat[] = (["quad", "triangle"] as const).flatMap((kind) => [
  {
    what: "near",
    kind,
    corner: [-1, -1, 1],
    edges: [
      [0.5, 2, 0],
      [2, 0, 0.3],
    ],
  },
  {
    what: "far",
    kind,
    corner: [300, 200, 900],
    edges: [
      [0, 2, 0],
      [2, 0, 0],
    ],
  },
  {
    what: "tiny",
    kind,
    corner: [0.1, 0.2, 1],
    edges: [
      [0, 1e-3, 0],
      [1e-3, 0, 0],
    ],
  },
]);

const level = sidakLevel(0.01, SPHERES.length + FLATS.length + SUNS.length + 1);
const rows: StabilityRow[] = [];
let worst = 1;

afterAll(() => {
  console.log(`lights: least p-value ${worst.toFixed(4)}, level ${level.toExponential(2)}`);
  rows.unshift({
    case: "points on sphere, quad and triangle lights, touching to 1e4 radii away, and in suns of 0.01 to 179°",
    asserted: `χ², p ≥ ${level.toExponential(1)} (worst is the least p-value)`,
    inputs: (SPHERES.length + FLATS.length + SUNS.length + 1) * SAMPLES,
    worst,
  });
  recordStability("light-sampling", rows);
});

describe(`${SAMPLES} points, χ² with p > ${level.toExponential(1)}, seed 1,`, () => {
  test.each(SPHERES)("are uniform in the cone of a sphere light, $what", async ({ distance, radius }) => {
    const center = normalize([1, 2, -2]).map((component) => Math.fround(distance * component)) as unknown as Vec3;
    const samples = await sample(
      `sampleSphere(vec3f(0.0), ${vec3(center)}, ${radius.toExponential()}, u)`,
      randomPairs(1),
    );
    const d = Math.hypot(...center);
    const axis = normalize(center);
    const sin2 = (radius / d) ** 2;
    const most = sin2 / (1 + Math.sqrt(1 - sin2));
    const [t, b] = [normalize(cross(axis, [1, 0, 0])), normalize(cross(axis, cross(axis, [1, 0, 0])))];
    expectUniform(
      samples.map(({ wi }) => {
        // 1 − cos = |wi − axis|²/2; the rim may be off by the rounding of a direction.
        const away = Math.hypot(...subtract(wi, axis)) ** 2 / 2;
        return [Math.min(away / most, 1 - 1e-9), Math.atan2(dot(wi, b), dot(wi, t)) / (2 * Math.PI) + 0.5];
      }),
    );
    const densities = samples.map(({ pdf }) => Math.abs(pdf * 2 * Math.PI * most - 1));
    // sin² is good to 4·2⁻²³ and near 1 its cosine to that over the cosine, 2⁻²³·2/√(2·2⁻²⁰) = 1.7e-4 at 2⁻²⁰ radii.
    expect(Math.max(...densities)).toBeLessThan(distance < 1.01 ? 1e-2 : 1e-5);
    // The points lie on the sphere. Their distance is good to 2⁻²¹ of the centre's.
    const off = samples.map((s) => Math.abs(Math.hypot(...subtract(scale(s.wi, s.distance), center)) - radius) / d);
    expect(Math.max(...off)).toBeLessThan(2 ** -20);
  });

  test.each(FLATS)("are uniform on the area of a $kind, $what", async ({ kind, corner, edges: [edge1, edge2] }) => {
    const n = cross(edge1, edge2);
    const area = Math.hypot(...n) / (kind === "quad" ? 1 : 2);
    const samples = await sample(
      `samplePlanar(vec3f(0.0), Light(${vec3(corner)}, ${area.toExponential()}, ${vec3(edge1)}, 0u, ${vec3(edge2)}, 0u, vec3f(1.0), ${vec3(scale(n, 1 / Math.hypot(...n)))}), ${kind === "quad" ? "u" : "squareToTriangle(u)"})`,
      randomPairs(1),
    );
    const coordinates = samples.map(({ wi, distance }): [number, number] => {
      const q = subtract(scale(wi, distance), corner);
      return [dot(cross(q, edge2), n) / dot(n, n), dot(cross(edge1, q), n) / dot(n, n)];
    });
    // A triangle, unfolded: (u, v) → (u + v, v / (u + v)) makes a uniform triangle into a square of density 2x.
    const square = ([u, v]: [number, number]): [number, number] => [(u + v) ** 2, v / (u + v)];
    expectUniform(kind === "quad" ? coordinates : coordinates.map(square));
    const errors = samples.map(({ wi, distance, pdf }) => {
      const cosine = Math.abs(dot(wi, n)) / Math.hypot(...n);
      return Math.abs((pdf * area * cosine) / distance ** 2 - 1);
    });
    expect(Math.max(...errors)).toBeLessThan(1e-5);
  });

  test.each(SUNS)("are uniform in the disk of a sun of %d°", async (diameter) => {
    const axis = normalize([1, 2, -2]);
    const [t, b] = [normalize(cross(axis, [1, 0, 0])), normalize(cross(axis, cross(axis, [1, 0, 0])))];
    const most = 2 * Math.sin((diameter * Math.PI) / 720) ** 2;
    const sun = `Light(vec3f(0.0), ${most.toExponential()}, ${vec3(t)}, 0u, ${vec3(b)}, 0u, vec3f(1.0), ${vec3(axis)})`;
    const samples = await sample(`sampleSky(${sun}, u)`, randomPairs(4));
    // As of a sphere light: 1 − cos = |wi − axis|²/2.
    const shareOf = (wi: Vec3) => Math.hypot(...subtract(wi, axis)) ** 2 / 2 / most;
    expectUniform(
      samples.map(({ wi }) => {
        return [Math.min(shareOf(wi), 1 - 1e-9), Math.atan2(dot(wi, b), dot(wi, t)) / (2 * Math.PI) + 0.5];
      }),
    );
    expect(samples.filter(({ wi }) => !(Math.abs(Math.hypot(...wi) - 1) < 2 ** -22))).toEqual([]);
    // Density is one over the solid angle, by sampling and for a ray that finds the disk: a rim of 2⁻²² rad may count to either side.
    const [asked] = await sample(`sampleSky(${sun}, u)`, [[0.5, 0.5]]);
    expect(Math.abs(asked!.pdf * 2 * Math.PI * most - 1)).toBeLessThan(1e-6);
    expect(Math.abs(asked!.solidAngle * asked!.pdf - 1)).toBeLessThan(1e-6);
    const found = await probe(`vec4f(skyLightPdf(${sun}, sampleSky(${sun}, u).wi), 0.0, 0.0, 0.0)`, randomPairs(4));
    const rim = (2 * 2 ** -22) / Math.sqrt(2 * most);
    const wrong = samples.filter(
      ({ wi, pdf }, i) => shareOf(wi) < 1 - rim && !(Math.abs(found[8 * i]! / pdf - 1) < 1e-6),
    );
    expect(wrong).toEqual([]);
  });

  test("squareToTriangle keeps equal areas equal", async () => {
    const words = await probe("vec4f(squareToTriangle(u), 0.0, 0.0)", randomPairs(2));
    expectUniform(
      Array.from({ length: SAMPLES }, (_, i) => {
        const [u, v] = [words[8 * i]!, words[8 * i + 1]!];
        expect(Math.min(u, v, 1 - u - v)).toBeGreaterThanOrEqual(0);
        return [Math.max(u + v, 1e-30) ** 2, v / Math.max(u + v, 1e-30)];
      }),
    );
  });
});

test("a sphere light is sampled or left alone, and never not finite, for sin² from 1e-36 to infinity, seed 3", async () => {
  const random = createRandom(3);
  const distances = [0, 1e-30, 1e-12, 0.5, 1 - 2 ** -24, 1, 1 + 2 ** -23, 1 + 2 ** -20, 1.001, 10, 1e6, 1e12, 1e18];
  const extremes = [0, 2 ** -24, 0.5, 1 - 2 ** -24];
  let inputs = 0;
  for (const distance of distances) {
    const center = scale(randomDirection(random), distance);
    const u = extremes.flatMap((a) => extremes.map((b) => [a, b] as const));
    for (const { wi, distance: t, solidAngle, pdf } of await sample(
      `sampleSphere(vec3f(0.0), ${vec3(center)}, 1.0, u)`,
      u,
    )) {
      expect([...wi, t, solidAngle, pdf].every(Number.isFinite), `${distance}`).toBe(true);
      if (Math.hypot(...center.map(Math.fround)) > 1.00001) expect(pdf).toBeGreaterThan(0);
      if (distance < 1 - 1e-6) expect(solidAngle).toBe(0);
      inputs++;
    }
  }
  rows.push({
    case: "sphere light: sin² of its cone from 1e-36 to 1, the point inside it and on it",
    asserted: "0 values that are not finite",
    inputs,
    worst: 0,
  });
});

function expectUniform(points: readonly (readonly [number, number])[]): void {
  const observed = new Float64Array(BINS ** 2);
  const cell = (x: number) => Math.max(Math.min(Math.floor(x * BINS), BINS - 1), 0);
  for (const [x, y] of points) observed[cell(x) * BINS + cell(y)]!++;
  const p = chiSquareTest(observed, new Float64Array(BINS ** 2).fill(points.length / BINS ** 2));
  worst = Math.min(worst, p);
  expect(p).toBeGreaterThan(level);
}

function randomPairs(seed: number): [number, number][] {
  const random = createRandom(seed);
  const unit = () => Math.floor(random() * 2 ** 24) / 2 ** 24;
  return Array.from({ length: SAMPLES }, () => [unit(), unit()]);
}

/** Light samples from a WGSL expression of `u`. */
async function sample(expression: string, u: readonly (readonly [number, number])[]): Promise<Sample[]> {
  const floats = await probe(
    "vec4f(light.wi, light.distance)",
    u,
    `let light = ${expression};`,
    "vec4f(light.estimate.x, light.pdf, 0.0, 0.0)",
  );
  return u.map((_, i) => ({
    wi: [floats[8 * i]!, floats[8 * i + 1]!, floats[8 * i + 2]!],
    distance: floats[8 * i + 3]!,
    solidAngle: floats[8 * i + 4]!,
    pdf: floats[8 * i + 5]!,
  }));
}

async function probe(first: string, u: readonly (readonly [number, number])[], body = "", second = "vec4f()") {
  const words = await runProbe({
    wgsl: `
      import package::lights::area::{samplePlanar, squareToTriangle};
      import package::lights::directional::{sampleSky, skyLightPdf};
      import package::lights::light::Light;
      import package::lights::sphere::sampleSphere;
      fn probe(i: u32) {
        let u = bitcast<vec4f>(inputs[i]).xy;
        ${body}
        outputs[2u * i] = bitcast<vec4u>(${first});
        outputs[2u * i + 1u] = bitcast<vec4u>(${second});
      }`,
    conditions: { SKY_DISKS: true },
    modules: { scene: "" },
    count: u.length,
    inputs: new Float32Array(u.flatMap(([x, y]) => [x, y, 0, 0])),
    outputRows: 2 * u.length,
  });
  return new Float32Array(words.buffer);
}

function vec3(v: Vec3): string {
  return `vec3f(${v.map((component) => component.toExponential()).join(", ")})`;
}

function subtract(a: Vec3, b: Vec3): Vec3 {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

function scale(a: Vec3, k: number): Vec3 {
  return [k * a[0], k * a[1], k * a[2]];
}

function dot(a: Vec3, b: Vec3): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

function cross(a: Vec3, b: Vec3): Vec3 {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}
