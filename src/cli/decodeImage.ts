import { convertIndexedToRgb, decode as decodePng } from "fast-png";
import { decode as decodeJpeg } from "jpeg-js";
import { RtViewerError } from "../errors";
import { MAX_TEXELS } from "../loaders/limits";
import type { DecodedImage } from "../loaders/loadedScene";
import { checkPng } from "./checkPng";

const MAX_JPEG_MEGABYTES = 2048;
const MAX_JPEG_MEGAPIXELS = MAX_TEXELS / 1e6;
/** Of a progressive JPEG, which has ten. Each goes through the whole picture, and can have as little as thirty bytes. */
const MAX_JPEG_SCANS = 100;

/**
 * Decodes PNG and JPEG in Node, as `DecodeImage` has it.
 *
 * @throws anything, if the picture is damaged, of another kind, or has more than 67 million texels, before memory is taken.
 */
export async function decodeImage(bytes: Uint8Array, mimeType: string): Promise<DecodedImage> {
  if (mimeType === "image/jpeg") {
    if (scanCount(bytes) > MAX_JPEG_SCANS) throw new RtViewerError(`has more than ${MAX_JPEG_SCANS} scans`);
    const { width, height, data } = decodeJpeg(bytes, {
      useTArray: true,
      maxMemoryUsageInMB: MAX_JPEG_MEGABYTES,
      maxResolutionInMP: MAX_JPEG_MEGAPIXELS,
    });
    return { width, height, texels: data };
  }
  if (mimeType !== "image/png") throw new RtViewerError(`${mimeType} can be decoded in a browser only`);
  const png = decodePng(checkPng(bytes));
  const { width, height, depth, palette } = png;
  if (palette !== undefined) return { width, height, texels: spread(convertIndexedToRgb(png), palette[0]!.length, 0) };
  if (depth < 8) throw new RtViewerError(`a PNG of ${depth} bits per value can be decoded in a browser only`);
  return { width, height, texels: spread(png.data, png.channels, depth - 8) };
}

/** At most: the two bytes that begin a scan can be in a comment too. */
function scanCount(jpeg: Uint8Array): number {
  let count = 0;
  for (let i = jpeg.indexOf(0xff); i >= 0; i = jpeg.indexOf(0xff, i + 1)) if (jpeg[i + 1] === 0xda) count++;
  return count;
}

/** Grey, grey and alpha, RGB or RGBA to RGBA. */
function spread(values: ArrayLike<number>, channels: number, excessBits: number): Uint8Array {
  const texels = new Uint8Array((4 * values.length) / channels);
  const [green, blue] = channels < 3 ? [0, 0] : [1, 2];
  const hasAlpha = channels % 2 === 0;
  for (let from = 0, to = 0; to < texels.length; from += channels, to += 4) {
    texels[to] = values[from]! >> excessBits;
    texels[to + 1] = values[from + green]! >> excessBits;
    texels[to + 2] = values[from + blue]! >> excessBits;
    texels[to + 3] = hasAlpha ? values[from + channels - 1]! >> excessBits : 255;
  }
  return texels;
}
