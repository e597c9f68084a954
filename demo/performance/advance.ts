import type { PathTracer } from "rt-viewer";

/**
 * Renders until the picture has `samples` per pixel, keeping the device busy and the page free.
 *
 * @returns how many seconds that took.
 */
export async function advance(tracer: PathTracer, samples: number): Promise<number> {
  tracer.update({ maxSamples: samples });
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
