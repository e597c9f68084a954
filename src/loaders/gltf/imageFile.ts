// What the header of a picture file says.

import { ImageUtils } from "@gltf-transform/core";
import { LoadError } from "../../errors";
import { isKtx2, KTX2_MIME_TYPE, readKtx2Header } from "../ktx2/ktx2Header";

export type ImageFile = {
  readonly bytes: Uint8Array;
  readonly mimeType: string;
  readonly width: number;
  readonly height: number;
};

/**
 * Reads the header: what a file claims to be is not trusted, and how large it gets has to be known before it is decoded.
 *
 * @throws {LoadError} if it is damaged, or of no format that is read.
 */
export async function readHeader(bytes: Uint8Array): Promise<ImageFile> {
  if (isKtx2(bytes)) {
    const { width, height } = readKtx2Header(bytes);
    return { bytes, mimeType: KTX2_MIME_TYPE, width, height };
  }
  if (ImageUtils.getMimeType(bytes) === null) {
    // These teach glTF-Transform two more formats.
    const { EXTTextureAVIF, EXTTextureWebP } = await import("@gltf-transform/extensions");
    EXTTextureAVIF.register();
    EXTTextureWebP.register();
  }
  const mimeType = ImageUtils.getMimeType(bytes);
  if (mimeType === null) throw new LoadError(`it is ${foreignFormat(bytes) ?? "not PNG, JPEG, WebP, AVIF or KTX2"}`);
  let size: readonly number[] | null;
  try {
    size = ImageUtils.getSize(bytes, mimeType);
  } catch (cause) {
    throw new LoadError("its header is damaged", { cause });
  }
  const [width = 0, height = 0] = size ?? [];
  if (width >= 1 && height >= 1) return { bytes, mimeType, width, height };
  throw new LoadError("its header is damaged");
}

/** What servers send in place of a picture, and pictures that nobody reads here, by how they begin. */
function foreignFormat(bytes: Uint8Array): string | undefined {
  if (bytes.length === 0) return "empty";
  const text = String.fromCharCode(...bytes.subarray(0, 100));
  if (/^\W*<(!doctype html|html|head|body)\b/i.test(text)) return "a web page (HTML), not a picture";
  const [name] = FOREIGN_FORMATS.find(([, beginning]) => beginning.test(text)) ?? [];
  return name && `${name}, which can't be read`;
}

const FOREIGN_FORMATS = [
  ["GIF", /^GIF8/],
  ["BMP", /^BM/],
  ["SVG", /^\W*<(\?xml|svg)\b/],
  ["KTX 1", /^\xabKTX 11\xbb/],
  ["DDS", /^DDS /],
  ["TIFF", /^(II\*|MM\0\*)/],
  ["Radiance HDR", /^#\?RADIANCE/],
] as const;
