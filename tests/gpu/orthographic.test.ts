import { describe, expect, test } from "vitest";
import { cameraBasis } from "../../src/renderer/cameraBasis";
import { PathTracer } from "../../src/renderer/pathTracer";
import { parseScene } from "../../src/scene/parseScene";
import type { Camera, Scene, SceneObject, Vec3 } from "../../src/scene/schema";
import { renderScene, renderSeeds, seedsFrom, testDevice } from "../support/device";
import { add, meetings, scale, subtract } from "../support/oracle";
import { measure } from "../support/statistics";

const SIZE = 48;
const material = "m";
const BLACK = { m: { baseColor: [0, 0, 0], ior: 1 } } as const;
const ball = (center: Vec3, radius = 1): SceneObject => ({ type: "sphere", center, radius, material });

/** Black things before a white sky: a pixel shows the share of the sky in it. */
function silhouette(camera: Camera, ...objects: SceneObject[]): Scene {
  return { camera, materials: BLACK, objects, environment: { radiance: [1, 1, 1] }, maxBounces: 0 };
}

/** Black pixels, counting parts. */
function darkness(image: Float32Array, isIn: (x: number, y: number) => boolean = () => true): number {
  let sum = 0;
  for (let i = 0; i < image.length / 4; i++) if (isIn(i % SIZE, Math.floor(i / SIZE))) sum += 1 - image[4 * i]!;
  return sum;
}

const square = { size: [SIZE, SIZE], samples: 256 } as const;
// Of some 150 pixels on an edge, each with a share that 256 points tell to 1/256 or so: as independent ones would be, √150/256.
const EDGE_ERROR = 4 * (Math.sqrt(150) / 256);

describe("a ball's silhouette, seed 1", () => {
  test.each<[string, Camera, Vec3, number]>([
    ["before the camera", { position: [0, 0, 6], orthographicHeight: 3 }, [0, 0, 0], 1],
    ["a million metres away", { position: [0, 0, 1e6], orthographicHeight: 3 }, [0, 0, 0], 1],
    ["seen from the side", { position: [4, 3, 2], target: [0, 0, 0], orthographicHeight: 3 }, [0, 0, 0], 1],
    ["of a millionth of a metre", { position: [0, 0, 6e-6], orthographicHeight: 3e-6 }, [0, 0, 0], 1e-6],
    ["of a million metres", { position: [0, 0, 6e6], orthographicHeight: 3e6 }, [0, 0, 0], 1e6],
    [
      "far from the world's origin",
      { position: [1e7, 0, 6], target: [1e7, 0, 0], orthographicHeight: 3 },
      [1e7, 0, 0],
      1,
    ],
    [
      "half behind the plane where rays start",
      { position: [0, 0, 0], target: [0, 0, -1], orthographicHeight: 3 },
      [0, 0, 0],
      1,
    ],
  ])("is a circle of two thirds of the picture: %s", async (_, camera, center, radius) => {
    const { image, stats } = await renderScene(silhouette(camera, ball(center, radius)), square);
    expect(stats.badSamples).toBe(0);
    expect(Math.abs(darkness(image) - Math.PI * (SIZE / 3) ** 2)).toBeLessThan(EDGE_ERROR);
    const quarter = (Math.PI / 4) * (SIZE / 3) ** 2;
    for (const isRight of [false, true]) {
      for (const isLow of [false, true]) {
        const part = darkness(image, (x, y) => x >= SIZE / 2 === isRight && y >= SIZE / 2 === isLow);
        expect(Math.abs(part - quarter)).toBeLessThan(EDGE_ERROR);
      }
    }
  });

  test("does not depend on how far the ball is, nor on the field of view", async () => {
    const areas = [];
    for (const z of [4, 0, -1000]) {
      const camera: Camera = { position: [0, 0, 6], orthographicHeight: 4, verticalFov: 30 - z / 50 };
      areas.push(darkness((await renderScene(silhouette(camera, ball([0.5, -0.3, z])), square)).image));
    }
    for (const area of areas) expect(Math.abs(area - Math.PI * (SIZE / 4) ** 2)).toBeLessThan(EDGE_ERROR);
  });

  test("is as wide as it is high in a wide picture", async () => {
    const camera: Camera = { position: [0, 0, 6], orthographicHeight: 3 };
    const { image } = await renderScene(silhouette(camera, ball([0, 0, 0])), { size: [96, 32], samples: 256 });
    const [left, right] = [48 - 32 / 3, 48 + 32 / 3];
    const inRow = (x: number) => image[4 * (16 * 96 + x)]!;
    expect(
      [Math.floor(left) - 1, Math.floor(left) + 1, Math.floor(right) - 1, Math.floor(right) + 1].map(inRow),
    ).toEqual([1, 0, 0, 1]);
  });
});

describe("a floor", () => {
  const GLOWING = { m: { baseColor: [0, 0, 0], ior: 1, emission: [1, 1, 1] } } as const;
  const floor: SceneObject = { type: "plane", point: [0, 0, 0], normal: [0, 1, 0], material };
  const scene = (camera: Camera): Scene => ({ camera, materials: GLOWING, objects: [floor], maxBounces: 0 });

  test("has no horizon, however slowly the view sinks", async () => {
    const { image } = await renderScene(scene({ position: [0, 5, 1000], target: [0, 4, 0], orthographicHeight: 4 }), {
      size: [16, 16],
      samples: 16,
    });
    expect(image.every((value) => value === 1)).toBe(true);
  });

  test.each([false, true])("is not seen by rays that start below it; constants: %s", async (constants) => {
    // The view sinks by 3 in 5, so that 1 up in the picture is 0.8 up in the scene: the middle of the picture starts 0.8 above the
    // floor, and the floor cuts it a quarter of its height below the middle.
    const camera: Camera = { position: [0, 0.8, 0], target: [0, -2.2, -4], orthographicHeight: 4 };
    const { image } = await renderScene(scene(camera), { size: [16, 16], samples: 16, settings: { constants } });
    const rows = Array.from({ length: 16 }, (_, y) => image[4 * (16 * y + 7)]!);
    expect(rows).toEqual(rows.map((_, y) => (y < 12 ? 1 : 0)));
  });
});

test.each([false, true])("a floor shades what rays from below it see; constants: %s", async (constants) => {
  // The lower half of the picture starts below the floor; there is a ball, which no light reaches.
  const scene: Scene = {
    camera: { position: [0, 0, 5], target: [0, 0, 0], orthographicHeight: 4 },
    materials: { m: { ior: 1 }, black: { baseColor: [0, 0, 0], ior: 1 } },
    objects: [
      { type: "plane", point: [0, -0.1, 0], normal: [0, 1, 0], material: "black" },
      { type: "sphere", center: [0, -1.2, 0], radius: 1, material },
    ],
    lights: [{ type: "point", position: [0, 3, 3], power: [100, 100, 100] }],
    maxBounces: 1,
  };
  const { image } = await renderScene(scene, { size: [16, 16], samples: 16, settings: { constants } });
  expect(image.every((value, i) => value === (i % 4 === 3 ? 1 : 0))).toBe(true);
});

describe("a lamp in view, seeds 1–4", () => {
  const scene: Scene = {
    camera: { position: [3, 2, 6], target: [0.2, 0.1, 0], orthographicHeight: 5 },
    objects: [],
    lights: [{ type: "sphere", position: [0, 0, 0], radius: 0.7, power: [10, 20, 30] }],
    maxBounces: 0,
  };

  test.each(["path", "uniform"] as const)("shows its radiance on its disk, by the %s estimator", async (estimator) => {
    const renders = await renderSeeds(scene, {
      size: [SIZE, SIZE],
      samples: 64,
      seeds: seedsFrom(1, 4),
      settings: { estimator },
    });
    const { mean, variance } = measure(
      renders.map(({ image }) => image),
      SIZE,
      SIZE,
      64,
    );
    const radiance = 10 / (4 * Math.PI ** 2 * 0.7 ** 2);
    const share = (Math.PI * 0.7 ** 2) / 25;
    let [sum, error] = [0, 0];
    for (let i = 0; i < SIZE * SIZE; i++) {
      sum += mean[3 * i]!;
      error += variance[3 * i]!;
    }
    expect(Math.abs(sum / SIZE ** 2 - share * radiance)).toBeLessThan((4 * Math.sqrt(error)) / SIZE ** 2);
    expect(Math.max(...mean)).toBeCloseTo(3 * radiance, 5);
  });
});

const ROOM: Scene = {
  camera: { position: [2.5, 2.5, 4], target: [0, 0.6, 0], orthographicHeight: 3 },
  materials: { m: { baseColor: [0.7, 0.6, 0.5] }, shiny: { metallic: 1, roughness: 0.3 } },
  objects: [
    { type: "plane", point: [0, 0, 0], normal: [0, 1, 0], material },
    { type: "box", center: [-0.6, 0.4, 0], size: [0.6, 0.8, 0.6], rotationY: 20, material },
    { type: "sphere", center: [0.5, 0.5, 0.2], radius: 0.5, material: "shiny" },
  ],
  lights: [{ type: "sphere", position: [-0.5, 1.6, 0.6], radius: 0.3, power: [40, 40, 40] }],
  environment: { radiance: [0.2, 0.2, 0.2] },
  maxBounces: 3,
};

test("path and baseline estimators agree, and so does the program with constants, seeds 1–8", async () => {
  const results = [];
  for (const settings of [
    { estimator: "path" },
    { estimator: "uniform" },
    { estimator: "path", constants: true },
  ] as const) {
    const renders = await renderSeeds(ROOM, { size: [24, 24], samples: 64, seeds: seedsFrom(1, 8), settings });
    const means = renders.map(({ image }) => image.reduce((sum, value, i) => sum + (i % 4 < 3 ? value : 0), 0));
    const mean = means.reduce((a, b) => a + b) / 8;
    const variance = means.reduce((sum, value) => sum + (value - mean) ** 2, 0) / (7 * 8);
    results.push({ mean, variance });
    expect(renders.every(({ stats }) => stats.badSamples === 0)).toBe(true);
  }
  const [path, ...others] = results;
  for (const other of others) {
    // Seven degrees of freedom each: Student's t for 14 exceeds 5 once in 5000 times.
    expect(Math.abs(path!.mean - other.mean)).toBeLessThan(
      5 * Math.sqrt(path!.variance + other.variance) + 1e-5 * path!.mean,
    );
  }
});

test("picking finds what a search in doubles finds along the parallel ray", async () => {
  const [width, height] = [12, 8];
  const tracer = await PathTracer.create({ scene: ROOM, width, height, device: await testDevice() });
  const { objects, camera } = parseScene(ROOM);
  const { forward, right, up } = cameraBasis(camera, [0, 0, 0], width / height);
  let found = 0;
  for (let y = 0.5; y < height; y++) {
    for (let x = 0.5; x < width; x++) {
      const start = add(camera.position, add(scale(right, (2 * x) / width - 1), scale(up, 1 - (2 * y) / height)));
      const [first] = meetings(objects, start, forward);
      const picked = await tracer.pick(x, y);
      if (picked?.kind === "light") continue;
      expect(picked?.index, `at ${x}, ${y}`).toBe(first?.id);
      if (!first) continue;
      found++;
      // 24 roundings of lengths up to 8, over the cosine at the surface.
      const tolerance = (24 * 2 ** -23 * 8) / first.cosine;
      expect(Math.abs(picked!.distance - first.t)).toBeLessThan(tolerance);
      expect(Math.hypot(...subtract(picked!.position, add(start, scale(forward, first.t))))).toBeLessThan(tolerance);
    }
  }
  expect(found).toBeGreaterThan(80);
  tracer.dispose();
});
