import { afterAll, describe, expect, test } from "vitest";
import { normalize } from "../../support/directionBins";
import {
  ggxDensity,
  schlickBeckmannVisibility,
  schlickWeight,
  smithVisibility,
  visibleNormalPdf,
} from "../../support/microfacets";
import { runProbe } from "../../support/probe";
import { createRandom } from "../../support/random";
import { LONG } from "../../support/stability";
import { recordStability, type StabilityRow } from "../../support/stabilityRows";

// The shader's terms against doubles on the same f32 inputs. An f32 operation of WGSL is good to 2⁻²³ (+ − ×, either way of
// rounding), 2.5 times that (÷) and about 3 times that (√); a bound counts those on the way from inputs to result.
const ULP = 2 ** -23;
const INPUTS = 20000 * LONG;

type Numbers = readonly [number, number, number, number];

type Case = {
  readonly what: string;
  readonly hard: string;
  /** WGSL of `x: vec4f`. */
  readonly ours: string;
  readonly textbook: string;
  readonly exact: (x: Numbers) => number;
  readonly draw: (random: () => number) => Numbers;
  /** Allowed relative error in ULP. */
  readonly ulps: number;
};

const CASES: readonly Case[] = [
  {
    what: "length of (cos φ, sin φ)",
    hard: "all of the circle",
    ours: "length(circle(x.x))",
    textbook: "length(vec2f(cos(2.0 * PI * x.x), sin(2.0 * PI * x.x)))",
    exact: () => 1,
    draw: (random) => [random(), 0, 0, 0],
    ulps: 12, // s² + c² of the half angle to 4 ULP, four times that by the doubling, √ of half that, and 4
  },
  {
    what: "cos φ",
    hard: "all of the circle; absolute error over 2",
    ours: "circle(x.x).x + 2.0",
    textbook: "cos(2.0 * PI * x.x) + 2.0",
    exact: ([turns]) => Math.cos(2 * Math.PI * turns) + 2,
    draw: (random) => [random(), 0, 0, 0],
    ulps: 8, // 2s² − 1 is four times as far off as s, by up to 1.5 ULP; the sum is at least 1 and rounds to 2 ULP
  },
  {
    what: "GGX density D",
    hard: "α from 1e-6 to 1, normals within 10 α of n",
    ours: "ggxD(x.xyz, x.w)",
    // [Walter et al. 2007, glTF 2.0 B.3.2]
    textbook: "x.w * x.w / (PI * pow(x.z * x.z * (x.w * x.w - 1.0) + 1.0, 2.0))",
    exact: ([x, y, z, alpha]) => ggxDensity([x, y, z], alpha),
    draw: (random) => {
      const alpha = 10 ** (-6 * random());
      const tangent = alpha * 10 ** (4 * random() - 3);
      const phi = 2 * Math.PI * random();
      return [...normalize([tangent * Math.cos(phi), tangent * Math.sin(phi), 1]), alpha];
    },
    // α² 1; x², y², z·z·α² 3 at most, two sums 2; that squared 2·6 + 1; π 1; ÷ 2.5; the normal is not exactly unit: 4.
    ulps: 24,
  },
  {
    what: "Smith's visibility G2 / 4·cosO·cosI",
    hard: "cosines from 1 down to 1e-7, α from 1e-6 to 1",
    ours: "ggxVisibility(x.x, x.y, x.z)",
    // [Heitz 2014] eq. 72, 99
    textbook: "1.0 / ((1.0 + lambda(x.x, x.z) + lambda(x.y, x.z)) * 4.0 * x.x * x.y)",
    exact: ([cosO, cosI, alpha]) => smithVisibility(cosO, cosI, alpha),
    draw: (random) => [10 ** (-7 * random()), 10 ** (-7 * random()), 10 ** (-6 * random()), 0],
    // √(c² + α²·s²) 5 under the root, halved, and 3; times a cosine, summed 2; ÷ 2.5.
    ulps: 14,
  },
  {
    what: "Schlick–Beckmann visibility",
    hard: "cosines from 1 down to 1e-7, α from 1e-6 to 1",
    ours: "schlickBeckmannVisibility(x.x, x.y, x.z)",
    textbook: "(x.x / (x.x * (1.0 - k(x.z)) + k(x.z))) * (x.y / (x.y * (1.0 - k(x.z)) + k(x.z))) / (4.0 * x.x * x.y)",
    exact: ([cosO, cosI, alpha]) => schlickBeckmannVisibility(cosO, cosI, alpha),
    draw: (random) => [10 ** (-7 * random()), 10 ** (-7 * random()), 10 ** (-6 * random()), 0],
    // k 6 (√, ÷, ×), 1 − k: up to 5 times that where k nears 0.8; a product, a sum; twice; a product and ÷. k's error
    // counts fully only where cos is small, so that 1 − k's does not: 2·(6 + 2) + 4 and some room.
    ulps: 32,
  },
  {
    what: "Schlick's weight (1 − cos)⁵",
    hard: "cosines up to 1 + 2⁻²³, as rounding of unit vectors leaves them; absolute error",
    ours: "schlickWeight(x.x) + 1.0",
    textbook: "pow(1.0 - x.x, 5.0) + 1.0",
    exact: ([cosine]) => schlickWeight(Math.min(cosine, 1)) + 1,
    draw: (random) => {
      const cosine = random() < 0.5 ? random() : 1 - 10 ** (-7 * random());
      return [random() < 0.2 ? 1 + ULP : cosine, 0, 0, 0];
    },
    ulps: 6, // four products, a difference, the sum
  },
  {
    what: "density of visible normals",
    hard: "cosines from 1 down to 0, α from 1e-6 to 1",
    ours: "ggxPdf(x.x, vec3f(x.y, 0.0, sqrt(1.0 - x.y * x.y)), x.z)",
    textbook: "lambdaPdf(x.x, x.y, x.z)",
    exact: ([cosO, sinM, alpha]) =>
      cosO === 0
        ? ggxDensity([sinM, 0, Math.sqrt(1 - sinM ** 2)], alpha) / (2 * alpha)
        : visibleNormalPdf([Math.sqrt(1 - cosO ** 2), 0, cosO], [sinM, 0, Math.sqrt(1 - sinM ** 2)], alpha),
    draw: (random) => {
      const alpha = 10 ** (-6 * random());
      const cosO = random() < 0.1 ? 0 : 10 ** (-7 * random());
      return [cosO, Math.min(alpha * 10 ** (3 * random() - 2), 0.99), alpha, 0];
    },
    ulps: 24 + 8, // D; the slope 6, a sum 1, a product and ÷; the normal made on the device: 4 of D's 24 again
  },
  {
    what: "1 − cos of the cone of a sphere light",
    hard: "sin² from 1e-12 to 1",
    ours: "coneOneMinusCos(x.x)",
    textbook: "1.0 - sqrt(1.0 - x.x)",
    exact: ([sin2]) => sin2 / (1 + Math.sqrt(1 - sin2)),
    draw: (random) => [random() < 0.8 ? 10 ** (-12 * random()) : 1 - 10 ** (-7 * random()), 0, 0, 0],
    ulps: 8, // 1 − sin² 1 and √ 3, of which at most half counts in the sum with 1; the sum 1; ÷ 2.5
  },
];

const recorded: StabilityRow[] = [];
afterAll(() => recordStability("bsdf-terms", recorded));

describe.each(CASES)("$what, $hard, seed 3,", ({ what, hard, ours, textbook, exact, draw, ulps }) => {
  test(`is exact to ${ulps} ULP`, async () => {
    const random = createRandom(3);
    const inputs = Array.from({ length: INPUTS }, () => draw(random).map(Math.fround) as unknown as Numbers);
    const [worst, naive] = await worstErrors(inputs, ours, textbook, exact);
    console.log(`${what}: ${(worst / ULP).toFixed(1)} ULP, textbook ${(naive / ULP).toExponential(1)} ULP`);
    recorded.push({
      case: `${what}: ${hard}`,
      asserted: `relative error ≤ ${ulps} · 2⁻²³`,
      inputs: INPUTS,
      worst,
      textbook: naive,
    });
    expect(worst).toBeLessThanOrEqual(ulps * ULP);
  });
});

/** Largest relative errors of two expressions; infinite where one is not finite. */
async function worstErrors(inputs: readonly Numbers[], ours: string, textbook: string, exact: Case["exact"]) {
  const words = await runProbe({
    wgsl: `
      import package::constants::PI;
      import package::directions::circle;
      import package::lobes::fresnel::schlickWeight;
      import package::lobes::ggx::{ggxD, ggxPdf, ggxVisibility, schlickBeckmannVisibility};
      import package::lights::sphere::coneOneMinusCos;

      fn k(alpha: f32) -> f32 { return alpha * sqrt(2.0 / PI); }

      fn lambda(cosTheta: f32, alpha: f32) -> f32 {
        let c2 = cosTheta * cosTheta;
        return 0.5 * (sqrt(1.0 + alpha * alpha * (1.0 - c2) / c2) - 1.0);
      }

      // D_v = G1·D·(wo·m) / cosO over 4·(wo·m). [Heitz 2014] eq. 3, 43
      fn lambdaPdf(cosO: f32, sinM: f32, alpha: f32) -> f32 {
        let m = vec3f(sinM, 0.0, sqrt(1.0 - sinM * sinM));
        let d = m.z * m.z * (alpha * alpha - 1.0) + 1.0;
        let D = alpha * alpha / (PI * d * d);
        return D / (1.0 + lambda(cosO, alpha)) / (4.0 * cosO);
      }

      fn probe(i: u32) {
        let x = bitcast<vec4f>(inputs[i]);
        outputs[i] = bitcast<vec4u>(vec4f(${ours}, ${textbook}, 0.0, 0.0));
      }`,
    conditions: {},
    modules: { scene: "" },
    count: inputs.length,
    inputs: new Float32Array(inputs.flat()),
    outputRows: inputs.length,
  });
  const values = new Float32Array(words.buffer);
  return [0, 1].map((column) => {
    let worst = 0;
    for (const [i, x] of inputs.entries()) {
      const error = Math.abs(values[4 * i + column]! / exact(x) - 1);
      worst = Math.max(worst, Number.isFinite(error) ? error : Number.POSITIVE_INFINITY);
    }
    return worst;
  }) as [number, number];
}
