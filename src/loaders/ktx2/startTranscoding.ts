import { startWorker, untilAborted } from "../../startWorker";
import { createBasisTranscoder, type Transcodable } from "./basisTranscoder";
import type { TranscodeReply } from "./transcodeWorker";

/** Transcodes one file at a time, and is not used again after an error. */
export type TranscodingThread = {
  /** @param transcodable - its file is given away. */
  readonly transcode: (transcodable: Transcodable, signal?: AbortSignal) => Promise<Uint8Array<ArrayBuffer>>;
  readonly dispose: () => void;
};

/**
 * A transcoder in a worker, because 2048² texels take 0.1 to 0.2 s. Where there is none (in Node, or where a content security policy
 * or a foreign origin forbids it) it works in the thread.
 */
export async function startTranscoding(module: WebAssembly.Module, signal?: AbortSignal): Promise<TranscodingThread> {
  const worker = await startWorker(createWorker, signal);
  if (worker === undefined) {
    const transcode = await createBasisTranscoder(module);
    return { transcode: async (transcodable) => transcode(transcodable), dispose: () => {} };
  }
  worker.postMessage(module);
  return {
    transcode: (transcodable, signal) => transcodeIn(worker, transcodable, signal),
    dispose: () => worker.terminate(),
  };
}

const createWorker = () => new Worker(new URL("./transcodeWorker.ts", import.meta.url), { type: "module" });

function transcodeIn(worker: Worker, transcodable: Transcodable, signal: AbortSignal | undefined) {
  return untilAborted<Uint8Array<ArrayBuffer>>(signal, (resolve, reject) => {
    worker.onmessage = ({ data }: MessageEvent<TranscodeReply>) => {
      if ("texels" in data) resolve(data.texels);
      else reject(data.error);
    };
    worker.onerror = ({ message }) => reject(new Error(`The transcoder's worker failed: ${message}`));
    worker.postMessage(transcodable, [transcodable.file.buffer]);
  });
}
