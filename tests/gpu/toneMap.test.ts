import { expect, test } from "vitest";
import { PathTracer, type Scene, type ToneMap } from "../../src";
import { testDevice } from "../support/device";

type Rgb = readonly [number, number, number];

// By the rows of the papers' own matrices, in doubles: none of it is read from the shader. See `tonemap.wgsl` for the papers.
const RRT = [
  [0.59719, 0.35458, 0.04823],
  [0.076, 0.90834, 0.01566],
  [0.0284, 0.13383, 0.83777],
] as const;
const ODT = [
  [1.60475, -0.53108, -0.07367],
  [-0.10208, 1.10813, -0.00605],
  [-0.00327, -0.07276, 1.07602],
] as const;
const INSET = [
  [0.842479062253094, 0.0784335999999992, 0.0792237451477643],
  [0.0423282422610123, 0.878468636469772, 0.0791661274605434],
  [0.0423756549057051, 0.0784336, 0.879142973793104],
] as const;
const OUTSET = [
  [1.19687900512017, -0.0980208811401368, -0.0990297440797205],
  [-0.0528968517574562, 1.15190312990417, -0.0989611768448433],
  [-0.0529716355144438, -0.0980434501171241, 1.15107367264116],
] as const;

const RADIANCES: readonly Rgb[] = [
  [0, 0, 0],
  [0.001, 0.002, 0.004],
  [0.18, 0.18, 0.18],
  [0.6, 0.1, 0.02],
  [1, 1, 1],
  [3, 0.4, 8],
  [200, 100, 50],
];

const CURVES: Readonly<Record<ToneMap, (radiance: Rgb) => number[]>> = {
  none: (radiance) => radiance.map((value) => srgb(unit(value))),
  aces: (radiance) => {
    const fitted = times(RRT, radiance).map(
      (v) => (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.432951) + 0.238081),
    );
    return times(ODT, fitted).map((value) => srgb(unit(value)));
  },
  agx: (radiance) => {
    const [low, high] = [-12.47393, 4.026069];
    const curved = times(INSET, radiance).map((value) => {
      const x = (Math.min(high, Math.max(low, Math.log2(value))) - low) / (high - low);
      return 15.5 * x ** 6 - 40.14 * x ** 5 + 31.96 * x ** 4 - 6.868 * x ** 3 + 0.4298 * x ** 2 + 0.1191 * x - 0.00232;
    });
    return times(OUTSET, curved).map(unit);
  },
};

// A byte is rounded; f32 of this size is off by a thousandth of one at most, which may round the other way.
const TOLERANCE = 0.51;

test.each(["none", "aces", "agx"] as const)(
  "%s is the curve that its paper gives, at any brightness",
  async (toneMap) => {
    const device = await testDevice();
    const tracer = await PathTracer.create({ scene: sky([0, 0, 0]), width: 1, height: 1, device });
    for (const radiance of RADIANCES) {
      await tracer.setScene(sky(radiance));
      await tracer.sample(2);
      const [red, green, blue, alpha] = await tracer.readPicture({ toneMap });
      expect(alpha).toBe(255);
      const expected = CURVES[toneMap](radiance).map((value) => 255 * value);
      for (const [channel, shown] of [red, green, blue].entries()) {
        expect(Math.abs(shown! - expected[channel]!)).toBeLessThanOrEqual(TOLERANCE);
      }
    }
    tracer.dispose();
  },
);

test("aces is what a picture gets that asks for nothing", async () => {
  const tracer = await PathTracer.create({ scene: sky([3, 0.4, 8]), width: 1, height: 1, device: await testDevice() });
  await tracer.sample(2);
  expect(await tracer.readPicture()).toEqual(await tracer.readPicture({ toneMap: "aces" }));
  expect(await tracer.readPicture()).not.toEqual(await tracer.readPicture({ toneMap: "none" }));
  tracer.dispose();
});

/** A scene that has this radiance everywhere. */
function sky(radiance: Rgb): Scene {
  return { camera: { position: [0, 0, 1] }, objects: [], environment: { radiance } };
}

function times(rows: readonly (readonly number[])[], vector: readonly number[]): number[] {
  return rows.map((row) => row.reduce((sum, value, i) => sum + value * vector[i]!, 0));
}

function unit(value: number): number {
  return Math.min(1, Math.max(0, value));
}

function srgb(linear: number): number {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055;
}
