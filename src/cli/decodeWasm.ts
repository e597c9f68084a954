// JPEG, WebP and AVIF by libraries compiled to WebAssembly: what Chromium decodes them with, or its kin.

import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { RtViewerError } from "../errors";
import type { DecodedImage } from "../loaders/loadedScene";
import { keep } from "../scene/keptBytes";

const { resolve } = createRequire(import.meta.url);

type Codec = {
  readonly init: (module: WebAssembly.Module, options: { readonly printErr: () => void }) => Promise<void>;
  readonly default: (bytes: ArrayBuffer) => Promise<unknown>;
};
type Pixels = { readonly width: number; readonly height: number; readonly data: Uint8ClampedArray };

/** @throws {RtViewerError} if the picture is damaged, or CMYK. */
export const decodeMozjpeg = decoderOf(
  () => import("@jsquash/jpeg/decode.js"),
  "@jsquash/jpeg/codec/dec/mozjpeg_dec.wasm",
);

/** @throws {RtViewerError} if the picture is damaged or animated. */
export const decodeWebp = decoderOf(() => import("@jsquash/webp/decode.js"), "@jsquash/webp/codec/dec/webp_dec.wasm");

/** @throws {RtViewerError} if the picture is damaged. */
export const decodeAvif = decoderOf(() => import("@jsquash/avif/decode.js"), "@jsquash/avif/codec/dec/avif_dec.wasm");

/** @param wasm - a file of the package: the decoder would fetch it, which Node can't. */
function decoderOf(loadCodec: () => Promise<unknown>, wasm: string): (bytes: Uint8Array) => Promise<DecodedImage> {
  let loading: Promise<{ codec: Codec; start: () => Promise<void> }> | undefined;
  const load = async () => {
    globalThis.ImageData ??= PlainImageData as unknown as typeof ImageData; // which Node lacks, and decoders make
    const codec = (await loadCodec()) as Codec;
    const module = await WebAssembly.compile(await readFile(resolve(wasm)));
    const start = () => codec.init(module, { printErr: () => {} });
    await start();
    return { codec, start };
  };
  return async (bytes) => {
    loading ??= load();
    const { codec, start } = await loading;
    try {
      const { width, height, data } = (await codec.default(new Uint8Array(bytes).buffer)) as Pixels;
      return { width, height, texels: keep(new Uint8Array(data.buffer, data.byteOffset, data.length)) };
    } catch (cause) {
      await start(); // a decoder that ran out of memory stays broken
      throw new RtViewerError("it is damaged, or of a kind that can't be decoded", { cause });
    }
  };
}

class PlainImageData {
  constructor(
    readonly data: Uint8ClampedArray,
    readonly width: number,
    readonly height: number,
  ) {}
}
