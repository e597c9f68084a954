import { expect, test } from "vitest";
import { PathTracer } from "../../src/renderer/pathTracer";
import type { Settings } from "../../src/renderer/settings";
import { box, sphere, sphereLight } from "../../src/scene/builders";
import type { Scene } from "../../src/scene/schema";
import { testDevice } from "../support/device";
import { bumpySphere, meshObject } from "../support/meshes";

const SIZE = { width: 400, height: 300 };
const WHITE = { white: { baseColor: [1, 1, 1], ior: 1 } } as const;

/** A room that swallows no light, so that paths are as long as they may be, with a ball in it. */
function room(ball: Scene["objects"], maxBounces: number): Scene {
  const walls = box({ center: [0, 0, 0], size: [6, 6, 6], material: "white" });
  const lights = [0, 1, 2, 3].map((i) =>
    sphereLight({ position: [2 * Math.cos(i), 2, 2 * Math.sin(i)], radius: 0.1, power: [5, 5, 5] }),
  );
  return { camera: { position: [0, 0, 2.6] }, materials: WHITE, objects: [walls, ...ball!], lights, maxBounces };
}

const BALL = [sphere({ center: [0, 0, 0], radius: 1, material: "white" })];
const MESH = [meshObject(bumpySphere(100_000), "white")];

test.each<[string, Scene, Partial<Settings>]>([
  ["1024 bounces with 8 light samples", room(BALL, 1024), { lightSamples: 8 }],
  ["a mesh, 64 bounces and 16 light samples", room(MESH, 64), { lightSamples: 16 }],
  ["64 samples per frame", room(BALL, 8), { samplesPerFrame: 64 }],
])("no submit takes long for %s", async (_, scene, changes) => {
  const settings = { ...changes, constants: false };
  const tracer = await PathTracer.create({ scene, ...SIZE, settings, device: await testDevice() });
  const times: number[] = [];
  for (let frame = 0; frame < 40; frame++) {
    await finishFrame(tracer);
    times.push(tracer.stats.gpuMs);
    // The first work is bounded by its rays, whatever the adapter: some 50 ms of the slowest one.
    if (frame === 0) expect((tracer.stats.raysPerSecond * times[0]!) / 1000).toBeLessThan(200_000);
  }
  // A frame's budget is 12 ms. Single paths differ, and other tests run beside: hence the middle one, and five times as long.
  expect(median(times)).toBeLessThan(60);
  tracer.dispose();
});

test("the pace of a light scene is not taken for that of a heavy one", async () => {
  const device = await testDevice();
  const tracer = await PathTracer.create({ scene: room(BALL, 1), ...SIZE, settings: { constants: false }, device });
  const times: number[] = [];
  while (tracer.stats.samples < 2) {
    await finishFrame(tracer);
    times.push(tracer.stats.gpuMs);
  }
  tracer.update({ maxBounces: 1024 });
  await finishFrame(tracer);
  expect(tracer.stats.samples).toBe(0);
  // Its paths take some hundred times as long.
  expect(tracer.stats.gpuMs).toBeLessThan(20 * median(times));
  tracer.dispose();
});

function median(values: readonly number[]): number {
  return values.toSorted((a, b) => a - b)[values.length >> 1]!;
}

/** One frame's work, done and reported: every report changes the average rate. */
async function finishFrame(tracer: PathTracer): Promise<void> {
  const before = tracer.stats.raysPerSecond;
  expect(tracer.frame()).toBe(true);
  await expect.poll(() => tracer.stats.raysPerSecond, { timeout: 20_000, interval: 5 }).not.toBe(before);
}
