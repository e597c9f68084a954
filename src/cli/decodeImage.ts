import { decode as decodeSlowly } from "jpeg-js";
import { RtViewerError } from "../errors";
import { readHeader } from "../loaders/gltf/imageFile";
import type { DecodedImage } from "../loaders/loadedScene";
import { MAX_PICTURE_TEXELS } from "../loaders/pictureLimits";
import { decodePng } from "./decodePng";
import { decodeAvif, decodeMozjpeg, decodeWebp } from "./decodeWasm";

const MAX_JPEG_MEGABYTES = 4096;
/** Of a progressive JPEG, which has ten. Each goes through the whole picture, and can have as little as thirty bytes. */
const MAX_JPEG_SCANS = 100;

/**
 * Decodes pictures in Node, as `DecodeImage` has it: as stored, whatever orientation is written beside the texels.
 *
 * @throws anything, if the picture is damaged, or has more texels than are read, before memory is taken.
 */
export async function decodeImage(bytes: Uint8Array, mimeType: string): Promise<DecodedImage> {
  if (mimeType === "image/png") return decodePng(bytes);
  const { width, height } = await readHeader(bytes);
  if (width * height > MAX_PICTURE_TEXELS) {
    throw new RtViewerError(`is ${width} × ${height}, which is more than ${MAX_PICTURE_TEXELS} texels`);
  }
  if (mimeType === "image/jpeg") return decodeJpeg(bytes);
  if (mimeType === "image/webp") return decodeWebp(bytes);
  if (mimeType === "image/avif") return decodeAvif(bytes);
  throw new RtViewerError(`${mimeType} can't be decoded`);
}

async function decodeJpeg(bytes: Uint8Array): Promise<DecodedImage> {
  if (scanCount(bytes) > MAX_JPEG_SCANS) throw new RtViewerError(`has more than ${MAX_JPEG_SCANS} scans`);
  if (isCutOff(bytes)) throw new RtViewerError("it is cut off");
  return decodeMozjpeg(bytes).catch(() => decodeCmyk(bytes));
}

function decodeCmyk(bytes: Uint8Array): DecodedImage {
  const { width, height, data } = decodeSlowly(bytes, {
    useTArray: true,
    maxMemoryUsageInMB: MAX_JPEG_MEGABYTES,
    maxResolutionInMP: MAX_PICTURE_TEXELS / 1e6,
  });
  return { width, height, texels: data };
}

/** Whether its last scan has no end. Chromium refuses that; libjpeg makes the rest grey. */
function isCutOff(jpeg: Uint8Array): boolean {
  const file = Buffer.from(jpeg.buffer, jpeg.byteOffset, jpeg.length);
  return file.lastIndexOf(Buffer.of(0xff, 0xd9)) < file.lastIndexOf(Buffer.of(0xff, 0xda));
}

/** At most: the two bytes that begin a scan can be in a comment too. */
function scanCount(jpeg: Uint8Array): number {
  let count = 0;
  for (let i = jpeg.indexOf(0xff); i >= 0; i = jpeg.indexOf(0xff, i + 1)) if (jpeg[i + 1] === 0xda) count++;
  return count;
}
