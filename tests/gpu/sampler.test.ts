import { beforeAll, describe, expect, test } from "vitest";
import { runProbe } from "../support/probe";
import { type Address, sobolSequence } from "../support/samplerTwin";

// A scatter of addresses: neighbours and corners of images, both halves, seeds and dimensions small and extreme.
const ADDRESSES: readonly Address[] = [0, 1, 2, 7, 100, 16383].flatMap((x, i) =>
  ([0, 1] as const).flatMap((half) =>
    [0, 1, 2, 3, 24, 3072].map((dimension, j) => ({
      x,
      y: [0, 1, 5, 99, 4000, 16383][(i + j) % 6]!,
      half,
      seed: [1, 2, 0, 0xffffffff, 123456][(i + j) % 5]!,
      dimension,
    })),
  ),
);
const POINTS = 1024;
// Indices far into a sequence, beyond any stretch a net test covers.
const FAR_INDICES = [1024, 65535, 65536, 999_999, 2 ** 24 + 1, 2 ** 31 - 1];
const INDICES = [...Array(POINTS).keys(), ...FAR_INDICES];

/** Per address, x and y of every index as numerators of 24-bit fractions. */
type PointSets = readonly (readonly (readonly [number, number])[])[];

let device: PointSets;
const twin: PointSets = ADDRESSES.map((address) => {
  const point = sobolSequence(address);
  return INDICES.map((index) => point(index));
});

beforeAll(async () => {
  device = await devicePoints(ADDRESSES, INDICES);
});

describe(`Sobol points of ${ADDRESSES.length} addresses, seeds 0, 1, 2, 123456 and 2³² − 1`, () => {
  test("are on the device what the papers say, bit for bit", () => {
    expect(device).toEqual(twin);
  });

  test.each(["twin", "device"] as const)("are a (0, m, 2)-net for every m up to 10, on the %s", (where) => {
    const sets = where === "twin" ? twin : device;
    for (const [i, points] of sets.entries()) {
      for (let m = 1; m <= 10; m++) {
        const failure = emptyInterval(points.slice(0, 2 ** m), m);
        expect(failure, `${JSON.stringify(ADDRESSES[i])}, m = ${m}`).toBeUndefined();
      }
    }
  });

  test("lie in [0, 1)", () => {
    expect(device.flat().filter(([x, y]) => !(Math.max(x, y) < 2 ** 24))).toEqual([]);
  });
});

describe("different addresses", () => {
  // For a pair of independent sequences, shuffled as whole binary trees, the correlation of n = 1024 points has mean 0 and
  // variance below 2/n: the leading bit of one is matched at random to the other's in pairs of points, n/2 of them, which
  // gives 2/n, and the bits after it add less. Points that were merely random would have 1/n.
  const sigma = Math.sqrt(2 / POINTS);
  const base: Address = { x: 11, y: 23, half: 0, seed: 1, dimension: 2 };
  const steps = [...Array(32).keys()].map((i) => i + 1);
  const families: Readonly<Record<string, readonly Address[]>> = {
    dimensions: steps.map((i) => ({ ...base, dimension: 2 + i })),
    pixels: steps.flatMap((i) => [
      { ...base, x: 11 + i },
      { ...base, y: 23 + i },
    ]),
    "film halves": steps.map((i) => ({ ...base, half: 1, dimension: 1 + i })),
    seeds: steps.map((i) => ({ ...base, seed: 1 + i })),
  };

  test.each(Object.keys(families))("are uncorrelated: %s", (family) => {
    const first = sequence(base);
    const correlations = families[family]!.flatMap((address) => {
      const second = sequence(address);
      return [0, 1].flatMap((a) => [0, 1].map((b) => correlation(first, second, a as 0 | 1, b as 0 | 1)));
    });
    for (const value of correlations) expect(Math.abs(value)).toBeLessThan(4 * sigma);
    const mean = correlations.reduce((sum, value) => sum + value, 0) / correlations.length;
    expect(Math.abs(mean)).toBeLessThan((4 * sigma) / Math.sqrt(correlations.length));
  });

  test("the two film halves of a pixel are uncorrelated over many pixels", () => {
    const correlations = [...Array(512).keys()].map((x) => {
      const halves = ([0, 1] as const).map((half) => sequence({ ...base, x, half }, 16));
      return correlation(halves[0]!, halves[1]!, 0, 0);
    });
    const mean = correlations.reduce((sum, value) => sum + value, 0) / correlations.length;
    expect(Math.abs(mean)).toBeLessThan((4 * Math.sqrt(2 / 16)) / Math.sqrt(512));
  });
});

/** Points from the device. */
async function devicePoints(addresses: readonly Address[], indices: readonly number[]): Promise<PointSets> {
  const inputs = new Uint32Array([
    ...addresses.flatMap(({ x, y, half, seed, dimension }) => [x, y, half, seed, dimension, 0, 0, 0]),
    ...indices.flatMap((index) => [index, 0, 0, 0]),
  ]);
  const count = addresses.length * indices.length;
  const words = await runProbe({
    wgsl: `
      import package::sampler::{makeSampler, point};
      fn probe(i: u32) {
        let address = i / ${indices.length}u;
        let pixelAndHalf = inputs[2u * address];
        let dimension = inputs[2u * address + 1u].x;
        let index = inputs[${2 * addresses.length}u + i % ${indices.length}u].x;
        let samples = makeSampler(pixelAndHalf.xy, pixelAndHalf.z, pixelAndHalf.w, index);
        outputs[i] = vec4u(vec2u(point(samples, dimension) * 0x1p24), 0u, 0u);
      }`,
    conditions: { SOBOL: true },
    count,
    inputs,
    outputRows: count,
  });
  return addresses.map((_, a) =>
    indices.map((_, i) => {
      const at = 4 * (a * indices.length + i);
      return [words[at]!, words[at + 1]!] as const;
    }),
  );
}

/** An elementary interval of area 2^-m that does not hold exactly one of the 2^m points, in words; else undefined. */
function emptyInterval(points: readonly (readonly [number, number])[], m: number): string | undefined {
  for (let k = 0; k <= m; k++) {
    // Columns of width 2^-k, rows of height 2^-(m − k).
    const taken = new Uint8Array(2 ** m);
    for (const [x, y] of points) {
      const cell = (x >>> (24 - k)) * 2 ** (m - k) + (y >>> (24 - m + k));
      if (taken[cell]) return `two points in cell ${cell} of ${2 ** k} × ${2 ** (m - k)}`;
      taken[cell] = 1;
    }
  }
  return undefined;
}

function sequence(address: Address, count = POINTS): [number, number][] {
  const point = sobolSequence(address);
  return Array.from({ length: count }, (_, i) => point(i));
}

function correlation(first: [number, number][], second: [number, number][], a: 0 | 1, b: 0 | 1): number {
  const mean = (points: [number, number][], c: 0 | 1) => points.reduce((sum, p) => sum + p[c], 0) / points.length;
  const [meanA, meanB] = [mean(first, a), mean(second, b)];
  let [ab, aa, bb] = [0, 0, 0];
  for (const [i, p] of first.entries()) {
    const [u, v] = [p[a] - meanA, second[i]![b] - meanB];
    ab += u * v;
    aa += u * u;
    bb += v * v;
  }
  return ab / Math.sqrt(aa * bb);
}
