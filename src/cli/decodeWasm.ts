// WebP and AVIF, by libwebp and libavif as WebAssembly: what Chromium decodes them with.

import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import type { DecodedImage } from "../loaders/loadedScene";

const { resolve } = createRequire(import.meta.url);

type Codec = {
  readonly init: (module: WebAssembly.Module) => Promise<void>;
  readonly default: (bytes: ArrayBuffer) => Promise<unknown>;
};
type Pixels = { readonly width: number; readonly height: number; readonly data: Uint8ClampedArray };

const loadWebp = once(() =>
  load(import("@jsquash/webp/decode.js") as Promise<Codec>, "@jsquash/webp/codec/dec/webp_dec.wasm"),
);
const loadAvif = once(() =>
  load(import("@jsquash/avif/decode.js") as Promise<Codec>, "@jsquash/avif/codec/dec/avif_dec.wasm"),
);

/** @throws anything, if the picture is damaged or animated. */
export async function decodeWebp(bytes: Uint8Array): Promise<DecodedImage> {
  return decode(await loadWebp(), bytes);
}

/** @throws anything, if the picture is damaged. */
export async function decodeAvif(bytes: Uint8Array): Promise<DecodedImage> {
  return decode(await loadAvif(), bytes);
}

async function decode(codec: Codec, bytes: Uint8Array): Promise<DecodedImage> {
  const { width, height, data } = (await codec.default(new Uint8Array(bytes).buffer)) as Pixels;
  return { width, height, texels: data };
}

/** Given its WebAssembly, because it would fetch it, which Node can't from a file. */
async function load(loading: Promise<Codec>, wasm: string): Promise<Codec> {
  globalThis.ImageData ??= PlainImageData as unknown as typeof ImageData; // which Node lacks, and the decoders make
  const codec = await loading;
  await codec.init(await WebAssembly.compile(await readFile(resolve(wasm))));
  return codec;
}

class PlainImageData {
  constructor(
    readonly data: Uint8ClampedArray,
    readonly width: number,
    readonly height: number,
  ) {}
}

function once<T>(make: () => Promise<T>): () => Promise<T> {
  let made: Promise<T> | undefined;
  return () => {
    made ??= make();
    return made;
  };
}
