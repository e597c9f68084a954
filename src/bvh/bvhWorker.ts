import { buildBvh } from "./buildBvh";
import type { WorkerReply, WorkerRequest } from "./workerMessages";

// The worker of `buildBvhAsync`: says that it runs, then builds one tree.

const reply = (message: WorkerReply, transfer: Transferable[] = []) => postMessage(message, { transfer });

addEventListener("message", ({ data: { bounds, maxLeaf } }: MessageEvent<WorkerRequest>) => {
  try {
    const onProgress = (fraction: number) => reply({ type: "progress", fraction });
    const bvh = buildBvh(bounds, { ...(maxLeaf !== undefined && { maxLeaf }), onProgress });
    const { bounds: nodeBounds, links, axes, counts, order } = bvh;
    reply({ type: "built", bvh }, [nodeBounds.buffer, links.buffer, axes.buffer, counts.buffer, order.buffer]);
  } catch (error) {
    reply({ type: "failed", error });
  }
});
reply({ type: "ready" });
