import { describe, expect, test } from "vitest";
import { PathTracer } from "../../src/renderer/pathTracer";
import type { Settings } from "../../src/renderer/settings";
import type { Scene } from "../../src/scene/schema";
import { renderScene, testDevice } from "../support/device";
import { loadReference } from "../support/reference";

const SIZE = [48, 40] as const;
const { scene: SPHERES } = loadReference("spheres");

async function createTracer(scene: Scene = SPHERES, settings: Partial<Settings> = {}): Promise<PathTracer> {
  const [width, height] = SIZE;
  return PathTracer.create({
    scene,
    width,
    height,
    // One program throughout: with constants a second one may take over, equal up to rounding.
    settings: { seed: 5, constants: false, ...settings },
    device: await testDevice(),
  });
}

describe("the same seed", () => {
  test("gives the same image bit for bit, seed 5", async () => {
    const [first, second] = [await renderSpheres(), await renderSpheres()];
    expect(first.image).toEqual(second.image);
    expect(first.stats.error).toBe(second.stats.error);
  });

  test("and another seed another image, seeds 5 and 6", async () => {
    const [first, second] = [await renderSpheres(), await renderSpheres(6)];
    const different = first.image.filter((value, i) => i % 4 < 3 && value !== second.image[i]).length;
    // Where the sky alone is seen, nothing is random: a fifth of the image.
    expect(different).toBeGreaterThan(0.5 * first.image.length * 0.75);
  });

  test.each([
    { name: "one sample at a time", steps: Array(64).fill(1) },
    { name: "in uneven steps", steps: [3, 1, 7, 20, 2, 31] },
  ])("gives the same image up to the order of sums, $name, seed 5", async ({ steps }) => {
    const whole = await renderSpheres();
    const tracer = await createTracer();
    for (const step of steps) await tracer.sample(step);
    expect(tracer.stats.samples).toBe(64);
    const image = await tracer.readRadiance();
    tracer.dispose();
    // The same 64 non-negative samples per pixel, added in another grouping: at most 64 roundings of 2⁻²³ on either side.
    expectRelativelyClose(image, whole.image, 2 * 64 * 2 ** -23);
  });

  test("gives the same image by frames as by samples, seed 5", async () => {
    const whole = await renderSpheres();
    const tracer = await createTracer(SPHERES, { maxSamples: 64, samplesPerFrame: 2 });
    await pump(tracer, () => tracer.stats.converged);
    expect(tracer.stats.samples).toBe(64);
    expectRelativelyClose(await tracer.readRadiance(), whole.image, 2 * 64 * 2 ** -23);
    tracer.dispose();
  });

  test("gives the same pixels in an image cut into many tiles, seed 5", async () => {
    // 640 × 32 pixels at 64 samples are 1.3 million paths, over ten budgets' worth on a software adapter.
    const size = [640, 32] as const;
    const [whole, other] = [
      await renderScene(SPHERES, { size, samples: 32, seed: 5, settings: { constants: false } }),
      await createTiled(size, 32),
    ];
    expectRelativelyClose(other, whole.image, 2 * 32 * 2 ** -23);
  });
});

describe("an edit", () => {
  const edits: Readonly<Record<string, (scene: Scene) => Scene>> = {
    "of a colour": (scene) => ({
      ...scene,
      materials: { ...scene.materials, gold: { ...scene.materials!.gold, baseColor: [0.2, 0.9, 0.4] } },
    }),
    "of a roughness": (scene) => ({
      ...scene,
      materials: { ...scene.materials, steel: { ...scene.materials!.steel, roughness: 0.7 } },
    }),
    "of a radius": (scene) => withObject(scene, 1, { radius: 0.4 }),
    "of a position": (scene) => withObject(scene, 2, { center: [0.3, 0.7, -0.9] }),
    "of a light's power and place": (scene) => ({
      ...scene,
      lights: [{ type: "sphere", position: [-2, 3, 1], radius: 0.2, power: [200, 300, 400] }],
    }),
    "of the surroundings": (scene) => ({ ...scene, environment: { radiance: [0.5, 0.1, 0.3] } }),
    "of the camera": (scene) => ({ ...scene, camera: { ...scene.camera, target: [0.4, 0.5, 0.1], verticalFov: 50 } }),
  };

  test.each(Object.keys(edits))("%s compiles nothing and gives the image of the edited scene, seed 5", async (name) => {
    const edited = edits[name]!(SPHERES);
    const tracer = await createTracer();
    await tracer.sample(4);
    const { program } = tracer;
    await tracer.setScene(edited);
    expect(tracer.program).toBe(program);
    await tracer.sample(16);
    expect(tracer.stats.samples).toBe(16);
    const image = await tracer.readRadiance();
    tracer.dispose();

    const fresh = await createTracer(edited);
    expect(fresh.program.wgsl).toBe(program.wgsl);
    await fresh.sample(16);
    expect(image).toEqual(await fresh.readRadiance());
    fresh.dispose();
  });

  test("that adds a mirror compiles another program and gives its image, seed 5", async () => {
    const edited: Scene = {
      ...SPHERES,
      materials: { ...SPHERES.materials, steel: { ...SPHERES.materials!.steel, roughness: 0 } },
    };
    const tracer = await createTracer();
    await tracer.sample(4);
    const { program } = tracer;
    await tracer.setScene(edited);
    expect(tracer.program).not.toBe(program);
    expect(tracer.program.wgsl).not.toBe(program.wgsl);
    expect(tracer.stats.features).toContain("mirror");
    await tracer.sample(16);
    const image = await tracer.readRadiance();
    tracer.dispose();

    const fresh = await createTracer(edited);
    await fresh.sample(16);
    expect(image).toEqual(await fresh.readRadiance());
    fresh.dispose();
  });

  test("to a faulty scene throws and leaves the old one", async () => {
    const tracer = await createTracer();
    await tracer.sample(4);
    await expect(tracer.setScene(withObject(SPHERES, 1, { radius: -1 }))).rejects.toThrow("objects[1].radius");
    await tracer.sample(4);
    expect(tracer.stats.samples).toBe(8);
    tracer.dispose();
  });
});

describe("accumulation", () => {
  const changes: Readonly<Record<string, (tracer: PathTracer) => void>> = {
    "a camera": (tracer) => tracer.setCamera({ ...tracer.camera, verticalFov: 30 }),
    bounces: (tracer) => tracer.update({ maxBounces: 2 }),
    "light samples": (tracer) => tracer.update({ lightSamples: 2 }),
    "a seed": (tracer) => tracer.update({ seed: 99 }),
    "an estimator": (tracer) => tracer.update({ estimator: "uniform" }),
    "a sampler": (tracer) => tracer.update({ sampler: "independent" }),
    "a size": (tracer) => tracer.resize(SIZE[0] + 8, SIZE[1]),
    "the caller's wish": (tracer) => tracer.reset(),
  };

  test.each(Object.keys(changes))("restarts with %s", async (name) => {
    const tracer = await createTracer();
    await tracer.sample(8);
    changes[name]!(tracer);
    await tracer.sample(4);
    expect(tracer.stats.samples).toBe(4);
    tracer.dispose();
  });

  const trifles: Readonly<Record<string, (tracer: PathTracer) => void | Promise<void>>> = {
    "an equal camera": (tracer) => tracer.setCamera(structuredClone(SPHERES.camera)),
    "samples per frame, a target error and a limit": (tracer) =>
      tracer.update({ samplesPerFrame: 4, targetError: 1e-9, maxSamples: 1000 }),
    "settings as they are": (tracer) => tracer.update({ ...tracer.settings }),
    "the same size": (tracer) => tracer.resize(...SIZE),
  };

  test.each(Object.keys(trifles))("goes on with %s", async (name) => {
    const tracer = await createTracer();
    await tracer.sample(8);
    await trifles[name]!(tracer);
    await tracer.sample(4);
    expect(tracer.stats.samples).toBe(12);
    tracer.dispose();
  });

  test("stops at maxSamples, and goes on when it is raised", async () => {
    const tracer = await createTracer(SPHERES, { maxSamples: 10 });
    await tracer.sample(64);
    expect(tracer.stats.samples).toBe(10);
    expect(tracer.stats.converged).toBe(true);
    expect(tracer.frame()).toBe(false);
    tracer.update({ maxSamples: 20 });
    expect(tracer.stats.converged).toBe(false);
    await tracer.sample(64);
    expect(tracer.stats.samples).toBe(20);
    tracer.dispose();
  });

  test("counts every sample once, in whatever portions they are asked for", async () => {
    const tracer = await createTracer(SPHERES, {});
    let total = 0;
    for (const count of [1, 2, 1, 5, 8, 1, 16, 3, 40, 1, 2, 7]) {
      await tracer.sample(count);
      total += count;
      expect(tracer.stats.samples).toBe(total);
    }
    tracer.dispose();
  });

  test("stops at targetError, within twice the samples that are enough, seed 5", async () => {
    const patient = await createTracer(SPHERES);
    do await patient.sample(1);
    while (patient.stats.error > 0.1);
    const { samples: enough } = patient.stats;
    patient.dispose();

    const tracer = await createTracer(SPHERES, { targetError: 0.1 });
    await tracer.sample(4096);
    expect(tracer.stats.converged).toBe(true);
    expect(tracer.stats.error).toBeLessThanOrEqual(0.1);
    expect(tracer.stats.error).toBeGreaterThan(0);
    expect(tracer.stats.samples).toBeGreaterThanOrEqual(enough);
    expect(tracer.stats.samples).toBeLessThanOrEqual(2 * enough);
    tracer.dispose();
  });
});

describe("live settings", () => {
  test.each([1, 2, 4])("%d light samples leave the mean as it is, seed 5", async (lightSamples) => {
    // Against the same scene with one light sample and another seed; errors as the renders tell them.
    const [width, height] = SIZE;
    const one = await renderScene(SPHERES, { size: SIZE, samples: 256, seed: 77 });
    const tracer = await createTracer();
    await tracer.sample(2);
    tracer.update({ lightSamples });
    await tracer.sample(256);
    const image = await tracer.readRadiance();
    // `error` is the RMSE of a value over the mean; pixels are independent, channels are not: n pixels.
    const sigma = Math.hypot(tracer.stats.error, one.stats.error) / Math.sqrt(width * height);
    tracer.dispose();
    expect(Math.abs(meanOf(image) / meanOf(one.image) - 1)).toBeLessThan(4 * sigma);
  });

  test("maxBounces gives what a scene with as many says, seed 5", async () => {
    const tracer = await createTracer();
    tracer.update({ maxBounces: 2 });
    await tracer.sample(16);
    const image = await tracer.readRadiance();
    tracer.dispose();
    const fresh = await createTracer({ ...SPHERES, maxBounces: 2 });
    await fresh.sample(16);
    expect(image).toEqual(await fresh.readRadiance());
    fresh.dispose();
  });
});

describe("dispose", () => {
  test("can be called again, and leaves the device to others", async () => {
    const tracer = await createTracer();
    await tracer.sample(2);
    tracer.dispose();
    tracer.dispose();
    expect(tracer.frame()).toBe(false);
    const next = await createTracer();
    await next.sample(2);
    expect(next.stats.samples).toBe(2);
    next.dispose();
  });

  test("while it renders fails nothing", async () => {
    const tracer = await createTracer();
    const sampling = tracer.sample(1024);
    tracer.dispose();
    await sampling;
    expect(tracer.stats.samples).toBeLessThan(1024);
  });
});

function renderSpheres(seed = 5) {
  return renderScene(SPHERES, { size: SIZE, samples: 64, seed, settings: { constants: false } });
}

/** Renders by frames, whose budget of some milliseconds cuts each pass into slices. */
async function createTiled([width, height]: readonly [number, number], samples: number): Promise<Float32Array> {
  const settings = { seed: 5, maxSamples: samples, samplesPerFrame: 16, constants: false };
  const tracer = await PathTracer.create({ scene: SPHERES, width, height, settings, device: await testDevice() });
  await pump(tracer, () => tracer.stats.converged);
  const image = await tracer.readRadiance();
  tracer.dispose();
  return image;
}

/** What a page does each animation frame, until `isDone`. */
async function pump(tracer: PathTracer, isDone: () => boolean): Promise<void> {
  while (!isDone()) {
    tracer.frame();
    await new Promise((resolve) => setTimeout(resolve, 1));
  }
}

function withObject(scene: Scene, index: number, change: object): Scene {
  return { ...scene, objects: scene.objects.map((object, i) => (i === index ? { ...object, ...change } : object)) };
}

function expectRelativelyClose(image: Float32Array, expected: Float32Array, tolerance: number): void {
  expect(image.length).toBe(expected.length);
  const off = image.filter((value, i) => Math.abs(value - expected[i]!) > tolerance * expected[i]!).length;
  expect(off, `values off by more than ${tolerance}`).toBe(0);
}

function meanOf(image: Float32Array): number {
  let sum = 0;
  for (let i = 0; i < image.length; i++) if (i % 4 < 3) sum += image[i]!;
  return sum / (0.75 * image.length);
}
