import { describe, expect, test } from "vitest";
import type { Light, Material, Scene, SceneObject, Vec3 } from "../../src/scene/schema";
import { renderScene, renderSeeds, seedsFrom } from "../support/device";
import { createRandom } from "../support/random";
import { measurePoint, ROUNDING } from "../support/statistics";

const ESTIMATORS = ["path", "uniform"] as const;
const ALBEDO = 0.5;
const RADIANS = Math.PI / 180;
// Relative error that all samples share: f32 arithmetic of some ten operations on numbers that are exact to 2⁻²⁴.
const ARITHMETIC = 1e-5;

const sun = (direction: Vec3, angularDiameter: number, irradiance = 3): Light => {
  return { type: "directional", direction, irradiance: [irradiance, irradiance, irradiance], angularDiameter };
};

const MATERIALS: Readonly<Record<string, Material>> = {
  floor: { baseColor: [ALBEDO, ALBEDO, ALBEDO], ior: 1 },
  mirror: { metallic: 1, roughness: 0 },
};
const FLOOR: SceneObject = { type: "plane", point: [0, 0, 0], normal: [0, 1, 0], material: "floor" };

/** A camera that sees nothing of a floor but the origin: see litPlane.test.ts. */
function floorScene(lights: readonly Light[], objects: readonly SceneObject[] = []): Scene {
  return {
    camera: { position: [5, 5, 0], target: [0, 0, 0], verticalFov: 1e-4 },
    materials: MATERIALS,
    objects: [FLOOR, ...objects],
    lights,
  };
}

/** What the floor shows at the origin, over ALBEDO / π. */
async function irradianceOf(scene: Scene, estimator: "path" | "uniform", constants = false) {
  const settings = { estimator, maxBounces: 1, constants };
  const { image, stats } = await renderScene(scene, { size: [16, 16], samples: 64, seed: 1, settings });
  expect(stats.badSamples).toBe(0);
  const { mean, standardError } = measurePoint(image);
  return { irradiance: (mean * Math.PI) / ALBEDO, standardError: (standardError * Math.PI) / ALBEDO };
}

describe.each(ESTIMATORS)("a floor lit by a sun 40° from the zenith, %s estimator, seed 1,", (estimator) => {
  const direction: Vec3 = [2 * Math.sin(40 * RADIANS), -2 * Math.cos(40 * RADIANS), 0];

  test.each([0, 1e-4, 0.53, 30, 90])("gets irradiance · cos 40°, whatever its diameter, %d°", async (diameter) => {
    const { irradiance, standardError } = await irradianceOf(floorScene([sun(direction, diameter)]), estimator);
    const expected = 3 * Math.cos(40 * RADIANS);
    // The largest is a cone that reaches 85° from the zenith. The smallest count as points.
    expect(Math.abs(irradiance - expected)).toBeLessThanOrEqual(4 * standardError + (ROUNDING + ARITHMETIC) * expected);
    if (diameter < 1e-3) expect(standardError).toBeLessThan(1e-5);
  });
});

test("a sun below the ground does not shine through it, with values as constants either", async () => {
  for (const constants of [false, true]) {
    for (const diameter of [0, 1]) {
      const scene = floorScene([sun([0, 1, 0.1], diameter)]);
      const ball: SceneObject = { type: "sphere", center: [0, 1, 0], radius: 0.5, material: "floor" };
      // The lower half of a ball over the ground, which would be lit from below.
      const { image } = await renderScene(
        { ...scene, objects: [...scene.objects, ball], camera: { position: [0, 0.3, 4], target: [0, 0.6, 0] } },
        { size: [8, 8], samples: 4, settings: { constants, maxBounces: 1 } },
      );
      expect(Math.max(...image.filter((_, i) => i % 4 === 0))).toBe(0);
    }
  }
});

test.each([1e-9, 1e12])("a sun gives a scene %d times as large the same, and shadows too", async (size) => {
  const material = "floor";
  const scene = (objects: readonly SceneObject[]): Scene => ({
    ...floorScene([sun([0, -1, 0], 1)], objects),
    camera: { position: [5 * size, 5 * size, 0], target: [0, 0, 0], verticalFov: 1e-4 },
  });
  const roofAt = (x: number): SceneObject => {
    return {
      type: "quad",
      corner: [x * size, 2 * size, -size],
      edge1: [2 * size, 0, 0],
      edge2: [0, 0, 2 * size],
      material,
    };
  };
  const open = await irradianceOf(scene([roofAt(-4)]), "path");
  expect(Math.abs(open.irradiance - 3)).toBeLessThan(4 * open.standardError + 3 * (ROUNDING + ARITHMETIC));
  expect((await irradianceOf(scene([roofAt(-1)]), "path")).irradiance).toBe(0);
});

// Under the edge of a roof that covers part of a disk in the zenith. On the roof's plane the disk is a circle whose radius is 1 here;
// its solid angle and cosine vary by 2·sin²1° = 6e-4 over it.
test.each([-1.5, -0.7, 0, 0.4, 0.9, 1.5])(
  "half a shadow is that of a disk cut by a line, %d radii from its middle, seed 1",
  async (at) => {
    const height = 20;
    const edge = at * height * Math.tan(1 * RADIANS);
    const roof: SceneObject = {
      type: "quad",
      corner: [edge, height, -50],
      edge1: [50, 0, 0],
      edge2: [0, 0, 100],
      material: "floor",
    };
    // The light of the sky that the camera would see does not count: its rays end on the floor.
    const cut = Math.max(-1, Math.min(1, at));
    const share = 1 - (Math.acos(cut) - cut * Math.sqrt(1 - cut * cut)) / Math.PI;
    const scene = floorScene([sun([0, -1, 0], 2)], [roof]);
    const below = { ...scene, camera: { ...scene.camera, position: [-5, 5, 0] as const } };
    const { irradiance, standardError } = await irradianceOf(below, "path");
    expect(Math.abs(irradiance - 3 * share)).toBeLessThanOrEqual(4 * standardError + 1e-3 * 3);
  },
);

describe("the disk of a sun of 0.53°", () => {
  const FOV = 0.8;
  const SIZE = 64;
  const radiance = 3 / (Math.PI * Math.sin(0.265 * RADIANS) ** 2);
  // Of the square picture.
  const share = (Math.PI * Math.tan(0.265 * RADIANS) ** 2) / (2 * Math.tan((FOV / 2) * RADIANS)) ** 2;

  test.each([
    ["in the sky", [0, 1, 5], [0, 1, 4], []],
    [
      "in a mirror",
      [0, 0, 5],
      [0, 0, 6],
      [{ type: "quad", corner: [-9, -9, 9], edge1: [0, 18, 0], edge2: [18, 0, 0], material: "mirror" }],
    ],
  ] as const)(
    "%s has the radiance and the size that its irradiance tells, seed 1",
    async (_, position, target, objects) => {
      const scene = {
        camera: { position, target, verticalFov: FOV },
        materials: MATERIALS,
        objects,
        lights: [sun([0, 0, 1], 0.53)],
      };
      const { image } = await renderScene(scene, { size: [SIZE, SIZE], samples: 32 });
      const middle = image[4 * (SIZE * (SIZE / 2) + SIZE / 2)]!;
      expect(Math.abs(middle / radiance - 1)).toBeLessThan(ROUNDING + ARITHMETIC);
      let sum = 0;
      for (let i = 0; i < SIZE * SIZE; i++) sum += image[4 * i]! / radiance;
      // The disk's rim crosses some 170 pixels of 4096; each is off by less than 0.5/√32.
      expect(Math.abs(sum / SIZE ** 2 / share - 1)).toBeLessThan(0.005);
      expect(image[0]).toBe(0);
    },
  );

  test("that is a point is nowhere", async () => {
    const camera = { position: [0, 0, 5], target: [0, 0, 4], verticalFov: FOV } as const;
    const { image } = await renderScene(
      { camera, objects: [], lights: [sun([0, 0, 1], 0)] },
      { size: [8, 8], samples: 4 },
    );
    expect(Math.max(...image.filter((_, i) => i % 4 === 0))).toBe(0);
  });
});

const GLOSSY: Material = { baseColor: [0.7, 0.6, 0.5], metallic: 0.5, roughness: 0.5 };

/** Suns among lamps over a floor and a ball. */
function mixedScene(lampCount: number): Scene {
  const random = createRandom(5);
  const around = (y: number): Vec3 => [4 * random() - 2, y, 4 * random() - 2];
  const lamps = Array.from({ length: lampCount }, (_, i): Light => {
    const power: Vec3 = [30 / lampCount, 30 / lampCount, 30 / lampCount];
    if (i % 3 === 0) return { type: "point", position: around(2), power };
    if (i % 3 === 1) {
      return { type: "spot", position: around(2), direction: around(-4), power, outerAngle: 60, radius: 0.1 * (i % 2) };
    }
    return { type: "sphere", position: around(2), radius: 0.1, power };
  });
  return {
    camera: { position: [0, 2.5, 4], target: [0, 0.3, 0], verticalFov: 45 },
    materials: { floor: GLOSSY },
    objects: [FLOOR, { type: "sphere", center: [0, 0.5, 0], radius: 0.5, material: "floor" }],
    lights: [sun([1, -1, 0.5], 20), ...lamps, sun([-1, -2, 1], 0, 1), sun([0.2, -1, 2], 60, 1), sun([0, 1, 0], 1, 5)],
    maxBounces: 2,
  };
}

describe.each([
  ["four suns alone", 0, 1],
  ["four suns and six lamps", 6, 1],
  ["four suns and six lamps, four light samples", 6, 4],
  ["four suns and fifty lamps, which are looked up in a loop", 50, 1],
])("%s, seeds 1–8", (_, lampCount, lightSamples) => {
  test("give as much as the baseline finds", async () => {
    const means = async (settings: object, samples: number) => {
      const renders = await renderSeeds(mixedScene(lampCount), {
        size: [16, 16],
        samples,
        seeds: seedsFrom(1, 8),
        settings,
      });
      for (const { stats } of renders) expect(stats.badSamples).toBe(0);
      const values = renders.map(({ image }) => measurePoint(image).mean);
      const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
      const squares = values.reduce((sum, value) => sum + (value - mean) ** 2, 0);
      return { mean, standardError: Math.sqrt(squares / (values.length * (values.length - 1))) };
    };
    const samples = lampCount > 40 ? 32 : 64;
    const path = await means({ lightSamples }, samples);
    const baseline = await means({ estimator: "uniform", lightSamples: 8 }, 2 * samples);
    const sigma = Math.hypot(path.standardError, baseline.standardError);
    console.log(`${path.mean.toFixed(5)} against ${baseline.mean.toFixed(5)} ± ${sigma.toExponential(1)}`);
    // Student's t with 7 degrees of freedom is below 5.41 with probability 0.999.
    expect(Math.abs(path.mean - baseline.mean)).toBeLessThan(5.41 * sigma);
    expect(sigma).toBeLessThan(0.01 * baseline.mean); // or the comparison would say nothing
  }, 180_000);
});
