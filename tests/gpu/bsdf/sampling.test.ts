import { afterAll, describe, expect, test } from "vitest";
import type { Material, Vec3 } from "../../../src/scene/schema";
import { chiSquareTest, sidakLevel } from "../../support/chiSquare";
import { evaluateBsdf, sampleBsdf } from "../../support/deviceBsdf";
import { BIN_COUNT, binDirections, binOf, normalize, type Polar } from "../../support/directionBins";
import { ggxDensity } from "../../support/microfacets";
import { runProbe } from "../../support/probe";
import { createRandom } from "../../support/random";
import { recordStability } from "../../support/stabilityRows";

// Every sampler draws what its density says: pbrt's recipe, with one significance for all configurations together.
const SIGNIFICANCE = 0.01;
const SAMPLES = 65536;

type Configuration = {
  readonly name: string;
  readonly polar: Polar;
  /** Directions for these random numbers, four floats each; a fourth is not 0 where there is one. */
  readonly sample: (u: readonly Vec3[]) => Promise<Float32Array>;
  readonly density: (directions: readonly Vec3[]) => Promise<ArrayLike<number>>;
};

const N: Vec3 = [0, 0, 1];
const HEMISPHERE: Polar = { axis: N, scale: 1, most: 1 };

const CONFIGURATIONS: readonly Configuration[] = [
  ...[
    { name: "cosineHemisphere", polar: HEMISPHERE, density: (z: number) => z / Math.PI },
    { name: "uniformHemisphere", polar: HEMISPHERE, density: () => 0.5 / Math.PI },
    { name: "uniformSphere", polar: { ...HEMISPHERE, most: 2 }, density: () => 0.25 / Math.PI },
  ].map(({ name, polar, density }) => ({
    name,
    polar,
    sample: (u: readonly Vec3[]) => probe(`import package::directions::${name};`, u, `vec4f(${name}(x.xy), 1.0)`),
    density: async (directions: readonly Vec3[]) => directions.map(([, , z]) => density(z)),
  })),
  ...[1e-3, 0.01, 0.1, 0.3, 1].flatMap((alpha) =>
    [0, 30, 60, 85, 89.9].map((degrees) => ggxConfiguration(alpha, degrees)),
  ),
  ...(
    [
      { metallic: 1, roughness: 0.4 },
      { metallic: 1, roughness: 0.6, multiscatter: true },
      { roughness: 0.1 },
      { roughness: 0.5 },
      { roughness: 1 },
      { roughness: 0.4, masking: "schlick-beckmann" },
      { metallic: 0.5, roughness: 0.3, baseColor: [0.9, 0.5, 0.1], ior: 1 },
    ] satisfies Material[]
  ).flatMap((material) => [1, 60, 85].map((degrees) => bsdfConfiguration(material, degrees))),
];

const level = sidakLevel(SIGNIFICANCE, CONFIGURATIONS.length);
const pValues: number[] = [];

describe(`${SAMPLES} samples follow their density (χ², p > ${level.toExponential(1)}), seed 1`, () => {
  test.each(CONFIGURATIONS)("$name", async ({ polar, sample, density }) => {
    const random = createRandom(1);
    const u = Array.from({ length: SAMPLES }, (): Vec3 => [unit(random), unit(random), unit(random)]);
    const drawn = await sample(u);
    const observed = new Float64Array(BIN_COUNT + 1);
    for (let i = 0; i < SAMPLES; i++) {
      const direction: Vec3 = [drawn[4 * i]!, drawn[4 * i + 1]!, drawn[4 * i + 2]!];
      observed[drawn[4 * i + 3] === 0 ? BIN_COUNT : (binOf(polar, direction) ?? BIN_COUNT)]!++;
    }

    const nodes = binDirections(polar);
    const densities = await density(nodes.map(({ direction }) => direction));
    const expected = new Float64Array(BIN_COUNT + 1);
    for (const [i, { bin, solidAngle }] of nodes.entries()) expected[bin]! += SAMPLES * densities[i]! * solidAngle;
    // What is left are samples that fail: directions below the horizon.
    const total = expected.reduce((sum, count) => sum + count, 0) / SAMPLES;
    expect(total).toBeLessThan(1 + QUADRATURE);
    expected[BIN_COUNT] = Math.max(SAMPLES * (1 - total), 0);
    if (observed[BIN_COUNT] === 0) expect(total).toBeGreaterThan(1 - QUADRATURE);

    const p = chiSquareTest(observed, expected);
    pValues.push(p);
    expect(p).toBeGreaterThan(level);
  });
});

// The midpoint rule on 384 · 144 directions, for a density of the width of the finest bins.
const QUADRATURE = 1e-3;

afterAll(() => {
  const worst = Math.min(...pValues);
  console.log(
    `χ²: ${pValues.length} configurations, least p-value ${worst.toFixed(4)}, level ${level.toExponential(2)}`,
  );
  recordStability("sampling", [
    {
      case: "samples of every direction sampler and BSDF against their density, α from 1e-3 to 1, to grazing",
      asserted: `χ², p ≥ ${level.toExponential(1)} (worst is the least p-value)`,
      inputs: pValues.length * SAMPLES,
      worst,
    },
  ]);
});

// Normals visible from wo, drawn by the density of wi after reflection: an integral over the normals with
// tan²θ = α²·v/(1 − v), which takes the peak away, and v = 1 − w², which takes the tail's root: in w and φ the integrand is
// smooth but for the kink where normals turn away from wo, and the midpoint rule on 256² is good to 1e-4.
test.each([1e-6, 1e-4, 1e-3, 0.01, 0.1, 0.5, 1])(
  "the density of visible normals integrates to 1 for α = %d",
  async (alpha) => {
    for (const degrees of [0, 45, 80, 89]) {
      const wo = directionAt(degrees);
      const steps = 256;
      const wOf = (i: number) => (Math.floor(i / steps) + 0.5) / steps;
      const normals = Array.from({ length: steps ** 2 }, (_, i): Vec3 => {
        const v = 1 - wOf(i) ** 2;
        const phi = (Math.PI * ((i % steps) + 0.5)) / steps;
        const tangent = alpha * Math.sqrt(v / (1 - v));
        return normalize([tangent * Math.cos(phi), tangent * Math.sin(phi), 1]);
      });
      const densities = await probe(
        `import package::lobes::ggx::ggxPdf; const alpha = ${alpha.toExponential()};`,
        normals,
        `vec4f(ggxPdf(${wo[2].toExponential()}, x.xyz, alpha))`,
      );
      let sum = 0;
      for (const [i, m] of normals.entries()) {
        const cosine = m[0] * wo[0] + m[2] * wo[2];
        // dwi = 4·(wo·m) dm, and dm = 2w dw dφ / (2π·D·cosθ), φ on both sides.
        if (cosine > 0) sum += (densities[4 * i]! * 4 * cosine * 2 * wOf(i)) / (ggxDensity(m, alpha) * m[2]);
      }
      expect(Math.abs(sum / steps ** 2 - 1)).toBeLessThan(1e-3);
    }
  },
);

// Microfacets are binned by their normals m, whose density has no peaks but around n. dwi = 4·(wo·m) dm.
function ggxConfiguration(alpha: number, degrees: number): Configuration {
  const wo = directionAt(degrees);
  const constants = `const wo = vec3f(${wo.map((value) => value.toExponential()).join(", ")}); const alpha = ${alpha.toExponential()};`;
  return {
    name: `ggxSample, α = ${alpha}, ${degrees}°`,
    polar: normals(alpha),
    sample: (u) =>
      probe(`import package::lobes::ggx::ggxSample; ${constants}`, u, "vec4f(ggxSample(wo, alpha, x.xy), 1.0)"),
    density: async (ms) => {
      const densities = await probe(
        `import package::lobes::ggx::ggxPdf; ${constants}`,
        ms,
        "vec4f(ggxPdf(wo.z, x.xyz, alpha))",
      );
      return ms.map((m, i) => densities[4 * i]! * 4 * Math.max(dot(wo, m), 0));
    },
  };
}

function bsdfConfiguration(material: Material, degrees: number): Configuration {
  const wo = directionAt(degrees);
  return {
    name: `bsdfSample, ${describeMaterial(material)}, ${degrees}°`,
    polar: normals((material.roughness ?? 1) ** 2),
    sample: async (u) => {
      const drawn = await sampleBsdf(
        [material],
        u.map((x) => ({ wo, x })),
      );
      const rows = u.map((_, i) => {
        const [x, y, z, pdf] = drawn.subarray(8 * i, 8 * i + 4) as unknown as [number, number, number, number];
        return [wo[0] + x, wo[1] + y, wo[2] + z, pdf]; // a density of 0 stops the path
      });
      return new Float32Array(rows.flat());
    },
    density: async (ms) => {
      const cosines = ms.map((m) => dot(wo, m));
      const values = await evaluateBsdf(
        [material],
        ms.map((m, i) => ({ wo, x: [0, 1, 2].map((k) => 2 * cosines[i]! * m[k]! - wo[k]!) as unknown as Vec3 })),
      );
      return cosines.map((cosine, i) => (cosine > 0 ? 4 * cosine * values[4 * i + 3]! : 0));
    },
  };
}

function normals(alpha: number): Polar {
  return { axis: N, scale: alpha ** 2 / 2, most: 1 };
}

function describeMaterial({ baseColor: _, ...material }: Material): string {
  return Object.entries(material)
    .map(([key, value]) => `${key} ${value}`)
    .join(", ");
}

/** Evaluates a vec4f expression of `x` for every input. */
async function probe(imports: string, inputs: readonly Vec3[], expression: string) {
  const words = await runProbe({
    wgsl: `${imports}
      fn probe(i: u32) {
        let x = bitcast<vec4f>(inputs[i]);
        outputs[i] = bitcast<vec4u>(${expression});
      }`,
    conditions: {},
    count: inputs.length,
    inputs: Float32Array.from({ length: 4 * inputs.length }, (_, i) => inputs[i >> 2]![i & 3] ?? 0),
    outputRows: inputs.length,
  });
  return new Float32Array(words.buffer);
}

/** Unit, at an angle to the normal and aslant to the axes, rounded to f32. */
function directionAt(degrees: number): Vec3 {
  const angle = (degrees * Math.PI) / 180;
  return [Math.fround(Math.sin(angle)), 0, Math.fround(Math.cos(angle))];
}

/** As the shader's sampler gives them: multiples of 2⁻²⁴ below 1. */
function unit(random: () => number): number {
  return Math.floor(random() * 2 ** 24) / 2 ** 24;
}

function dot(a: Vec3, b: Vec3): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
