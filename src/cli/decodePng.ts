// PNG of every kind, to eight bits as Chromium has them: of sixteen bits it keeps the upper eight.
//
// [1] PNG specification, third edition: 5.3 chunks, 7.2 scanlines, 8.1 interlacing, 9 filters, 11.2.1 header, 11.3.1.1 tRNS

import { crc32, inflateSync } from "node:zlib";
import { RtViewerError } from "../errors";
import type { DecodedImage } from "../loaders/loadedScene";
import { MAX_PICTURE_TEXELS } from "../loaders/pictureLimits";
import { keep } from "../scene/keptBytes";

const SIGNATURE_BYTES = 8;
/** Length, type and checksum. */
const CHUNK_FRAME_BYTES = 12;
/** Some writers leave a few bytes behind the last row. */
const MAX_EXCESS_BYTES = 2 ** 16;

/** By colour type: values per texel, and how many bits one may have. [1] table 12 */
const KINDS: Readonly<Record<number, { readonly channels: number; readonly depths: readonly number[] }>> = {
  0: { channels: 1, depths: [1, 2, 4, 8, 16] },
  2: { channels: 3, depths: [8, 16] },
  3: { channels: 1, depths: [1, 2, 4, 8] },
  4: { channels: 2, depths: [8, 16] },
  6: { channels: 4, depths: [8, 16] },
};
const PALETTE = 3;

/** Where a pass of an interlaced picture begins, and how far apart its texels are. [1] 8.1 */
type Pass = { readonly x: number; readonly y: number; readonly stepX: number; readonly stepY: number };
const WHOLE: readonly Pass[] = [{ x: 0, y: 0, stepX: 1, stepY: 1 }];
const ADAM7: readonly Pass[] = [
  { x: 0, y: 0, stepX: 8, stepY: 8 },
  { x: 4, y: 0, stepX: 8, stepY: 8 },
  { x: 0, y: 4, stepX: 4, stepY: 8 },
  { x: 2, y: 0, stepX: 4, stepY: 4 },
  { x: 0, y: 2, stepX: 2, stepY: 4 },
  { x: 1, y: 0, stepX: 2, stepY: 2 },
  { x: 0, y: 1, stepX: 1, stepY: 2 },
];

type Header = {
  readonly width: number;
  readonly height: number;
  readonly depth: number;
  readonly colorType: number;
  readonly channels: number;
  readonly passes: readonly Pass[];
};

/** @throws {RtViewerError} if it is damaged, or has more texels than are read, before memory is taken. */
export function decodePng(bytes: Uint8Array): DecodedImage {
  const chunks = chunksOf(bytes);
  const header = headerOf(chunks);
  const { width, height, channels, depth, passes } = header;
  const data = inflate(chunks, header);
  const texels = new Uint8Array(4 * width * height);
  const write = texelWriter(header, chunks, texels);
  const texelBytes = Math.max(1, (channels * depth) / 8);
  let start = 0;
  for (const pass of passes) {
    const { columns, rows, rowBytes } = sizeOfPass(pass, header);
    let above: Uint8Array | undefined;
    for (let row = 0; row < rows; row++) {
      const line = data.subarray(start + 1, start + 1 + rowBytes);
      unfilter(data[start]!, line, above, texelBytes);
      const first = (pass.y + row * pass.stepY) * width + pass.x;
      for (let column = 0; column < columns; column++) write(line, column, 4 * (first + column * pass.stepX));
      above = line;
      start += 1 + rowBytes;
    }
  }
  return { width, height, texels: keep(texels) };
}

type Chunk = { readonly type: string; readonly data: Uint8Array };

/** @throws {RtViewerError} if it is cut off, or a chunk that matters has another checksum than it says: Chromium refuses both. */
function chunksOf(bytes: Uint8Array): Chunk[] {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const chunks: Chunk[] = [];
  for (let start = SIGNATURE_BYTES; start + CHUNK_FRAME_BYTES <= bytes.length; ) {
    const end = start + CHUNK_FRAME_BYTES + view.getUint32(start);
    if (end > bytes.length) break;
    const type = String.fromCharCode(...bytes.subarray(start + 4, start + 8));
    const isNeeded = /^[A-Z]/.test(type);
    if (isNeeded && crc32(bytes.subarray(start + 4, end - 4)) !== view.getUint32(end - 4)) {
      throw new RtViewerError("its data is damaged");
    }
    chunks.push({ type, data: bytes.subarray(start + 8, end - 4) });
    if (type === "IEND") return chunks;
    start = end;
  }
  throw new RtViewerError("it is cut off");
}

function headerOf(chunks: readonly Chunk[]): Header {
  const [first] = chunks;
  if (first?.type !== "IHDR" || first.data.length !== 13) throw new RtViewerError("its header is damaged");
  const view = new DataView(first.data.buffer, first.data.byteOffset);
  const [width, height] = [view.getUint32(0), view.getUint32(4)];
  const [depth, colorType, compression, filter, interlace] = [...first.data.subarray(8)];
  const kind = KINDS[colorType!];
  const isKnown = kind?.depths.includes(depth!) && compression === 0 && filter === 0 && interlace! <= 1;
  if (!isKnown || width === 0 || height === 0) throw new RtViewerError("its header is damaged");
  if (width * height > MAX_PICTURE_TEXELS) {
    throw new RtViewerError(`is ${width} × ${height}, which is more than ${MAX_PICTURE_TEXELS} texels`);
  }
  const passes = interlace === 1 ? ADAM7 : WHOLE;
  return { width, height, depth: depth!, colorType: colorType!, channels: kind!.channels, passes };
}

function sizeOfPass({ x, y, stepX, stepY }: Pass, { width, height, channels, depth }: Omit<Header, "passes">) {
  const columns = Math.max(0, Math.ceil((width - x) / stepX));
  const rows = columns === 0 ? 0 : Math.max(0, Math.ceil((height - y) / stepY));
  return { columns, rows, rowBytes: Math.ceil((columns * channels * depth) / 8) };
}

/** Its rows, each after the byte of its filter. */
function inflate(chunks: readonly Chunk[], header: Header): Uint8Array {
  const { width, height, passes } = header;
  const sizes = passes.map((pass) => sizeOfPass(pass, header));
  const byteCount = sizes.reduce((sum, { rows, rowBytes }) => sum + rows * (1 + rowBytes), 0);
  const packed = Buffer.concat(chunks.filter(({ type }) => type === "IDAT").map(({ data }) => data));
  let data: Uint8Array;
  try {
    data = inflateSync(packed, { maxOutputLength: byteCount + MAX_EXCESS_BYTES });
  } catch (cause) {
    throw new RtViewerError(`its data is damaged, or more than ${width} × ${height} texels have`, { cause });
  }
  if (data.length >= byteCount) return data;
  throw new RtViewerError(`its data is less than ${width} × ${height} texels have`);
}

/** Undoes a row's filter, in place. [1] 9.2 */
function unfilter(filter: number, line: Uint8Array, above: Uint8Array | undefined, texelBytes: number): void {
  if (filter === 0) return;
  if (filter > 4) throw new RtViewerError("its data is damaged");
  for (let i = 0; i < line.length; i++) {
    const a = i < texelBytes ? 0 : line[i - texelBytes]!;
    const b = above === undefined ? 0 : above[i]!;
    if (filter === 1) line[i]! += a;
    else if (filter === 2) line[i]! += b;
    else if (filter === 3) line[i]! += (a + b) >> 1;
    else line[i]! += paeth(a, b, i < texelBytes || above === undefined ? 0 : above[i - texelBytes]!);
  }
}

/** [1] 9.4 */
function paeth(a: number, b: number, c: number): number {
  const [fromA, fromB, fromC] = [Math.abs(b - c), Math.abs(a - c), Math.abs(a + b - 2 * c)];
  if (fromA <= fromB && fromA <= fromC) return a;
  return fromB <= fromC ? b : c;
}

/** Reads a texel of a row, and writes it as RGBA from byte `to` on. */
type TexelWriter = (line: Uint8Array, column: number, to: number) => void;

function texelWriter(header: Header, chunks: readonly Chunk[], texels: Uint8Array): TexelWriter {
  const { depth, colorType, channels } = header;
  const dataOf = (name: string) => chunks.find(({ type }) => type === name)?.data;
  const transparency = dataOf("tRNS");
  if (colorType === PALETTE) return paletteWriter(depth, dataOf("PLTE"), transparency, texels);
  // What is transparent: a grey or a colour, two bytes a value whatever the depth.
  const key =
    channels % 2 === 1 && transparency?.length === 2 * channels
      ? Array.from({ length: channels }, (_, i) => 256 * transparency[2 * i]! + transparency[2 * i + 1]!)
      : undefined;
  const [green, blue] = channels < 3 ? [0, 0] : [1, 2];
  const hasAlpha = channels % 2 === 0;
  return (line, column, to) => {
    const from = column * channels;
    texels[to] = byteAt(line, from, depth);
    texels[to + 1] = byteAt(line, from + green, depth);
    texels[to + 2] = byteAt(line, from + blue, depth);
    const isTransparent = key?.every((value, i) => valueAt(line, from + i, depth) === value);
    texels[to + 3] = hasAlpha ? byteAt(line, from + channels - 1, depth) : isTransparent ? 0 : 255;
  };
}

/** A number without a colour is black. */
function paletteWriter(
  depth: number,
  palette: Uint8Array | undefined,
  alphas: Uint8Array | undefined,
  texels: Uint8Array,
): TexelWriter {
  if (palette === undefined) throw new RtViewerError("it has no palette");
  return (line, column, to) => {
    const number = valueAt(line, column, depth);
    for (let i = 0; i < 3; i++) texels[to + i] = palette[3 * number + i] ?? 0;
    texels[to + 3] = alphas?.[number] ?? 255;
  };
}

/** The i-th value of a row, as stored. */
function valueAt(line: Uint8Array, i: number, depth: number): number {
  if (depth === 8) return line[i]!;
  if (depth === 16) return 256 * line[2 * i]! + line[2 * i + 1]!;
  const bit = i * depth;
  return (line[bit >> 3]! >> (8 - depth - (bit & 7))) & ((1 << depth) - 1);
}

/** The same, from 0 to 255. */
function byteAt(line: Uint8Array, i: number, depth: number): number {
  if (depth === 8) return line[i]!;
  if (depth === 16) return line[2 * i]!;
  return (valueAt(line, i, depth) * 255) / ((1 << depth) - 1);
}
