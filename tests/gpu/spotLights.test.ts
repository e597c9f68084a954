import { describe, expect, test } from "vitest";
import type { Light, Rgb, Scene, Vec3 } from "../../src/scene/schema";
import { renderScene } from "../support/device";
import { measurePoint, ROUNDING } from "../support/statistics";

const RADIANS = Math.PI / 180;
const ALBEDO = 0.5;
// Relative error that all samples share: f32 arithmetic of some ten operations on numbers that are exact to 2⁻²⁴.
const ARITHMETIC = 1e-5;
const [INNER, OUTER] = [20, 40];
const TEN: Rgb = [10, 10, 10];

/** Seen from straight above the origin, the axis passes it by at an angle. */
function spotAt(height: number, angle: number, fields: Partial<Light & { type: "spot" }>): Light {
  const direction: Vec3 = [3 * Math.sin(angle * RADIANS), -3 * Math.cos(angle * RADIANS), 0];
  return { type: "spot", position: [0, height, 0], direction, innerAngle: INNER, outerAngle: OUTER, ...fields };
}

/** What arrives at the origin of a floor, of which the camera sees no more. */
async function irradianceOf(light: Light, estimator: "path" | "uniform") {
  const scene: Scene = {
    camera: { position: [5, 5, 0], target: [0, 0, 0], verticalFov: 1e-4 },
    materials: { floor: { baseColor: [ALBEDO, ALBEDO, ALBEDO], ior: 1 } },
    objects: [{ type: "plane", point: [0, 0, 0], normal: [0, 1, 0], material: "floor" }],
    lights: [light],
  };
  const settings = { estimator, maxBounces: 1 };
  const { image, stats } = await renderScene(scene, { size: [16, 16], samples: 64, seed: 1, settings });
  expect(stats.badSamples).toBe(0);
  const { mean, standardError } = measurePoint(image);
  return { irradiance: (mean * Math.PI) / ALBEDO, standardError: (standardError * Math.PI) / ALBEDO };
}

/** KHR_lights_punctual. */
function falloff(cosine: number): number {
  const [inner, outer] = [Math.cos(INNER * RADIANS), Math.cos(OUTER * RADIANS)];
  return Math.max(0, Math.min(1, (cosine - outer) / (inner - outer))) ** 2;
}

describe.each(["path", "uniform"] as const)("a spot, %s estimator, seed 1,", (estimator) => {
  test.each([0, 19, 25, 30, 39, 41, 89, 120])("shines by glTF's falloff, %d° from its axis", async (angle) => {
    const { irradiance, standardError } = await irradianceOf(spotAt(2, angle, { intensity: TEN }), estimator);
    const expected = (10 / 4) * falloff(Math.cos(angle * RADIANS));
    expect(standardError).toBeLessThan(1e-5);
    // The falloff is a square of a difference of cosines, which are good to 2⁻²², over 0.17.
    expect(Math.abs(irradiance - expected)).toBeLessThanOrEqual((ROUNDING + ARITHMETIC) * expected + 1e-5);
  });

  test("goes as 1/distance²", async () => {
    for (const height of [0.5, 1, 1000]) {
      const { irradiance } = await irradianceOf(spotAt(height, 5, { intensity: TEN }), estimator);
      expect(Math.abs((irradiance * height ** 2) / 10 - 1)).toBeLessThan(ROUNDING + ARITHMETIC);
    }
  });

  test.each([0, 25])("with a radius gives what its disk does, near and %d° from its axis", async (angle) => {
    const [radius, height] = [0.8, 2];
    const light = spotAt(height, angle, { intensity: TEN, radius });
    const { irradiance, standardError } = await irradianceOf(light, estimator);
    const expected = irradianceOfDisk(height, angle, radius);
    expect(expected).not.toBeCloseTo((10 / 4) * falloff(Math.cos(angle * RADIANS)), 1); // it is near
    expect(Math.abs(irradiance - expected)).toBeLessThanOrEqual(4 * standardError + 1e-4 * expected);
  });
});

test("a spot's power is what leaves it, by quadrature over the sphere", async () => {
  // The intensity at the middle of the cone, from what arrives there, times the integral of the falloff.
  const { irradiance } = await irradianceOf(spotAt(2, 0, { power: TEN }), "path");
  const steps = 10_000;
  let integral = 0;
  for (let i = 0; i < steps; i++) integral += (4 * Math.PI * falloff(1 - (2 * (i + 0.5)) / steps)) / steps;
  // The midpoint rule on 760 of the steps, where a parabola ends: 1e-6.
  expect(Math.abs((irradiance * 4 * integral) / 10 - 1)).toBeLessThan(1e-4);
});

test("no ray finds a spot", async () => {
  const scene: Scene = {
    camera: { position: [0, 0, 5] },
    objects: [],
    lights: [{ type: "spot", position: [0, 0, 0], direction: [0, 0, 1], power: TEN, radius: 1 }],
  };
  const { image } = await renderScene(scene, { size: [8, 8], samples: 4 });
  expect(Math.max(...image.filter((_, i) => i % 4 === 0))).toBe(0);
});

/** By points spread evenly over the disk, each of which shines like the whole. */
function irradianceOfDisk(height: number, angle: number, radius: number): number {
  const steps = 400;
  const [sine, cosine] = [Math.sin(angle * RADIANS), Math.cos(angle * RADIANS)];
  let sum = 0;
  for (let i = 0; i < steps; i++) {
    const r = radius * Math.sqrt((i + 0.5) / steps);
    for (let k = 0; k < steps; k++) {
      const turn = (2 * Math.PI * (k + 0.5)) / steps;
      const [a, z] = [r * Math.cos(turn), r * Math.sin(turn)];
      const [x, y] = [a * cosine, height + a * sine];
      const d2 = x * x + y * y + z * z;
      // The way down from here is (−x, −y, −z).
      const alongAxis = (-x * sine + y * cosine) / Math.sqrt(d2);
      sum += ((10 * falloff(alongAxis)) / d2) * (y / Math.sqrt(d2));
    }
  }
  return sum / steps ** 2;
}
