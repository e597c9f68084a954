import { afterAll, beforeAll, describe, expect, test } from "vitest";
import { create } from "webgpu";
import { SceneError } from "../../../src/errors";
import { PathTracer } from "../../../src/renderer/pathTracer";
import { SETTING_EFFECTS, type Settings } from "../../../src/renderer/settings";
import { box, sphere, sphereLight } from "../../../src/scene/builders";
import type { Camera, Scene } from "../../../src/scene/schema";
import { sceneOf } from "../../support/compiled";
import { cube, meshObject } from "../../support/meshes";

// Dawn's null backend: it validates and compiles everything and computes nothing, so there are no pictures here.
let gpu: GPU; // kept: Dawn crashes when its instance is garbage-collected
let device: GPUDevice;
const mistakes: string[] = [];

beforeAll(async () => {
  gpu = create(["backend=null"]);
  device = await (await gpu.requestAdapter())!.requestDevice();
  device.addEventListener("uncapturederror", ({ error }) => mistakes.push(error.message));
  const pop = device.popErrorScope.bind(device);
  device.popErrorScope = async () => {
    const error = await pop();
    if (error) mistakes.push(error.message);
    return error;
  };
});
afterAll(() => {
  expect(mistakes).toEqual([]);
  device.destroy();
});

const LIGHT = sphereLight({ position: [0, 3, 0], radius: 0.1, power: [1, 1, 1] });
const BALL = sceneOf([sphere({ center: [0, 0, 0], radius: 1, material: "lambert" })], [LIGHT]);
const BIGGER_BALL = sceneOf([sphere({ center: [0, 0, 0], radius: 2, material: "lambert" })], [LIGHT]);
const CRATE = sceneOf([box({ center: [0, 0, 0], size: [1, 1, 1], material: "lambert" })], [LIGHT]);
const CUBE = sceneOf([meshObject(cube(), "lambert")], [LIGHT]);
const CAMERA: Camera = { position: [7, 7, 7] };

function tracerOf(scene: Scene, settings: Partial<Settings> = {}): Promise<PathTracer> {
  return PathTracer.create({ scene, width: 16, height: 16, device, settings });
}

const kindOf = (tracer: PathTracer) => tracer.scene.objects[0]!.type;

describe("sampling", () => {
  test.each([1, 2, 5, 40])("sample(%i) takes as many", async (count) => {
    const tracer = await tracerOf(BALL);
    await tracer.sample(count);
    expect(tracer.stats.samples).toBe(count);
    await tracer.sample(3);
    expect(tracer.stats.samples).toBe(count + 3);
    tracer.dispose();
  });

  test("stops at maxSamples, and goes on when that is raised", async () => {
    const tracer = await tracerOf(BALL, { maxSamples: 5 });
    await tracer.sample(9);
    expect(tracer.stats).toMatchObject({ samples: 5, converged: true });
    tracer.update({ maxSamples: 7 });
    expect(tracer.stats.converged).toBe(false);
    await tracer.sample(9);
    expect(tracer.stats.samples).toBe(7);
    tracer.dispose();
  });
});

test("frames that are called faster than the device works do not overshoot maxSamples", async () => {
  const tracer = await tracerOf(BALL, { maxSamples: 3 });
  while (!tracer.stats.converged) {
    for (let i = 0; i < 4; i++) tracer.frame();
    await new Promise((resolve) => setTimeout(resolve));
  }
  await tracer.sample(1); // waits for what is under way
  expect(tracer.stats.samples).toBe(3);
  tracer.dispose();
});

describe("accumulation", () => {
  const restarts = async (change: (tracer: PathTracer) => unknown) => {
    const tracer = await tracerOf(BALL);
    await tracer.sample(4);
    await change(tracer);
    await tracer.sample(1);
    const { samples } = tracer.stats;
    tracer.dispose();
    return samples === 1;
  };

  test.each<[string, (tracer: PathTracer) => unknown]>([
    ["another camera", (tracer) => tracer.setCamera(CAMERA)],
    ["another size", (tracer) => tracer.resize(8, 8)],
    ["another scene", (tracer) => tracer.setScene(CRATE)],
    ["another value", (tracer) => tracer.setScene(BIGGER_BALL)],
    ["more bounces", (tracer) => tracer.update({ maxBounces: 2 })],
    ["more light samples", (tracer) => tracer.update({ lightSamples: 3 })],
    ["another seed", (tracer) => tracer.update({ seed: 2 })],
    ["another estimator", (tracer) => tracer.update({ estimator: "uniform" })],
    ["reset()", (tracer) => tracer.reset()],
  ])("restarts for %s", async (_, change) => {
    expect(await restarts(change)).toBe(true);
  });

  test.each<[string, (tracer: PathTracer) => unknown]>([
    ["the same camera", (tracer) => tracer.setCamera(BALL.camera)],
    ["the same size", (tracer) => tracer.resize(16, 16)],
    ["settings that change nothing", (tracer) => tracer.update({ seed: 1, estimator: "path" })],
    ["a target for the error", (tracer) => tracer.update({ targetError: 0.01 })],
    ["a picture that is read", (tracer) => tracer.readRadiance()],
  ])("does not restart for %s", async (_, change) => {
    expect(await restarts(change)).toBe(false);
  });
});

describe("another value of a setting", () => {
  const others: Settings = {
    maxBounces: 2,
    lightSamples: 3,
    samplesPerFrame: 4,
    estimator: "uniform",
    sampler: "independent",
    constants: false,
    seed: 2,
    targetError: 0.01,
    maxSamples: 64,
  };
  const names = Object.keys(others) as (keyof Settings)[];

  test.each(names)("%s restarts and recompiles as SETTING_EFFECTS says", async (name) => {
    const tracer = await tracerOf(BALL);
    await tracer.sample(4);
    const { program } = tracer;
    tracer.update({ [name]: others[name] });
    await tracer.sample(1);
    expect(tracer.stats.samples === 1).toBe(SETTING_EFFECTS[name] !== "none");
    expect(tracer.program === program).toBe(SETTING_EFFECTS[name] !== "recompile");
    tracer.dispose();
  });
});

describe("programs", () => {
  test("a change of a value keeps the program; another kind of object brings another", async () => {
    const tracer = await tracerOf(BALL);
    const { program } = tracer;
    await tracer.setScene(BIGGER_BALL);
    expect(tracer.program).toBe(program);
    await tracer.setScene(CRATE);
    expect(tracer.program).not.toBe(program);
    expect(tracer.stats.features).toContain("box");
    tracer.dispose();
  });

  test.each([CRATE, CUBE])(
    "settings that change meanwhile are those a scene has when setScene resolves",
    async (scene) => {
      const tracer = await tracerOf(BALL);
      const shown = tracer.setScene(scene);
      tracer.update({ lightSamples: 2 });
      await shown;
      expect(kindOf(tracer)).toBe(scene.objects[0]!.type);
      expect(tracer.stats.features).toContain("many light samples");
      tracer.dispose();
    },
  );

  test("a camera set while a scene compiles is not replaced by the scene's own", async () => {
    const tracer = await tracerOf(BALL);
    const shown = tracer.setScene(CRATE);
    tracer.setCamera(CAMERA);
    await shown;
    expect(kindOf(tracer)).toBe("box");
    expect(tracer.camera.position).toEqual(CAMERA.position);
    tracer.dispose();
  });

  test("a camera that was moved stays when settings change", async () => {
    const tracer = await tracerOf(BALL);
    tracer.setCamera(CAMERA);
    tracer.update({ estimator: "uniform" });
    await tracer.sample(1);
    expect(tracer.camera.position).toEqual(CAMERA.position);
    tracer.dispose();
  });

  test("of two scenes set at once the later one is shown, whichever compiles first", async () => {
    const tracer = await tracerOf(BALL);
    await Promise.all([tracer.setScene(CRATE), tracer.setScene(BIGGER_BALL)]);
    expect(tracer.scene.objects[0]).toMatchObject({ type: "sphere", radius: 2 });
    tracer.dispose();
  });

  test("a scene whose signal is aborted is given up, and the old one goes on", async () => {
    const tracer = await tracerOf(BALL);
    const [reason, controller] = [new Error("no longer needed"), new AbortController()];
    const shown = tracer.setScene(CRATE, { signal: controller.signal });
    const sampled = tracer.sample(1);
    controller.abort(reason);
    await expect(shown).rejects.toBe(reason);
    await sampled;
    expect(kindOf(tracer)).toBe("sphere");
    expect(tracer.stats.samples).toBe(1);
    await tracer.setScene(CRATE);
    expect(kindOf(tracer)).toBe("box");
    tracer.dispose();
  });

  test("a tracer whose signal is aborted while its geometry is sorted is not made", async () => {
    const [reason, controller] = [new Error("no longer needed"), new AbortController()];
    const made = PathTracer.create({ scene: CUBE, width: 16, height: 16, device, signal: controller.signal });
    controller.abort(reason);
    await expect(made).rejects.toBe(reason);
  });

  test("a scene that is wrong is refused and the old one stays", async () => {
    const tracer = await tracerOf(BALL);
    await expect(tracer.setScene({ ...BALL, objects: [{ type: "cone" }] } as never)).rejects.toThrow(SceneError);
    expect(() => tracer.setCamera({ position: [0, 0, Number.NaN] })).toThrow(SceneError);
    expect(kindOf(tracer)).toBe("sphere");
    await tracer.sample(1);
    tracer.dispose();
  });
});

describe("dispose", () => {
  test("may be called again, and ends the work", async () => {
    const tracer = await tracerOf(BALL);
    tracer.dispose();
    tracer.dispose();
    tracer.resize(8, 8);
    expect(tracer.frame()).toBe(false);
    await tracer.sample(4);
    expect(tracer.stats.samples).toBe(0);
  });

  test("may come while work and a compilation are under way", async () => {
    const tracer = await tracerOf(BALL);
    const sampled = tracer.sample(64);
    const shown = tracer.setScene(CRATE);
    tracer.dispose();
    await Promise.all([sampled, shown]);
  });
});
