import { NoToneMapping, REVISION, WebGLRenderer } from "three";
import { WebGLPathTracer } from "three-gpu-pathtracer";
import type { Scene } from "../../../../src/index";
import { parseScene } from "../../../../src/scene/parseScene";
import { createRandom } from "../../../support/random";
import type { Measurement, MeasureOptions, TimedImage } from "../../measurement";
import { convertScene } from "./convertScene";
import { patchShader } from "./patchShader";

// The random numbers of a sample come from a texture one texel wide per purpose, of which there are 17, and
// `bounces + transmissiveBounces + 5` texels wide. Narrower, and the last purposes, the choice of a direction among them,
// read zeros. Nothing here transmits, so that `transmissiveBounces` has no other effect.
const MIN_SUMMED_BOUNCES = 17 - 5;
// Samples under way at a time: the adapter never waits for the page, and the page never queues minutes of work.
const MAX_IN_FLIGHT = 4;

/**
 * Renders with three-gpu-pathtracer's WebGL path tracer, in a page with WebGL 2.
 *
 * It has no seed: its sampler draws from `Math.random`, which this replaces by a seeded generator until it is done.
 *
 * @throws {Error} if the scene has what the path tracer does not, or the adapter fails.
 */
export async function measure(scene: Scene, options: MeasureOptions): Promise<Measurement> {
  const { random } = Math;
  Math.random = createRandom(options.seed);
  const renderer = new WebGLRenderer({ antialias: false, depth: false });
  try {
    return await measureWith(renderer, scene, options);
  } finally {
    Math.random = random;
    renderer.dispose();
    renderer.forceContextLoss();
  }
}

async function measureWith(renderer: WebGLRenderer, scene: Scene, options: MeasureOptions): Promise<Measurement> {
  const start = performance.now();
  renderer.toneMapping = NoToneMapping;
  renderer.setPixelRatio(1);
  renderer.setSize(options.width, options.height, false);
  const resolved = parseScene(scene);
  const tracer = createTracer(renderer, resolved.maxBounces);
  const { world, camera } = convertScene(resolved, options.width / options.height);
  tracer.setScene(world, camera);

  // The shader compiles while the page goes on; until it is ready, there is no first sample.
  while (tracer.samples < 1) {
    tracer.renderSample();
    await nextTask();
  }
  readRadiance(renderer, tracer, options);
  const setupSeconds = (performance.now() - start) / 1000;

  tracer.reset();
  const images: TimedImage[] = [];
  let milliseconds = 0;
  for (const samples of options.samples.toSorted((a, b) => a - b)) {
    const resumed = performance.now();
    await renderUpTo(samples, renderer, tracer);
    milliseconds += performance.now() - resumed;
    images.push({ samples, seconds: milliseconds / 1000, radiance: readRadiance(renderer, tracer, options) });
  }
  tracer.dispose();
  return {
    renderer: `three-gpu-pathtracer 0.0.26 (WebGL, three r${REVISION}, box filter, visible area lights)`,
    adapter: adapterName(renderer),
    setupSeconds,
    images,
  };
}

/** The path tracer at its fastest: it renders samples and nothing else. */
function createTracer(renderer: WebGLRenderer, maxBounces: number): WebGLPathTracer {
  const tracer = new WebGLPathTracer(renderer);
  tracer.tiles.set(1, 1);
  // It counts the segments of a path, the one from the camera included.
  tracer.bounces = maxBounces + 1;
  tracer.transmissiveBounces = Math.max(10, MIN_SUMMED_BOUNCES - tracer.bounces);
  tracer.filterGlossyFactor = 0;
  tracer.renderDelay = 0;
  tracer.fadeDuration = 0;
  tracer.minSamples = 0;
  tracer.rasterizeScene = false;
  tracer.dynamicLowRes = false;
  tracer.renderToCanvas = false;
  patchShader(tracer);
  return tracer;
}

/** Renders until the image has as many samples per pixel, and the adapter is done with them. */
async function renderUpTo(samples: number, renderer: WebGLRenderer, tracer: WebGLPathTracer): Promise<void> {
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const inFlight: WebGLSync[] = [];
  while (tracer.samples < samples) {
    tracer.renderSample();
    inFlight.push(fence(gl));
    if (inFlight.length === MAX_IN_FLIGHT) await finish(gl, inFlight.shift()!);
  }
  for (const sync of inFlight) await finish(gl, sync);
}

function fence(gl: WebGL2RenderingContext): WebGLSync {
  const sync = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  if (sync === null) throw new Error("WebGL: no fence, the context is lost");
  return sync;
}

async function finish(gl: WebGL2RenderingContext, sync: WebGLSync): Promise<void> {
  while (gl.clientWaitSync(sync, gl.SYNC_FLUSH_COMMANDS_BIT, 0) === gl.TIMEOUT_EXPIRED) await nextTask();
  gl.deleteSync(sync);
}

/** As `setTimeout(resolve, 0)`, without the 4 ms that browsers add to it. */
function nextTask(): Promise<void> {
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(null);
  });
}

function readRadiance(
  renderer: WebGLRenderer,
  tracer: WebGLPathTracer,
  { width, height }: { width: number; height: number },
): Float32Array {
  const rgba = new Float32Array(width * height * 4);
  renderer.readRenderTargetPixels(tracer.target, 0, 0, width, height, rgba);
  if (renderer.getContext().isContextLost()) throw new Error("WebGL: the context was lost while rendering");
  const radiance = new Float32Array(width * height * 3);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      // WebGL's first row is the lowest.
      const from = 4 * ((height - 1 - y) * width + x);
      radiance.set(rgba.subarray(from, from + 3), 3 * (y * width + x));
    }
  }
  return radiance;
}

function adapterName(renderer: WebGLRenderer): string {
  const gl = renderer.getContext();
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  return String(gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
}
