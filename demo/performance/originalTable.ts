import { PathTracer, type Scene } from "rt-viewer";
import { advance, startOver, warmUp } from "./advance";
import type { OriginalSetting } from "./originalSettings";
import { errorOfPair } from "./statistics";

export type Size = { readonly width: number; readonly height: number };

/** What an adapter can bear. */
export function frameSize(isSoftware: boolean): Size {
  return isSoftware ? { width: 320, height: 180 } : { width: 1280, height: 720 };
}

/** What one frame at a setting costs and how wrong it is. */
export type Frame = {
  /** Frames per second. */
  readonly fps: number;
  /** Relative RMSE of one frame. */
  readonly error: number;
};

type Estimator = "path" | "uniform";

// Shorter frames than this, in seconds, are timed several at once.
const SHORTEST_S = 0.2;
const MOST_AT_ONCE = 64;

/** Renders single frames of `scene` as one of the original's settings would have it. */
export async function measureFrame(
  device: GPUDevice,
  scene: Scene,
  { width, height }: Size,
  { rays, bounces: maxBounces, lightSamples }: OriginalSetting,
  estimator: Estimator,
): Promise<Frame> {
  const settings = { estimator, maxBounces, lightSamples };
  const tracer = await PathTracer.create({ device, scene, width, height, settings });
  try {
    await warmUp(tracer);
    const firstSeconds = await advance(tracer, rays);
    const first = await tracer.readRadiance();
    tracer.update({ seed: 2 });
    await startOver(tracer);
    const secondSeconds = await advance(tracer, rays);
    const second = await tracer.readRadiance();
    const seconds = await timed(tracer, rays, Math.min(firstSeconds, secondSeconds));
    return { fps: 1 / seconds, error: errorOfPair(first, second) };
  } finally {
    tracer.dispose();
  }
}

/** Seconds of one frame, by as many more as a short one needs to be timed well. Each starts from an empty film. */
async function timed(tracer: PathTracer, rays: number, seconds: number): Promise<number> {
  if (seconds > SHORTEST_S) return seconds;
  const frames = Math.min(MOST_AT_ONCE, Math.ceil(SHORTEST_S / seconds));
  let total = 0;
  for (let i = 0; i < frames; i++) {
    await startOver(tracer);
    total += await advance(tracer, rays);
  }
  return total / frames;
}
