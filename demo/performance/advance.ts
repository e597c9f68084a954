import type { PathTracer } from "rt-viewer";

// Samples per pixel in one submit: enough that starting it costs little, few enough to fit the viewer's budget for a frame.
const FRAME_S = 0.012;
const FEWEST = 4;
const MOST = 1024;

/**
 * Renders until the picture has `samples` per pixel, keeping the device busy and the page free.
 *
 * @param perSecond - samples per pixel that the device is likely to take in a second, if that is known.
 * @returns how many seconds that took.
 */
export async function advance(tracer: PathTracer, samples: number, perSecond = 0): Promise<number> {
  const samplesPerFrame = Math.min(MOST, Math.max(FEWEST, Math.ceil(perSecond * FRAME_S)));
  tracer.update({ maxSamples: samples, samplesPerFrame });
  const start = performance.now();
  while (tracer.stats.samples < samples) {
    if (!tracer.frame()) throw new Error(`no more than ${tracer.stats.samples} of ${samples} samples can be taken`);
    while (tracer.frame()); // as many as the device may have under way
    await settle(tracer);
  }
  return (performance.now() - start) / 1000;
}

/** Compiles everything, lets the device run it once, and empties the picture: what follows measures rendering alone. */
export async function warmUp(tracer: PathTracer): Promise<void> {
  await tracer.compile();
  await tracer.sample(1);
  await startOver(tracer);
}

/** Empties the picture. */
export async function startOver(tracer: PathTracer): Promise<void> {
  tracer.reset();
  await settle(tracer);
}

/** Resolves when the device has done what it was given, and the tracer what it was told. */
function settle(tracer: PathTracer): Promise<void> {
  return tracer.sample(0);
}
