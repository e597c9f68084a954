import { startWorker, untilAborted } from "../startWorker";
import { type BuildOptions, buildBvh } from "./buildBvh";
import type { Bvh } from "./bvh";
import type { WorkerReply, WorkerRequest } from "./workerMessages";

/** Fewer primitives are built in the thread: at some 0.7 µs each that is about one frame. */
export const MIN_WORKER_PRIMITIVES = 20_000;

export type AsyncBuildOptions = BuildOptions & {
  /** Ends the build; the promise is rejected with its reason. */
  readonly signal?: AbortSignal;
};

/**
 * `buildBvh` in a worker, so that a page stays responsive. Where there is none (in Node, or where a content security policy or a
 * foreign origin forbids it), and for fewer primitives than `MIN_WORKER_PRIMITIVES`, it builds in the thread.
 *
 * @param bounds - as of `buildBvh`. They are given away: the worker takes their buffer, which is then detached.
 * @throws what `buildBvh` throws, or the reason of `signal`.
 */
export async function buildBvhAsync(
  bounds: Float32Array,
  { signal, ...options }: AsyncBuildOptions = {},
): Promise<Bvh> {
  signal?.throwIfAborted();
  // Until it has started nothing is given away.
  const worker = bounds.length / 6 < MIN_WORKER_PRIMITIVES ? undefined : await startWorker(createWorker, signal);
  if (worker === undefined) return buildBvh(bounds, options);
  try {
    return await buildIn(worker, bounds, options, signal);
  } finally {
    worker.terminate();
  }
}

const createWorker = () => new Worker(new URL("./bvhWorker.ts", import.meta.url), { type: "module" });

function buildIn(
  worker: Worker,
  bounds: Float32Array,
  { maxLeaf, onProgress }: BuildOptions,
  signal: AbortSignal | undefined,
): Promise<Bvh> {
  return untilAborted(signal, (resolve, reject) => {
    worker.onmessage = ({ data }: MessageEvent<WorkerReply>) => {
      if (data.type === "progress") onProgress?.(data.fraction);
      else if (data.type === "built") resolve(data.bvh);
      else if (data.type === "failed") reject(data.error);
    };
    worker.onerror = ({ message }) => reject(new Error(`The BVH's worker failed: ${message}`));
    // Only a whole buffer can be given away, and not one that is shared.
    const isWhole = bounds.buffer instanceof ArrayBuffer && bounds.byteLength === bounds.buffer.byteLength;
    const request: WorkerRequest = { bounds: isWhole ? bounds : bounds.slice(), maxLeaf };
    worker.postMessage(request, [request.bounds.buffer]);
  });
}
