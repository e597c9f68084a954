// PNG files of every kind, written by hand: encoders write few of them.
//
// [1] PNG specification, third edition

import { crc32, deflateSync } from "node:zlib";

export type PngKind = {
  readonly width: number;
  readonly height: number;
  /** Bits per value. */
  readonly depth: 1 | 2 | 4 | 8 | 16;
  /** 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGBA. */
  readonly colorType: 0 | 2 | 3 | 4 | 6;
  readonly isInterlaced?: boolean;
  /** Red, green, blue of each number. */
  readonly palette?: readonly number[];
  /** The bytes of the chunk tRNS. */
  readonly transparency?: readonly number[];
};

export const CHANNELS = { 0: 1, 2: 3, 3: 1, 4: 2, 6: 4 } as const;

const ADAM7 = [
  [0, 0, 8, 8],
  [4, 0, 8, 8],
  [0, 4, 4, 8],
  [2, 0, 4, 4],
  [0, 2, 2, 4],
  [1, 0, 2, 2],
  [0, 1, 1, 2],
] as const;

/** A file with these values, row by row, texel by texel. Its rows use all five filters in turn. */
export function pngOf(kind: PngKind, values: ArrayLike<number>): Uint8Array {
  const { width, height, depth, colorType, isInterlaced = false, palette, transparency } = kind;
  const channels = CHANNELS[colorType];
  const texelBytes = Math.max(1, (channels * depth) / 8);
  const data: number[] = [];
  for (const [left, top, stepX, stepY] of isInterlaced ? ADAM7 : [[0, 0, 1, 1]]) {
    let above: number[] | undefined;
    for (let y = top!; y < height && left! < width; y += stepY!) {
      const line: number[] = [];
      for (let x = left!; x < width; x += stepX!) {
        for (let channel = 0; channel < channels; channel++) line.push(values[channels * (y * width + x) + channel]!);
      }
      const bytes = packed(line, depth);
      data.push(...filtered(bytes, above, texelBytes, y % 5));
      above = bytes;
    }
  }
  return pngFile(
    [width, height],
    [depth, colorType, 0, 0, isInterlaced ? 1 : 0],
    [
      ...(palette === undefined ? [] : [chunk("PLTE", Uint8Array.from(palette))]),
      ...(transparency === undefined ? [] : [chunk("tRNS", Uint8Array.from(transparency))]),
      chunk("IDAT", deflateSync(Uint8Array.from(data))),
    ],
  );
}

/** A file of these chunks. `kind` is the rest of the header: depth, colour type, compression, filter, interlacing. */
export function pngFile(
  [width, height]: readonly [number, number],
  kind: readonly number[],
  chunks: readonly Uint8Array[],
): Uint8Array {
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set(kind, 8);
  const signature = Buffer.of(137, 80, 78, 71, 13, 10, 26, 10);
  return Buffer.concat([signature, chunk("IHDR", header), ...chunks, chunk("IEND", Buffer.alloc(0))]);
}

export function chunk(type: string, data: Uint8Array): Buffer {
  const body = Buffer.concat([Buffer.from(type), data]);
  const [length, checksum] = [Buffer.alloc(4), Buffer.alloc(4)];
  length.writeUInt32BE(data.length);
  checksum.writeUInt32BE(crc32(body));
  return Buffer.concat([length, body, checksum]);
}

/** [1] 7.2 */
function packed(values: readonly number[], depth: number): number[] {
  if (depth === 16) return values.flatMap((value) => [value >> 8, value & 255]);
  const perByte = 8 / depth;
  const bytes = Array<number>(Math.ceil(values.length / perByte)).fill(0);
  values.forEach((value, i) => {
    bytes[Math.floor(i / perByte)]! |= value << (8 - depth * ((i % perByte) + 1));
  });
  return bytes;
}

/** [1] 9.2 */
function filtered(line: readonly number[], above: readonly number[] | undefined, texelBytes: number, filter: number) {
  const predict = (i: number) => {
    const [a, b, c] = [line[i - texelBytes] ?? 0, above?.[i] ?? 0, above?.[i - texelBytes] ?? 0];
    const nearest = [a, b, c].sort((p, q) => Math.abs(a + b - c - p) - Math.abs(a + b - c - q))[0]!; // stable: a, b, c
    return [0, a, b, Math.floor((a + b) / 2), nearest][filter]!;
  };
  return [filter, ...line.map((byte, i) => (byte - predict(i)) & 255)];
}
