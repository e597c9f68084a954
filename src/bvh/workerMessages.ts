import type { Bvh } from "./bvh";

/** To the worker, once it is ready. */
export type WorkerRequest = {
  readonly bounds: Float32Array;
  readonly maxLeaf: number | undefined;
};

/** From the worker: `ready` first, then `progress`, and `built` or `failed` at last. */
export type WorkerReply =
  | { readonly type: "ready" }
  | { readonly type: "progress"; readonly fraction: number }
  | { readonly type: "built"; readonly bvh: Bvh }
  | { readonly type: "failed"; readonly error: unknown };
