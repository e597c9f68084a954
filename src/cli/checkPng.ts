// What a PNG may make of a few bytes, before it is decoded: fast-png takes all that comes out.
//
// [1] PNG specification, third edition, 5.3: chunk layout, 11.2.1: image header, 8.1: interlacing

import { inflateSync } from "node:zlib";
import { RtViewerError } from "../errors";
import { MAX_TEXELS } from "../loaders/limits";

const SIGNATURE_BYTES = 8;
/** Length, type and checksum. */
const CHUNK_FRAME_BYTES = 12;
const CHANNELS: Readonly<Record<number, number>> = { 0: 1, 2: 3, 3: 1, 4: 2, 6: 4 };

/** Chunks without which there is no picture. Others can be packed too, and unpack to anything. */
const NEEDED = new Set(["IHDR", "PLTE", "tRNS", "IDAT", "IEND"]);

/**
 * A PNG without all that is not its picture.
 *
 * @throws {RtViewerError} if it has more texels than are read, or its data does not fit its header.
 */
export function checkPng(bytes: Uint8Array): Uint8Array {
  const chunks = chunksOf(bytes).filter(({ type }) => NEEDED.has(type));
  const header = chunks.find(({ type }) => type === "IHDR");
  if (header === undefined || header.data.length < 13) throw new RtViewerError("its header is damaged");
  const view = new DataView(header.data.buffer, header.data.byteOffset);
  const [width, height, depth, colorType] = [view.getUint32(0), view.getUint32(4), view.getUint8(8), view.getUint8(9)];
  if (width * height > MAX_TEXELS) {
    throw new RtViewerError(`is ${width} × ${height}, which is more than ${MAX_TEXELS} texels`);
  }
  const rowBytes = Math.ceil((width * depth * (CHANNELS[colorType] ?? 1)) / 8);
  // Interlaced, a picture has up to 2 · height + 7 rows, each with a byte for its filter and one that is not full.
  const maxOutputLength = height * rowBytes + 2 * (2 * height + 7);
  const packed = Buffer.concat(chunks.filter(({ type }) => type === "IDAT").map(({ data }) => data));
  try {
    inflateSync(packed, { maxOutputLength });
  } catch (cause) {
    throw new RtViewerError(`its data is damaged, or more than ${width} × ${height} texels have`, { cause });
  }
  return Buffer.concat([bytes.subarray(0, SIGNATURE_BYTES), ...chunks.map(({ whole }) => whole)]);
}

type Chunk = { readonly type: string; readonly data: Uint8Array; readonly whole: Uint8Array };

/** As far as they are whole. */
function chunksOf(bytes: Uint8Array): Chunk[] {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const chunks: Chunk[] = [];
  for (let start = SIGNATURE_BYTES; start + CHUNK_FRAME_BYTES <= bytes.length; ) {
    const end = start + CHUNK_FRAME_BYTES + view.getUint32(start);
    if (end > bytes.length) break;
    const type = String.fromCharCode(...bytes.subarray(start + 4, start + 8));
    chunks.push({ type, data: bytes.subarray(start + 8, end - 4), whole: bytes.subarray(start, end) });
    start = end;
  }
  return chunks;
}
