import { type BasisTranscoder, createBasisTranscoder, type Transcodable } from "./basisTranscoder";

// The worker of `startTranscoding`: says that it runs, gets the compiled transcoder, then one file after the other.

/** From the worker, for each file. */
export type TranscodeReply = { readonly texels: Uint8Array<ArrayBuffer> } | { readonly error: unknown };

let creating: Promise<BasisTranscoder> | undefined;

addEventListener("message", async ({ data }: MessageEvent<WebAssembly.Module | Transcodable>) => {
  if (data instanceof WebAssembly.Module) {
    creating = createBasisTranscoder(data);
    creating.catch(() => {}); // each file says it
    return;
  }
  try {
    const transcode = await creating!;
    const texels = transcode(data);
    postMessage({ texels } satisfies TranscodeReply, { transfer: [texels.buffer] });
  } catch (error) {
    postMessage({ error } satisfies TranscodeReply);
  }
});
postMessage("ready");
