import type { Scene } from "../scene/schema";

/** What a file became. */
export type LoadedScene = {
  /** Texels that the browser decoded are not copied when the scene is shown: another picture has to be another array. */
  readonly scene: Scene;
  /** What the file has that is not shown, or not as it should be: one sentence each. Empty if the scene is all of it. */
  readonly warnings: readonly string[];
  /** The looks that the file offers, by name, for the option `variant`. */
  readonly variants: readonly string[];
};

/** A picture: RGBA, four bytes per texel, not premultiplied by alpha, colours as stored in the file; rows from the top. */
export type DecodedImage = {
  readonly width: number;
  readonly height: number;
  readonly texels: Uint8Array | Uint8ClampedArray;
};

/**
 * Decodes a picture file: as stored, whatever orientation is written beside the texels. KTX2 is not given to it: the loader decodes
 * that itself.
 *
 * @param mimeType - as its first bytes have it: `image/png`, `image/jpeg`, `image/webp` or `image/avif`.
 * @throws anything, if it cannot.
 */
export type DecodeImage = (bytes: Uint8Array, mimeType: string) => Promise<DecodedImage>;

/** What a file needs besides its bytes. Every field is optional. */
export type LoadOptions = {
  /** What the file is called in errors. Default "the file". */
  readonly name?: string;
  /** The file's own address: what it refers to is resolved against it. Without one, `fetchResource` gets what the file says. */
  readonly baseUrl?: string;
  readonly signal?: AbortSignal;
  /** Reads a file that the scene refers to. Default: the page's `fetch`. */
  readonly fetchResource?: (url: string, signal: AbortSignal | undefined) => Promise<Uint8Array>;
  /** Default: the browser's decoder; where there is none, a file with pictures other than KTX2 needs one to be given. */
  readonly decodeImage?: DecodeImage;
  /** Which of the file's variants to show, by name. Default: the materials that it has without any. */
  readonly variant?: string;
  /**
   * Bytes of all textures together, four per texel. If there are more, pictures are halved until they fit, the largest first.
   * Default: what the page's graphics adapter can hold in one buffer, `maxStorageBufferBindingSize`, but at most 512 MiB; without
   * an adapter 128 MiB, which every device can hold.
   */
  readonly maxTexelBytes?: number;
};
