import { expect, test } from "vitest";
import { PathTracer } from "../../src/renderer/pathTracer";
import { testDevice } from "../support/device";
import { loadReference } from "../support/reference";

// Before anything is measured a frame takes 8192 paths: a quarter of this image.
const [WIDTH, HEIGHT] = [256, 128];

test("a camera that moves during the first pass leaves that pass in one piece, seed 1", async () => {
  const { scene } = loadReference("cornell");
  const settings = { constants: false, samplesPerFrame: 1 } as const;
  const options = { scene, width: WIDTH, height: HEIGHT, device: await testDevice(), settings };
  const still = await PathTracer.create(options);
  await still.sample(1);
  const seen = await still.readRadiance();

  const moved = await PathTracer.create(options);
  let frames = 0;
  const moveOn = () => moved.setCamera({ ...scene.camera, position: [0.5, 0.5, 3 + ++frames / 10] });
  while (moved.stats.samples === 0) {
    await finishFrame(moved);
    moveOn();
  }
  expect(frames).toBeGreaterThan(1);
  expect(await moved.readRadiance()).toEqual(seen);

  // And then it follows.
  await finishFrame(moved);
  while (moved.stats.samples === 0) await finishFrame(moved);
  expect(await moved.readRadiance()).not.toEqual(seen);
  still.dispose();
  moved.dispose();
});

/** One frame's work, done and reported: every report changes the average rate, though GPU times come in steps and may repeat. */
async function finishFrame(tracer: PathTracer): Promise<void> {
  const before = tracer.stats.raysPerSecond;
  expect(tracer.frame()).toBe(true);
  await expect.poll(() => tracer.stats.raysPerSecond, { timeout: 10_000 }).not.toBe(before);
}
