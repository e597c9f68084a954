// Pictures as textures of a scene. A picture is decoded once, whatever the number of ways it is repeated.

import { LoadError } from "../../errors";
import type { Scene, Texture } from "../../scene/schema";
import { checkPageDecodes, decodeInPage } from "../decodeInPage";
import { Ktx2Decoder } from "../ktx2/ktx2Decoder";
import { KTX2_MIME_TYPE } from "../ktx2/ktx2Header";
import { MAX_UNPACKED_BYTES } from "../limits";
import type { DecodedImage, LoadOptions } from "../loadedScene";
import { MAX_DECODED_TEXELS, MAX_PICTURE_TEXELS } from "../pictureLimits";
import { texelBudget } from "../texelBudget";
import type { Warnings } from "../warnings";
import { fitPictures, halved } from "./fitPictures";
import { type ImageFile, readHeader } from "./imageFile";
import { placeOf } from "./materials";
import type { Resources } from "./resources";
import { roughnessPicture } from "./roughnessPicture";
import type { GltfJson } from "./schema";
import { shrinkPicture } from "./shrinkPicture";

/** Files at the same time: as many as browsers load from one host. */
const MAX_READING = 6;
/** Pictures at the same time: the browser's threads are at one while another is unpacked. More would only take more memory. */
const MAX_DECODING = 2;
/** A picture with more texels is decoded while no other is: 256 MiB. */
const MAX_TEXELS_OF_SEVERAL = 2 ** 26;
/** Of a reason in a warning: it can quote what the file says. */
const MAX_REASON_LENGTH = 300;
const NEAREST = 9728;
const WRAPS = { 33071: "clamp", 33648: "mirror", 10497: "repeat" } as const;

/**
 * What a picture holds: sRGB, or data, or glossiness in its alpha, which is multiplied by this number. Of that a texture is made
 * that has the roughness in its green.
 */
export type Reading = "color" | "data" | { readonly glossiness: number };

type Use = {
  readonly image: number;
  readonly reading: Reading;
  readonly look: Omit<Texture, keyof DecodedImage>;
};
type Picture = ImageFile & {
  readonly index: number;
  /** In how many textures it is. */
  readonly copies: number;
  /** Whether anything reads it as colour. What is read as data too, which is unusual, is made smaller as colour. */
  readonly isColor: boolean;
};

/** The textures that materials turned out to need. */
export class Textures {
  readonly #json: GltfJson;
  readonly #warnings: Warnings;
  /** By name. */
  readonly #used = new Map<string, Use>();
  readonly #colors = new Set<number>();

  constructor(json: GltfJson, warnings: Warnings) {
    this.#json = json;
    this.#warnings = warnings;
  }

  /**
   * The name in the scene of one of the file's textures; `undefined`, which is said, if it has no picture in a format that is read.
   */
  use(index: number, reading: Reading): string | undefined {
    const { source, sampler, extensions } = this.#json.textures[index]!;
    // Where there is a choice, PNG and JPEG are what every decoder can do. KTX2 has lost most, and needs a decoder that is loaded.
    const image =
      source ??
      extensions?.EXT_texture_webp?.source ??
      extensions?.EXT_texture_avif?.source ??
      extensions?.KHR_texture_basisu?.source;
    if (image === undefined) {
      this.#warnings.add("A texture is left out because it has no picture that can be read", `textures[${index}]`);
      return undefined;
    }
    if (reading === "color") this.#colors.add(image);
    const { wrapS = 10497, wrapT = 10497, magFilter } = this.#json.samplers[sampler ?? -1] ?? {};
    const filter = magFilter === NEAREST ? "nearest" : "linear";
    const look = { wrapU: WRAPS[wrapS], wrapV: WRAPS[wrapT], filter } as const;
    const name = ["image", image, ...(wrapS === 10497 && wrapT === 10497 ? [] : [look.wrapU, look.wrapV])];
    if (filter === "nearest") name.push(filter);
    if (typeof reading === "object") name.push("glossiness", reading.glossiness);
    this.#used.set(name.join(" "), { image, reading, look });
    return name.join(" ");
  }

  /**
   * Reads and decodes every picture in use. Those that can't be read are left out; where all together are too large, they are made
   * smaller, one after the other. Both is said.
   *
   * @returns fewer textures than have names, maybe.
   * @throws {LoadError} if pictures can't be decoded here at all.
   */
  async decode(resources: Resources, options: LoadOptions): Promise<NonNullable<Scene["textures"]>> {
    const { decodeImage = decodeInPage, signal } = options;
    const pictures = await this.#read(resources, signal);
    if (options.decodeImage === undefined && !pictures.every(isKtx2)) checkPageDecodes();
    const bytes = pictures.reduce((sum, { width, height, copies }) => sum + 4 * width * height * copies, 0);
    const halvings = fitPictures(pictures, await texelBudget(bytes, options));
    const decoded = new Map<number, DecodedImage>();
    const ktx2 = new Ktx2Decoder(signal);
    const decode = async ([i, picture]: [number, Picture]) => {
      await this.#attempt(picture.index, signal, async () => {
        const image = await (isKtx2(picture)
          ? ktx2.decode(picture.bytes)
          : decodeImage(picture.bytes, picture.mimeType));
        checkSize(image, picture);
        const size = halved(image, halvings[i]!);
        const isSmaller = halvings[i]! > 0;
        decoded.set(picture.index, isSmaller ? await shrinkPicture(image, size, picture.isColor, signal) : image);
        if (isSmaller) this.#tellSmaller(picture, size);
      });
    };
    const isLarge = ({ width, height }: Picture) => width * height > MAX_TEXELS_OF_SEVERAL;
    const entries = [...pictures.entries()];
    const several = entries.filter(([, picture]) => !isLarge(picture));
    const large = entries.filter(([, picture]) => isLarge(picture));
    try {
      await forEachOf(several, MAX_DECODING, decode);
      await forEachOf(large, 1, decode);
    } finally {
      ktx2.dispose();
    }
    const textures: Record<string, Texture> = {};
    for (const [name, { image, reading, look }] of this.#used) {
      const picture = decoded.get(image);
      if (typeof reading === "object") {
        textures[name] = { ...(await roughnessPicture(picture, reading.glossiness, signal)), ...look };
      } else if (picture !== undefined) textures[name] = { ...picture, ...look };
    }
    return textures;
  }

  /** The files of the pictures in use, in their order in the file; without those that can't be read or are too large. */
  async #read(resources: Resources, signal: AbortSignal | undefined): Promise<Picture[]> {
    const copies = new Map<number, number>();
    for (const { image } of this.#used.values()) copies.set(image, (copies.get(image) ?? 0) + 1);
    const files = new Map<number, ImageFile>();
    let byteCount = 0;
    await forEachOf([...copies.keys()], MAX_READING, (index) =>
      this.#attempt(index, signal, async () => {
        const bytes = await resources.image(index);
        // What is part of a buffer takes no memory of its own.
        if (this.#json.images[index]!.bufferView === undefined) byteCount += bytes.length;
        if (byteCount > MAX_UNPACKED_BYTES)
          throw new LoadError(`there are pictures of more than ${MAX_UNPACKED_BYTES} bytes`);
        files.set(index, await readHeader(bytes));
      }),
    );
    const pictures: Picture[] = [];
    let texelCount = 0;
    for (const [index, file] of [...files].sort(([a], [b]) => a - b)) {
      const texels = file.width * file.height;
      await this.#attempt(index, signal, async () => {
        if (texels > MAX_PICTURE_TEXELS) {
          throw new LoadError(`it is ${sizeText(file)}, which is more than ${MAX_PICTURE_TEXELS} texels`);
        }
        if (texelCount + texels > MAX_DECODED_TEXELS) {
          throw new LoadError(`there are pictures of more than ${MAX_DECODED_TEXELS} texels`);
        }
        texelCount += texels;
        pictures.push({ ...file, index, copies: copies.get(index)!, isColor: this.#colors.has(index) });
      });
    }
    return pictures;
  }

  /** Does something with a picture. If that fails, the picture is left out, which is said. */
  async #attempt(index: number, signal: AbortSignal | undefined, act: () => Promise<void>): Promise<void> {
    try {
      signal?.throwIfAborted();
      await act();
    } catch (error) {
      signal?.throwIfAborted();
      const whole = error instanceof Error ? error.message : String(error);
      this.#leaveOut(index, whole.length > MAX_REASON_LENGTH ? `${whole.slice(0, MAX_REASON_LENGTH)}…` : whole);
    }
  }

  #leaveOut(index: number, reason: string): void {
    this.#warnings.add(`A picture is left out, and its texture is white: ${reason}`, this.#placeOf(index));
  }

  #tellSmaller(picture: Picture, [width, height]: readonly [number, number]): void {
    const text = `Pictures are too large together, so this is shown at ${width} × ${height} instead of ${sizeText(picture)}`;
    this.#warnings.add(text, this.#placeOf(picture.index));
  }

  /** `images[3] "bark.png"`. */
  #placeOf(index: number): string {
    const { name, uri } = this.#json.images[index]!;
    return placeOf("images", index, name || (uri !== undefined && !/^data:/i.test(uri) ? uri : undefined));
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

function isKtx2({ mimeType }: ImageFile): boolean {
  return mimeType === KTX2_MIME_TYPE;
}

/** A picture may be turned: AVIF says so apart from its size. */
function checkSize({ width, height }: DecodedImage, file: ImageFile): void {
  const isAsSaid = width === file.width && height === file.height;
  if (isAsSaid || (width === file.height && height === file.width)) return;
  throw new LoadError(`it is ${sizeText({ width, height })}, though its header says ${sizeText(file)}`);
}

function sizeText({ width, height }: { readonly width: number; readonly height: number }): string {
  return `${width} × ${height}`;
}
