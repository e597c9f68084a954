// rt-viewer's own part in the benchmark; the same code in a page and in Node.
import { requestDevice } from "../../src/gpu/device";
import { PathTracer, type PathTracerOptions } from "../../src/renderer/pathTracer";
import type { Settings } from "../../src/renderer/settings";
import type { Scene } from "../../src/scene/schema";
import type {
  EstimatedImage,
  EstimateOptions,
  FrameOptions,
  MeasuredFrames,
  Measurement,
  MeasureOptions,
  Variant,
} from "./measurement";

const SETTINGS: Readonly<Record<Variant, Partial<Settings>>> = {
  ours: {},
  independent: { sampler: "independent" },
  uniform: { estimator: "uniform" },
};

const NAMES: Readonly<Record<Variant, string>> = {
  ours: "rt-viewer",
  independent: "rt-viewer, independent points",
  uniform: "rt-viewer, uniform baseline",
};

// Enough that the driver has made its code and the tracer knows how much work the adapter does in one submit.
const WARM_UP_SAMPLES = 4;
const WARM_UP_FRAMES = 2;

/** @param device - used, not destroyed; without one, one is requested. */
export function measureOurs(
  variant: Variant,
  scene: Scene,
  { width, height, samples, seed }: MeasureOptions,
  device?: GPUDevice,
): Promise<Measurement> {
  return withDevice(device, async (lent) => {
    const start = performance.now();
    const settings = { ...SETTINGS[variant], seed };
    return withTracer({ scene, width, height, settings, device: lent }, async (tracer) => {
      await tracer.compile();
      const setupSeconds = secondsSince(start);
      await tracer.sample(WARM_UP_SAMPLES);
      const images = [];
      for (const count of samples) {
        tracer.reset();
        const seconds = await timeSamples(tracer, count);
        images.push({ samples: tracer.stats.samples, seconds, radiance: await readRgb(tracer) });
      }
      return { renderer: NAMES[variant], adapter: tracer.stats.adapter, setupSeconds, images };
    });
  });
}

/** One image that grows to each of the sample counts in turn. */
export function measureEstimates(
  scene: Scene,
  { width, height, samples, seed, sampler }: EstimateOptions,
  device?: GPUDevice,
): Promise<EstimatedImage[]> {
  return withDevice(device, (lent) =>
    withTracer({ scene, width, height, settings: { seed, sampler }, device: lent }, async (tracer) => {
      await tracer.compile();
      const images = [];
      for (const count of samples) {
        await tracer.sample(count - tracer.stats.samples);
        images.push({ samples: count, estimate: tracer.stats.error, radiance: await readRgb(tracer) });
      }
      return images;
    }),
  );
}

/** Times frames that begin anew each, as those of a moving camera do. */
export function measureFrames(
  scene: Scene,
  { width, height, estimator, rays, bounces, lightSamples, frames }: FrameOptions,
  device?: GPUDevice,
): Promise<MeasuredFrames> {
  return withDevice(device, (lent) => {
    const settings = { estimator, maxBounces: bounces, lightSamples, seed: 1 };
    return withTracer({ scene, width, height, settings, device: lent }, async (tracer) => {
      await tracer.compile();
      const seconds = [];
      for (let i = 0; i < WARM_UP_FRAMES + frames; i++) {
        tracer.reset();
        seconds.push(await timeSamples(tracer, rays));
      }
      const first = await readRgb(tracer);
      tracer.update({ seed: 2 });
      await tracer.sample(rays);
      const images = [first, await readRgb(tracer)] as const;
      return { adapter: tracer.stats.adapter, seconds: seconds.slice(WARM_UP_FRAMES), images };
    });
  });
}

async function withDevice<T>(given: GPUDevice | undefined, use: (device: GPUDevice) => Promise<T>): Promise<T> {
  if (given) return use(given);
  const device = await requestDevice();
  try {
    return await use(device);
  } finally {
    device.destroy();
  }
}

async function withTracer<T>(options: PathTracerOptions, use: (tracer: PathTracer) => Promise<T>): Promise<T> {
  const tracer = await PathTracer.create(options);
  try {
    const result = await use(tracer);
    if (tracer.stats.badSamples > 0) throw new Error(`${tracer.stats.badSamples} samples were not finite`);
    return result;
  } finally {
    tracer.dispose();
  }
}

async function timeSamples(tracer: PathTracer, count: number): Promise<number> {
  const start = performance.now();
  await tracer.sample(count);
  return secondsSince(start);
}

function secondsSince(start: number): number {
  return (performance.now() - start) / 1000;
}

async function readRgb(tracer: PathTracer): Promise<Float32Array> {
  const rgba = await tracer.readRadiance();
  return Float32Array.from({ length: (rgba.length / 4) * 3 }, (_, i) => rgba[4 * Math.floor(i / 3) + (i % 3)]!);
}
