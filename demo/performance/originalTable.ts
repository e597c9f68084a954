import { PathTracer, type Scene } from "rt-viewer";
import { advance, startOver, warmUp } from "./advance";
import { errorOfPair } from "./statistics";

/** How the original's author set it up for one line of his table, and what it then reported. */
export type OriginalSetting = {
  /** Per pixel and frame. */
  readonly rays: number;
  readonly bounces: number;
  /** At each hit. */
  readonly lightSamples: number;
  /** Frames per second on a GeForce GTX 970, in WebGL. */
  readonly reported: string;
};

// biome-ignore format: a table
export const ORIGINAL_SETTINGS: readonly OriginalSetting[] = [
  { rays:  5, bounces:  1, lightSamples:  1, reported: "> 60" },
  { rays: 10, bounces:  1, lightSamples:  1, reported: "> 60" },
  { rays: 15, bounces:  1, lightSamples:  1, reported: "> 60" },
  { rays: 20, bounces:  1, lightSamples:  1, reported: "> 60" },
  { rays: 10, bounces:  5, lightSamples:  1, reported: "> 60" },
  { rays: 15, bounces:  5, lightSamples:  1, reported: "30" },
  { rays: 20, bounces: 10, lightSamples:  1, reported: "27" },
  { rays: 10, bounces:  5, lightSamples:  5, reported: "30" },
  { rays: 15, bounces:  5, lightSamples: 10, reported: "20" },
  { rays: 15, bounces:  5, lightSamples: 15, reported: "14" },
];

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

/** Seconds of one frame, by as many more as a short one needs to be timed well. */
async function timed(tracer: PathTracer, rays: number, seconds: number): Promise<number> {
  if (seconds > SHORTEST_S) return seconds;
  const frames = Math.min(MOST_AT_ONCE, Math.ceil(SHORTEST_S / seconds));
  return (await advance(tracer, rays * (1 + frames), rays / seconds)) / frames;
}
