import { afterAll, expect } from "vitest";
import { requestDawnDevice } from "../../src/cli/dawn";
import { PathTracer } from "../../src/renderer/pathTracer";
import type { Settings } from "../../src/renderer/settings";
import type { Stats } from "../../src/renderer/stats";
import type { Scene } from "../../src/scene/schema";

// One per test file: Vitest loads this module anew for each.
let device: Promise<GPUDevice> | undefined;
const deviceErrors: string[] = [];

/** The file's device. Destroyed after its last test; an error that the device reported fails the file. */
export function testDevice(): Promise<GPUDevice> {
  device ??= requestDawnDevice().then((opened) => {
    opened.addEventListener("uncapturederror", ({ error }) => deviceErrors.push(error.message));
    // Those that a tracer is told of too: it may be disposed of before it throws them.
    const pop = opened.popErrorScope.bind(opened);
    opened.popErrorScope = async () => {
      const error = await pop();
      if (error) deviceErrors.push(error.message);
      return error;
    };
    return opened;
  });
  return device;
}

afterAll(async () => {
  if (!device) return;
  const opened = await device;
  await opened.queue.onSubmittedWorkDone();
  opened.destroy();
  expect(deviceErrors, "errors of the device that no test caught").toEqual([]);
});

export type RenderOptions = {
  /** Width and height in pixels. */
  readonly size: readonly [number, number];
  /** Per pixel. */
  readonly samples: number;
  readonly seed?: number;
  /** With `constants: true` the program with constants is used from the first sample on. */
  readonly settings?: Partial<Settings>;
};

export type Render = {
  /** RGBA, linear, top row first. */
  readonly image: Float32Array;
  readonly stats: Readonly<Stats>;
};

/** Renders a scene once. */
export async function renderScene(scene: Scene, { seed = 1, ...options }: RenderOptions): Promise<Render> {
  const [render] = await renderSeeds(scene, { ...options, seeds: [seed] });
  return render!;
}

/** Renders a scene once per seed, all with the same program: independent images of the same expectation. */
export async function renderSeeds(
  scene: Scene,
  { size: [width, height], samples, seeds, settings = {} }: Omit<RenderOptions, "seed"> & { seeds: readonly number[] },
): Promise<Render[]> {
  const tracer = await PathTracer.create({ scene, width, height, settings, device: await testDevice() });
  if (settings.constants) await tracer.compile();
  const renders: Render[] = [];
  for (const seed of seeds) {
    tracer.update({ seed });
    await tracer.sample(samples);
    renders.push({ image: await tracer.readRadiance(), stats: { ...tracer.stats } });
  }
  tracer.dispose();
  return renders;
}

/** `count` seeds from `first` on. */
export function seedsFrom(first: number, count: number): number[] {
  return Array.from({ length: count }, (_, i) => first + i);
}
