import { afterAll, expect, test } from "vitest";
import { runProbe } from "../../support/probe";
import { LONG, small } from "../../support/stability";
import { recordStability } from "../../support/stabilityRows";

// A pixel's sum after a million samples, added one by one.
const SAMPLES = 1_000_000 * LONG;
// A call loses at most 2⁻¹⁵ ULP of the sum for good, in each of n calls, half a ULP of the sample itself, and the sum that
// readers see lacks its carry, less than 4 ULP.
const BOUND = SAMPLES * 2 ** -15 * 2 ** -23 + 2 ** -24 + 4 * 2 ** -23;

const rows = [
  { name: "a constant", values: [0.1, 0.7, 3.3] },
  { name: "a rare bright sample among dark ones", values: [0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 40] },
  { name: "values over many magnitudes", values: [1e-8, 3e-4, 0.9, 17, 2500] },
];
const worst = { ours: 0, textbook: 0 };

test.each(rows)("a million samples, $name, add up to their sum", async ({ values }) => {
  const threads = 64;
  const words = await runProbe({
    wgsl: `
      import package::film::{FilmPixel, filmAdd};
      fn probe(i: u32) {
        let factor = 1.0 + f32(i) / 64.0;
        var pixel = FilmPixel(vec4f(0.0), vec2u(0u));
        var plain = 0.0;
        for (var k = 0u; k < ${SAMPLES}u; k++) {
          let x = factor * bitcast<f32>(inputs[(k + i) % ${values.length}u].x);
          pixel = filmAdd(pixel, vec4f(x, 2.0 * x, 0.3 * x, 1.0));
          plain += x;
        }
        outputs[2u * i] = bitcast<vec4u>(pixel.sum);
        outputs[2u * i + 1u] = vec4u(bitcast<u32>(plain), 0u, 0u, 0u);
      }`,
    conditions: {},
    count: threads,
    inputs: new Float32Array(values.flatMap((value) => [value, 0, 0, 0])),
    outputRows: 2 * threads,
  });
  const sums = new Float32Array(words.buffer);
  for (let i = 0; i < threads; i++) {
    const factor = 1 + i / 64;
    let expected = [0, 0, 0];
    // What the device adds, in doubles: one period of the values, rounded as it rounds them.
    for (const [k] of values.entries()) {
      const repeats = Math.ceil((SAMPLES - k) / values.length);
      const x = Math.fround(factor * Math.fround(values[(k + i) % values.length]!));
      const channels = [x, Math.fround(2 * x), Math.fround(Math.fround(0.3) * x)];
      expected = expected.map((sum, c) => sum + repeats * channels[c]!);
    }
    for (let c = 0; c < 3; c++) {
      const error = Math.abs(sums[8 * i + c]! / expected[c]! - 1);
      worst.ours = Math.max(worst.ours, error);
      expect(error).toBeLessThan(BOUND);
    }
    expect(sums[8 * i + 3]).toBe(SAMPLES);
    worst.textbook = Math.max(worst.textbook, Math.abs(sums[8 * i + 4]! / expected[0]! - 1));
  }
});

// Of 2²⁴ samples, as many as a half of the film takes, the last 4,096 one by one, and more than that for good measure.
test("the last of 2²⁴ samples count as much as the first", async () => {
  const last = 4096;
  const words = await runProbe({
    wgsl: `
      import package::film::{FilmPixel, filmAdd};
      fn probe(i: u32) {
        let x = bitcast<f32>(inputs[i].x);
        let before = 16777216.0 - ${last}.0;
        var pixel = filmAdd(FilmPixel(vec4f(0.0), vec2u(0u)), vec4f(x * 0x1p24, x * 0x1p24, x * 0x1p24, before));
        for (var k = 0u; k < ${last}u; k++) { pixel = filmAdd(pixel, vec4f(0.0, x, 3.0 * x, 1.0)); }
        outputs[i] = bitcast<vec4u>(pixel.sum);
      }`,
    conditions: {},
    count: 64,
    inputs: new Float32Array(Array.from({ length: 64 }, (_, i) => [1 + i / 64, 0, 0, 0]).flat()),
    outputRows: 64,
  });
  const sums = new Float32Array(words.buffer);
  for (let i = 0; i < 64; i++) {
    const x = 1 + i / 64;
    const expected = [0, 1, 3].map((times) => x * 2 ** 24 + times * last * x);
    // As above: 2⁻¹⁵ ULP a call, and less than 4 ULP that the carry holds.
    const bound = (last * 2 ** -15 + 4) * 2 ** -23;
    for (let c = 0; c < 3; c++) expect(Math.abs(sums[4 * i + c]! / expected[c]! - 1)).toBeLessThan(bound);
    expect(sums[4 * i + 3]).toBe(2 ** 24);
  }
});

afterAll(() => {
  recordStability("film", [
    {
      case: "A pixel's sum of 10⁶ samples: constant, spiky, over many magnitudes",
      asserted: `relative error below ${small(BOUND)}`,
      inputs: rows.length * 64 * SAMPLES,
      worst: small(worst.ours),
      textbook: `${small(worst.textbook)}: sum += sample`,
    },
  ]);
});
