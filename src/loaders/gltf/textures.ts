// Pictures as textures of a scene. A picture is decoded once, whatever the number of ways it is repeated.

import { ImageUtils } from "@gltf-transform/core";
import { LoadError } from "../../errors";
import type { Scene, Texture } from "../../scene/schema";
import { decodeInPage } from "../decodeInPage";
import { MAX_TEXELS, MAX_UNPACKED_BYTES } from "../limits";
import type { DecodedImage, DecodeImage, LoadOptions } from "../loadedScene";
import type { Resources } from "./resources";
import type { GltfJson } from "./schema";

/** Files at the same time: as many as browsers load from one host. */
const MAX_READING = 6;
/** Pictures at the same time: the browser's threads are at one while another is unpacked. More would only take more memory. */
const MAX_DECODING = 2;
const NEAREST = 9728;
const WRAPS = { 33071: "clamp", 33648: "mirror", 10497: "repeat" } as const;

/** The textures that materials turned out to need. */
export class Textures {
  readonly #json: GltfJson;
  /** By name. */
  readonly #used = new Map<string, { readonly image: number; readonly look: Omit<Texture, keyof DecodedImage> }>();

  constructor(json: GltfJson) {
    this.#json = json;
  }

  /** The name in the scene of one of the file's textures; `undefined` if it has no picture in a format that is read. */
  use(index: number): string | undefined {
    const { source, sampler, extensions } = this.#json.textures[index]!;
    // Where there is a choice, PNG and JPEG are what every decoder can do.
    const image = source ?? extensions?.EXT_texture_webp?.source ?? extensions?.EXT_texture_avif?.source;
    if (image === undefined) return undefined;
    const { wrapS = 10497, wrapT = 10497, magFilter } = this.#json.samplers[sampler ?? -1] ?? {};
    const filter = magFilter === NEAREST ? "nearest" : "linear";
    const look = { wrapU: WRAPS[wrapS], wrapV: WRAPS[wrapT], filter } as const;
    const name = ["image", image, ...(wrapS === 10497 && wrapT === 10497 ? [] : [look.wrapU, look.wrapV])];
    if (filter === "nearest") name.push(filter);
    this.#used.set(name.join(" "), { image, look });
    return name.join(" ");
  }

  /**
   * Reads and decodes every picture in use.
   *
   * @throws {LoadError} if one is missing or damaged, or all together are too large, which is known before any is decoded.
   */
  async decode(resources: Resources, { decodeImage = decodeInPage, signal }: LoadOptions): Promise<Scene["textures"]> {
    const indices = [...new Set([...this.#used.values()].map(({ image }) => image))];
    const files: ImageFile[] = [];
    let texelCount = 0;
    let byteCount = 0;
    await forEachOf(indices, MAX_READING, async (index) => {
      const file = await fileOf(await resources.image(index), index);
      texelCount += file.size[0] * file.size[1];
      byteCount += file.bytes.length;
      if (texelCount > MAX_TEXELS) throw new LoadError(`has pictures of more than ${MAX_TEXELS} texels`);
      if (byteCount > MAX_UNPACKED_BYTES) throw new LoadError(`has pictures of more than ${MAX_UNPACKED_BYTES} bytes`);
      files.push(file);
    });
    const decoded = new Map<number, DecodedImage>();
    await forEachOf(files, MAX_DECODING, async (file) => {
      signal?.throwIfAborted();
      decoded.set(file.index, await decode(file, decodeImage));
    });
    return Object.fromEntries(
      [...this.#used].map(([name, { image, look }]) => [name, { ...decoded.get(image)!, ...look }]),
    );
  }
}

/** Does something with each, with a few at the same time. Once that fails nothing more is begun. */
async function forEachOf<T>(items: readonly T[], atOnce: number, act: (item: T) => Promise<void>): Promise<void> {
  const waiting = each(items);
  const worker = async () => {
    for (const item of waiting) await act(item); // which ends `waiting` when it throws
  };
  await Promise.all(Array.from({ length: atOnce }, worker));
}

function* each<T>(items: readonly T[]): Generator<T> {
  yield* items;
}

type ImageFile = {
  readonly index: number;
  readonly bytes: Uint8Array;
  readonly mimeType: string;
  readonly size: readonly [number, number];
};

/** Reads the header: what a file claims to be is not trusted, and how large it gets has to be known before it is decoded. */
async function fileOf(bytes: Uint8Array, index: number): Promise<ImageFile> {
  if (ImageUtils.getMimeType(bytes) === null) {
    // These teach glTF-Transform two more formats.
    const { EXTTextureAVIF, EXTTextureWebP } = await import("@gltf-transform/extensions");
    EXTTextureAVIF.register();
    EXTTextureWebP.register();
  }
  const mimeType = ImageUtils.getMimeType(bytes);
  if (mimeType === null) throw new LoadError(`images[${index}]: is not PNG, JPEG, WebP or AVIF`);
  try {
    const [width, height] = ImageUtils.getSize(bytes, mimeType) ?? [0, 0];
    if (width >= 1 && height >= 1) return { index, bytes, mimeType, size: [width, height] };
  } catch (cause) {
    throw new LoadError(`images[${index}]: its header is damaged`, { cause });
  }
  throw new LoadError(`images[${index}]: its header is damaged`);
}

async function decode({ index, bytes, mimeType, size }: ImageFile, decodeImage: DecodeImage): Promise<DecodedImage> {
  const image = await decodeImage(bytes, mimeType).catch((cause: unknown) => {
    throw new LoadError(`images[${index}]: ${cause instanceof Error ? cause.message : cause}`, { cause });
  });
  if (image.width === size[0] && image.height === size[1]) return image;
  throw new LoadError(
    `images[${index}]: is ${image.width} × ${image.height}, though its header says ${size.join(" × ")}`,
  );
}
