import { describe, expect, test } from "vitest";
import { PathTracer } from "../../src/renderer/pathTracer";
import type { Camera, Scene, SceneObject } from "../../src/scene/schema";
import { type RenderOptions, renderScene, renderSeeds, seedsFrom, testDevice } from "../support/device";

const SIZE = 64;
const FOV = (2 * Math.atan(0.5) * 180) / Math.PI; // half the picture is 0.5 high at a distance of 1
const material = "m";
const square = { size: [SIZE, SIZE], samples: 64 } as const;

/** Nothing but a small lamp on the axis, `depth` from the camera. */
function lampScene(camera: Omit<Camera, "position" | "target">, depth: number, radius: number): Scene {
  return {
    camera: { position: [0, 0, 0], target: [0, 0, -1], ...camera },
    objects: [],
    lights: [
      {
        type: "sphere",
        position: [0, 0, -depth],
        radius,
        power: [1, 1, 1].map((c) => c * 4 * Math.PI ** 2 * radius ** 2) as never,
      },
    ],
    maxBounces: 0,
  };
}

/** Of what a picture shows around its middle: all of it, the mean square of its distance, and how much lies within `radius`. */
function spot(image: Float32Array, radius: number) {
  let [sum, square, inner, reach] = [0, 0, 0, 0];
  for (let i = 0; i < SIZE * SIZE; i++) {
    const distance = Math.hypot((i % SIZE) + 0.5 - SIZE / 2, Math.floor(i / SIZE) + 0.5 - SIZE / 2);
    const light = image[4 * i]!;
    sum += light;
    square += light * distance ** 2;
    if (distance < radius) inner += light;
    if (light > 0) reach = Math.max(reach, distance);
  }
  return { sum, meanSquare: square / sum, innerShare: inner / sum, reach };
}

function meanAndError(values: readonly number[]) {
  const mean = values.reduce((a, b) => a + b) / values.length;
  const squares = values.reduce((sum, value) => sum + (value - mean) ** 2, 0);
  return { mean, error: Math.sqrt(squares / (values.length * (values.length - 1))) };
}

// Eight seeds have seven degrees of freedom: Student's t exceeds 7.1 once in 5000 times.
const SIGMAS = 7.1;
const SEEDS = seedsFrom(1, 8);

describe("a point out of focus is a disk of the radius of the lens · |1 − focus/depth|, projected, seeds 1–8:", () => {
  test.each<[string, number, number, number, Camera["orthographicHeight"]?]>([
    ["nearer than the plane of focus", 0.05, 1, 0.5],
    ["farther", 0.05, 1, 4],
    ["with the plane of focus in front of where the scene begins", 0.02, 0.1, 5],
    ["kilometres away, a lens of 400 m", 400, 5000, 2000],
    ["through a millimetre of lens", 1e-3, 0.005, 0.3],
    ["orthographic, nearer", 0.4, 2, 1, 2],
    ["orthographic, farther", 0.1, 2, 8, 2],
  ])("%s", async (_, aperture, focusDistance, depth, orthographicHeight) => {
    const confusion = orthographicHeight
      ? (aperture * Math.abs(1 - depth / focusDistance)) / (orthographicHeight / 2)
      : (aperture * Math.abs(1 / depth - 1 / focusDistance)) / 0.5;
    const radius = confusion * (SIZE / 2); // in pixels
    expect(radius).toBeGreaterThan(2);
    const lampPixels = radius / 8;
    const lamp = (lampPixels / (SIZE / 2)) * (orthographicHeight ? orthographicHeight / 2 : 0.5 * depth);
    const camera = { verticalFov: FOV, aperture, focusDistance, ...(orthographicHeight && { orthographicHeight }) };
    for (const estimator of ["path", "uniform"] as const) {
      const options = { size: [SIZE, SIZE], samples: 64, seeds: SEEDS, settings: { estimator } } as const;
      const renders = await renderSeeds(lampScene(camera, depth, lamp), options);
      const spots = renders.map(({ image }) => spot(image, radius / 2));
      const of = (key: keyof (typeof spots)[number]) => meanAndError(spots.map((each) => each[key]));
      // A ball is seen a little larger than its disk, and from the edge of the lens at an angle: both are below (lamp / depth)² and the
      // square of the lens over the depth, which stay below 0.02 here.
      const share = 0.02;
      const sum = of("sum");
      expect(Math.abs(sum.mean - Math.PI * lampPixels ** 2)).toBeLessThan(SIGMAS * sum.error + share * sum.mean);
      // Of a uniform disk the mean square is half its radius'; that of the lamp adds to it, and of a pixel's two sides a twelfth each.
      const square = of("meanSquare");
      const expected = radius ** 2 / 2 + lampPixels ** 2 / 2 + 1 / 6;
      expect(Math.abs(square.mean - expected)).toBeLessThan(SIGMAS * square.error + 2 * share * expected);
      for (const { reach } of spots) {
        expect(reach).toBeLessThan((1 + share) * (radius + lampPixels) + Math.SQRT1_2);
        expect(reach).toBeGreaterThan(0.9 * radius - Math.SQRT1_2);
      }
    }
  });
});

/** Glowing squares across the view, of different sizes and colours, all at this depth, before a dim sky. */
function targets(camera: Omit<Camera, "position" | "target">, depth: number): Scene {
  const tiles = Array.from({ length: 12 }, (_, i): SceneObject => {
    const [x, y] = [((i % 4) - 1.8) * 0.21 * depth, (Math.floor(i / 4) - 1.2) * 0.27 * depth];
    const side = (0.05 + 0.01 * i) * depth;
    return { type: "quad", corner: [x, y, -depth], edge1: [side, 0, 0], edge2: [0, side, 0], material: `m${i % 3}` };
  });
  const glow = (r: number, g: number, b: number) => ({ baseColor: [0, 0, 0], ior: 1, emission: [r, g, b] }) as const;
  return {
    camera: { position: [0, 0, 0], target: [0, 0, -1], verticalFov: FOV, ...camera },
    materials: { m0: glow(1, 2, 3), m1: glow(3, 1, 0), m2: glow(0, 1, 1) },
    objects: tiles,
    environment: { radiance: [0.1, 0.1, 0.1] },
    maxBounces: 0,
  };
}

describe("the plane of focus is as sharp as through a pinhole, seed 1:", () => {
  test.each<[string, number, number, object?]>([
    ["a lens of a tenth of the distance", 0.3, 3],
    ["a lens of three times the distance", 10, 3],
    ["a kilometre away", 5, 1000],
    ["a micrometre of lens", 1e-6, 3],
    ["orthographic", 0.5, 3, { orthographicHeight: 3 }],
  ])("%s", async (_, aperture, depth, more = {}) => {
    const sharp = await renderScene(targets(more, depth), square);
    const lens = await renderScene(targets({ ...more, aperture, focusDistance: depth }, depth), square);
    expect(lens.stats.badSamples).toBe(0);
    let different = 0;
    sharp.image.forEach((value, i) => {
      if (Math.abs(value - lens.image[i]!) > 1e-5) different++;
    });
    // The same points of the pixels meet the same points of the plane: of the samples on 900 pixels of edges, 64 each or in the window
    // of emitters 512, a few are on the other side by rounding.
    expect(different / sharp.image.length).toBeLessThan(0.01);
    const error = sharp.image.reduce((sum, value, i) => sum + Math.abs(value - lens.image[i]!), 0) / sharp.image.length;
    expect(error).toBeLessThan(1e-4);
  });

  test("and what is before or behind it is not", async () => {
    const sharp = await renderScene(targets({}, 3), square);
    const blurred = await renderScene(targets({ aperture: 0.3, focusDistance: 2 }, 3), square);
    const error = sharp.image.reduce((sum, value, i) => sum + Math.abs(value - blurred.image[i]!), 0) / (4 * SIZE ** 2);
    expect(error).toBeGreaterThan(0.05);
  });
});

const ROOM: Scene = {
  camera: { position: [0, 0.9, 3], target: [0, 0.5, 0], verticalFov: 40 },
  materials: { m: { baseColor: [0.7, 0.6, 0.5] }, shiny: { metallic: 1, roughness: 0.3 } },
  objects: [
    { type: "plane", point: [0, 0, 0], normal: [0, 1, 0], material },
    { type: "box", center: [-0.6, 0.4, 0], size: [0.6, 0.8, 0.6], rotationY: 20, material },
    { type: "sphere", center: [0.5, 0.5, 0.8], radius: 0.5, material: "shiny" },
  ],
  lights: [{ type: "sphere", position: [-0.5, 1.6, -0.6], radius: 0.3, power: [40, 40, 40] }],
  environment: { radiance: [0.2, 0.2, 0.2] },
  maxBounces: 3,
};
const through = (lens: Partial<Camera>): Scene => ({ ...ROOM, camera: { ...ROOM.camera, ...lens } });

describe("path and baseline estimators agree, and so does the program with constants, seeds 1–8:", () => {
  test.each<[string, Partial<Camera>]>([
    ["a lens of 0.2", { aperture: 0.2 }],
    ["a lens of 10, that reaches below the floor", { aperture: 10 }],
    ["focus before the near plane", { aperture: 0.1, focusDistance: 0.2 }],
    ["orthographic", { aperture: 0.2, orthographicHeight: 2.5 }],
  ])("%s", async (_, lens) => {
    const results = [];
    for (const settings of [{}, { estimator: "uniform" }, { constants: true }] as const) {
      const renders = await renderSeeds(through(lens), { size: [24, 24], samples: 64, seeds: SEEDS, settings });
      expect(renders.every(({ stats }) => stats.badSamples === 0)).toBe(true);
      results.push(meanAndError(renders.map(({ image }) => image.reduce((sum, value) => sum + value, 0))));
    }
    const [path, ...others] = results;
    for (const other of others) {
      // 14 degrees of freedom: Student's t exceeds 5 once in 5000 times.
      expect(Math.abs(path!.mean - other.mean)).toBeLessThan(
        5 * Math.hypot(path!.error, other.error) + 1e-5 * path!.mean,
      );
    }
  });
});

test.each([false, true])("a floor shades what rays from below it see; constants: %s", async (constants) => {
  // The middle of the lens is above the floor, half of it below; there is a ball, which no light reaches.
  const scene: Scene = {
    camera: { position: [0, 0.1, 5], target: [0, 0.1, 0], aperture: 1, focusDistance: 5, verticalFov: 40 },
    materials: { m: { ior: 1 }, black: { baseColor: [0, 0, 0], ior: 1 } },
    objects: [
      { type: "plane", point: [0, 0, 0], normal: [0, 1, 0], material: "black" },
      { type: "sphere", center: [0, -1, 0], radius: 1, material },
    ],
    lights: [{ type: "point", position: [0, 3, 3], power: [100, 100, 100] }],
    maxBounces: 1,
  };
  const { image } = await renderScene(scene, { ...square, settings: { constants } });
  expect(image.every((value, i) => value === (i % 4 === 3 ? 1 : 0))).toBe(true);
});

describe("the program", () => {
  const options = { width: 16, height: 16, settings: { constants: false } } as const;
  const create = async (scene: Scene) => PathTracer.create({ scene, ...options, device: await testDevice() });
  const pictureOf = async (tracer: PathTracer) => {
    await tracer.sample(4);
    return tracer.readRadiance();
  };
  const fresh = async (scene: Scene, settings: RenderOptions["settings"] = options.settings) =>
    (await renderScene(scene, { size: [16, 16], samples: 4, settings })).image;

  test("stays when aperture, focus or height of an open lens change, and scenes shown through it", async () => {
    const tracer = await create(through({ aperture: 0.1 }));
    const device = await testDevice();
    const modules: unknown[] = [];
    const createShaderModule = device.createShaderModule.bind(device);
    device.createShaderModule = (descriptor) => {
      modules.push(descriptor);
      return createShaderModule(descriptor);
    };
    for (const lens of [
      { aperture: 1e-6 },
      { aperture: 10, focusDistance: 3 },
      { aperture: 0.3, orthographicHeight: 2 },
    ]) {
      const { camera } = through(lens);
      tracer.setCamera(camera);
      expect(await pictureOf(tracer)).toEqual(await fresh(through(lens)).finally(() => modules.splice(0)));
      await tracer.setScene(ROOM, { camera });
      expect(tracer.camera.aperture).toBe(lens.aperture);
      await tracer.sample(1);
    }
    expect(modules).toEqual([]);
    device.createShaderModule = createShaderModule;
    tracer.dispose();
  });

  test("follows when a lens is opened or closed, with the picture of a tracer made for it, bit for bit", async () => {
    const tracer = await create(ROOM);
    expect(tracer.program.features).not.toContain("lens");
    const pinhole = await pictureOf(tracer);
    expect(pinhole).toEqual(await fresh(through({ aperture: 0, focusDistance: 2 })));
    tracer.setCamera(through({ aperture: 0.2 }).camera);
    expect(await pictureOf(tracer)).toEqual(await fresh(through({ aperture: 0.2 })));
    expect(tracer.program.features).toContain("lens");
    tracer.setCamera(ROOM.camera);
    expect(await pictureOf(tracer)).toEqual(pinhole);
    expect(tracer.program.features).not.toContain("lens");
    // Opened and closed again before the first program is there.
    tracer.setCamera(through({ aperture: 0.2 }).camera);
    tracer.setCamera(ROOM.camera);
    expect(await pictureOf(tracer)).toEqual(pinhole);
    tracer.dispose();
  });

  test("is made for the camera that a scene is first shown from", async () => {
    const { camera } = through({ aperture: 0.2 });
    const tracer = await PathTracer.create({ scene: ROOM, camera, ...options, device: await testDevice() });
    expect(tracer.program.features).toContain("lens");
    expect(await pictureOf(tracer)).toEqual(await fresh(through({ aperture: 0.2 })));
    tracer.dispose();
  });
});

test("picking aims through the middle of the lens", async () => {
  const pick = async (scene: Scene) => {
    const tracer = await PathTracer.create({ scene, width: 16, height: 16, device: await testDevice() });
    const picked = [];
    for (const [x, y] of [
      [4.5, 9],
      [8, 8],
      [12, 7.5],
      [8, 2],
      [3, 15],
    ] as const)
      picked.push(await tracer.pick(x, y));
    tracer.dispose();
    return picked;
  };
  const sharp = await pick(ROOM);
  expect(sharp.filter((each) => each !== undefined).length).toBeGreaterThan(3);
  expect(await pick(through({ aperture: 3, focusDistance: 0.5 }))).toEqual(sharp);
});
