import { decode as decodeJpeg } from "jpeg-js";
import { RtViewerError } from "../errors";
import { MAX_PICTURE_TEXELS } from "../loaders/limits";
import type { DecodedImage } from "../loaders/loadedScene";
import { decodePng } from "./decodePng";
import { decodeAvif, decodeWebp } from "./decodeWasm";

const MAX_JPEG_MEGABYTES = 4096;
const MAX_JPEG_MEGAPIXELS = MAX_PICTURE_TEXELS / 1e6;
/** Of a progressive JPEG, which has ten. Each goes through the whole picture, and can have as little as thirty bytes. */
const MAX_JPEG_SCANS = 100;

/**
 * Decodes pictures in Node, as `DecodeImage` has it: as stored, whatever orientation is written beside the texels.
 *
 * @throws anything, if the picture is damaged, or has more texels than are read, before memory is taken.
 */
export async function decodeImage(bytes: Uint8Array, mimeType: string): Promise<DecodedImage> {
  switch (mimeType) {
    case "image/png":
      return decodePng(bytes);
    case "image/jpeg":
      return decodeJpegFile(bytes);
    case "image/webp":
      return decodeWebp(bytes);
    case "image/avif":
      return decodeAvif(bytes);
    default:
      throw new RtViewerError(`${mimeType} can't be decoded`);
  }
}

function decodeJpegFile(bytes: Uint8Array): DecodedImage {
  if (scanCount(bytes) > MAX_JPEG_SCANS) throw new RtViewerError(`has more than ${MAX_JPEG_SCANS} scans`);
  const { width, height, data } = decodeJpeg(bytes, {
    useTArray: true,
    maxMemoryUsageInMB: MAX_JPEG_MEGABYTES,
    maxResolutionInMP: MAX_JPEG_MEGAPIXELS,
  });
  return { width, height, texels: data };
}

/** At most: the two bytes that begin a scan can be in a comment too. */
function scanCount(jpeg: Uint8Array): number {
  let count = 0;
  for (let i = jpeg.indexOf(0xff); i >= 0; i = jpeg.indexOf(0xff, i + 1)) if (jpeg[i + 1] === 0xda) count++;
  return count;
}
