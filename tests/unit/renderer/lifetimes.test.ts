import { afterAll, beforeAll, beforeEach, describe, expect, test } from "vitest";
import { create } from "webgpu";
import { RtViewerError, UnsupportedError, WebGpuError } from "../../../src/errors";
import { PathTracer } from "../../../src/renderer/pathTracer";
import { box, sphere, sphereLight } from "../../../src/scene/builders";
import type { Scene } from "../../../src/scene/schema";
import { sceneOf } from "../../support/compiled";
import { cube, meshObject } from "../../support/meshes";

// Dawn's null backend: it validates and compiles everything and computes nothing, so there are no pictures here.
let gpu: GPU; // kept: Dawn crashes when its instance is garbage-collected
let device: GPUDevice;
/** What reaches the page, as far as it is not in a scope of a tracer. */
const uncaptured: string[] = [];
/** What tracers were told about their own work. */
const captured: string[] = [];

async function newDevice(): Promise<GPUDevice> {
  const opened = await (await gpu.requestAdapter())!.requestDevice();
  opened.addEventListener("uncapturederror", ({ error }) => uncaptured.push(error.message));
  const pop = opened.popErrorScope.bind(opened);
  opened.popErrorScope = async () => {
    const error = await pop();
    if (error) captured.push(error.message);
    return error;
  };
  return opened;
}

beforeAll(async () => {
  gpu = create(["backend=null"]);
  device = await newDevice();
});
beforeEach(() => {
  uncaptured.length = captured.length = 0;
});
afterAll(() => device.destroy());

const LIGHT = sphereLight({ position: [0, 3, 0], radius: 0.1, power: [1, 1, 1] });
const BALL = sceneOf([sphere({ center: [0, 0, 0], radius: 1, material: "lambert" })], [LIGHT]);
const CRATE = sceneOf([box({ center: [0, 0, 0], size: [1, 1, 1], material: "lambert" })], [LIGHT]);
const CUBE = sceneOf([meshObject(cube(), "lambert")], [LIGHT]);
/** In textures, and in a buffer. */
const SMOOTH_CUBE = sceneOf([meshObject({ ...cube(), normals: cube().positions }, "lambert")], [LIGHT]);

function tracerOn(on: GPUDevice, scene: Scene = BALL): Promise<PathTracer> {
  return PathTracer.create({ scene, width: 16, height: 16, device: on });
}

/** Makes the device refuse a buffer of that label from now on; call what it gives to end that. */
function breakBuffers(on: GPUDevice, broken: string): () => void {
  const { createBuffer } = on;
  on.createBuffer = (descriptor) =>
    createBuffer.call(on, descriptor.label === broken ? { ...descriptor, usage: 0 } : descriptor);
  return () => {
    on.createBuffer = createBuffer;
  };
}

/** Buffers and textures that are made from now on and not destroyed yet, by label. */
function liveObjects(on: GPUDevice): () => string[] {
  const live = new Set<GPUBuffer | GPUTexture>();
  const watch = <T extends GPUBuffer | GPUTexture>(object: T): T => {
    const { destroy } = object;
    live.add(object);
    object.destroy = () => {
      live.delete(object);
      return destroy.call(object);
    };
    return object;
  };
  const [createBuffer, createTexture] = [on.createBuffer.bind(on), on.createTexture.bind(on)];
  on.createBuffer = (descriptor) => watch(createBuffer(descriptor));
  on.createTexture = (descriptor) => watch(createTexture(descriptor));
  return () => [...live].map(({ label }) => label);
}

describe("errors of the GPU", () => {
  test("one tracer's error ends that tracer, with its own message, and not its neighbour", async () => {
    const [own, neighbour] = [await tracerOn(device), await tracerOn(device)];
    const mend = breakBuffers(device, "film");
    own.resize(8, 8);
    mend();
    await expect(own.sample(2)).rejects.toThrow(/usages must not be 0/);
    expect(() => own.frame()).toThrow(WebGpuError);
    await neighbour.sample(4);
    expect(neighbour.stats.samples).toBe(4);
    expect(uncaptured).toEqual([]);
    own.dispose();
    neighbour.dispose();
  });

  test("a page's own error on a device it lent stays the page's", async () => {
    const tracer = await tracerOn(device);
    device.createBuffer({ label: "the page's", size: 16, usage: 0 });
    await tracer.sample(4);
    expect(tracer.stats.samples).toBe(4);
    expect(uncaptured).toHaveLength(1);
    expect(captured).toEqual([]);
    tracer.dispose();
  });

  test.each(["film", "counters", "scene", "readback", "error uniforms", "normals"])(
    "a tracer whose %s cannot be made is not made, and gives back the rest",
    async (label) => {
      const on = await newDevice();
      const live = liveObjects(on);
      breakBuffers(on, label);
      await expect(tracerOn(on, SMOOTH_CUBE)).rejects.toThrow(/usages must not be 0/);
      expect(live()).toEqual([]);
      expect(uncaptured).toEqual([]);
      on.destroy();
    },
  );

  test("a scene whose geometry finds no room is refused, and the old one stays", async () => {
    const on = await newDevice();
    const tracer = await tracerOn(on, BALL);
    const live = liveObjects(on);
    const { createBuffer } = on;
    on.createBuffer = (descriptor) => {
      if (descriptor.mappedAtCreation) throw new RangeError("no memory");
      return createBuffer.call(on, descriptor);
    };
    await expect(tracer.setScene(SMOOTH_CUBE)).rejects.toThrow(/there is no memory for the scene's geometry/);
    expect(live()).toEqual([]);
    expect(tracer.scene.objects[0]!.type).toBe("sphere");
    await tracer.sample(4);
    expect(tracer.stats.samples).toBe(4);
    expect([...captured, ...uncaptured]).toEqual([]);
    tracer.dispose();
    on.destroy();
  });
});

describe("what is read while things change", () => {
  const reads: Readonly<Record<string, (tracer: PathTracer) => Promise<unknown>>> = {
    readRadiance: (tracer) => tracer.readRadiance(),
    readPicture: (tracer) => tracer.readPicture(),
    pick: (tracer) => tracer.pick(8, 8),
  };
  const changes: Readonly<Record<string, (tracer: PathTracer) => unknown>> = {
    "a new size": (tracer) => tracer.resize(9, 7),
    "a reset": (tracer) => {
      tracer.reset();
      tracer.frame();
    },
    "a scene of another geometry": (tracer) => tracer.setScene(BALL),
    "a scene of another program": (tracer) => tracer.setScene(CRATE),
    "dispose()": (tracer) => tracer.dispose(),
  };
  const cases = Object.keys(reads).flatMap((read) => Object.keys(changes).map((change) => [read, change] as const));

  test.each(cases)("%s outlives %s", async (read, change) => {
    const on = await newDevice();
    const live = liveObjects(on);
    const tracer = await tracerOn(on, CUBE);
    await tracer.sample(2);
    const { length } = await tracer.readRadiance();
    const reading = reads[read]!(tracer);
    const changing = changes[change]!(tracer);
    const value = await reading;
    if (read !== "pick") expect(value).toHaveLength(length); // of the size it had
    await changing;
    tracer.dispose();
    expect(live()).toEqual([]);
    expect([...captured, ...uncaptured]).toEqual([]);
    on.destroy();
  });

  test.each(Object.keys(reads))(
    "%s tells the device's loss as an error of ours, meanwhile and before",
    async (read) => {
      const on = await newDevice();
      const tracer = await tracerOn(on, CUBE);
      await tracer.sample(2);
      const reading = reads[read]!(tracer);
      on.destroy();
      await expect(reading).rejects.toThrow(WebGpuError);
      await expect(reads[read]!(tracer)).rejects.toThrow(/^The GPU device was lost/);
      tracer.dispose();
      expect(uncaptured).toEqual([]);
    },
  );

  test("after dispose() there is nothing to read, and nothing is made any more", async () => {
    const tracer = await tracerOn(device, BALL);
    tracer.dispose();
    await expect(tracer.readRadiance()).rejects.toThrow(RtViewerError);
    await expect(tracer.readPicture()).rejects.toThrow(RtViewerError);
    const live = liveObjects(device);
    tracer.resize(8, 8);
    tracer.reset();
    tracer.update({ lightSamples: 4 });
    await tracer.setScene(CRATE);
    await tracer.setScene(CUBE);
    await tracer.compile();
    await tracer.sample(1);
    tracer.dispose();
    expect(live()).toEqual([]);
    expect([...captured, ...uncaptured]).toEqual([]);
  });
});

test("sample() after dispose() while a scene was compiled does not hang the page", async () => {
  const tracer = await tracerOn(device);
  const shown = tracer.setScene(CRATE);
  tracer.dispose();
  await tracer.sample(1);
  await shown;
  expect(tracer.stats.samples).toBe(0);
});

describe("a picture too large for the device", () => {
  const SIDE = 40_000; // 51 GB of film
  test("is refused when the tracer is made, with the limit and the need", async () => {
    const made = PathTracer.create({ scene: BALL, width: SIDE, height: SIDE, device });
    await expect(made).rejects.toThrow(UnsupportedError);
    await expect(made).rejects.toThrow(/max\w+Size is \d+ MiB; a picture of 40000 × 40000 pixels needs \d+ MiB/);
  });

  test("is refused when it is resized, and the old one goes on", async () => {
    const tracer = await tracerOn(device);
    expect(() => tracer.resize(SIDE, SIDE)).toThrow(UnsupportedError);
    expect(tracer.width).toBe(16);
    await tracer.sample(4);
    expect(tracer.stats.samples).toBe(4);
    tracer.dispose();
    expect([...captured, ...uncaptured]).toEqual([]);
  });

  test("is refused where only a texture of it would be", async () => {
    const width = device.limits.maxTextureDimension2D + 1;
    const tracer = await PathTracer.create({ scene: BALL, width, height: 2, device });
    await tracer.sample(1);
    expect(await tracer.readRadiance()).toHaveLength(8 * width);
    await expect(tracer.readPicture()).rejects.toThrow(`maxTextureDimension2D is ${width - 1}`);
    tracer.dispose();
    expect([...captured, ...uncaptured]).toEqual([]);
  });

  test.each([0, -1, 1.5, Number.NaN, Number.POSITIVE_INFINITY])("a side of %d is no size", async (side) => {
    const tracer = await tracerOn(device);
    expect(() => tracer.resize(side, 8)).toThrow(/whole pixels, at least 1 × 1, got/);
    await expect(PathTracer.create({ scene: BALL, width: 8, height: side, device })).rejects.toThrow(RtViewerError);
    tracer.dispose();
    expect([...captured, ...uncaptured]).toEqual([]);
  });
});
