import { chunk } from "./png";

/** Exif metadata that says nothing but how a picture is turned: 6 is a quarter clockwise. */
function exif(orientation: number): Buffer {
  const tiff = Buffer.alloc(26);
  tiff.write("MM\0*", "latin1");
  tiff.writeUInt32BE(8, 4); // where its one directory is
  tiff.writeUInt16BE(1, 8); // of one entry
  tiff.writeUInt16BE(0x0112, 10);
  tiff.writeUInt16BE(3, 12); // a short
  tiff.writeUInt32BE(1, 14);
  tiff.writeUInt16BE(orientation, 18);
  return tiff;
}

export function turnedJpeg(jpeg: Uint8Array, orientation: number): Uint8Array {
  const body = Buffer.concat([Buffer.from("Exif\0\0"), exif(orientation)]);
  const head = Buffer.of(0xff, 0xe1, 0, body.length + 2);
  return Buffer.concat([jpeg.subarray(0, 2), head, body, jpeg.subarray(2)]);
}

export function turnedPng(png: Uint8Array, orientation: number): Uint8Array {
  const headerEnd = 8 + 25;
  return Buffer.concat([png.subarray(0, headerEnd), chunk("eXIf", exif(orientation)), png.subarray(headerEnd)]);
}

/** @param webp - a simple one, of a single chunk. */
export function turnedWebp(
  webp: Uint8Array,
  [width, height]: readonly [number, number],
  orientation: number,
): Uint8Array {
  const extended = Buffer.alloc(10);
  extended[0] = 8; // has Exif metadata
  extended.writeUIntLE(width - 1, 4, 3);
  extended.writeUIntLE(height - 1, 7, 3);
  const body = Buffer.concat([
    Buffer.from("WEBP"),
    riffChunk("VP8X", extended),
    webp.subarray(12),
    riffChunk("EXIF", exif(orientation)),
  ]);
  return riffChunk("RIFF", body);
}

function riffChunk(name: string, data: Uint8Array): Buffer {
  const head = Buffer.alloc(8);
  head.write(name, "latin1");
  head.writeUInt32LE(data.length, 4);
  return Buffer.concat([head, data, Buffer.alloc(data.length % 2)]);
}
