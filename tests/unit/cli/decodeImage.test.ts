import { crc32, deflateSync } from "node:zlib";
import { encode } from "fast-png";
import { encode as encodeJpeg } from "jpeg-js";
import { describe, expect, test } from "vitest";
import { decodeImage } from "../../../src/cli/decodeImage";

describe("PNG", () => {
  const pixels = {
    1: [Uint8Array.of(7, 9), [7, 7, 7, 255, 9, 9, 9, 255]],
    2: [Uint8Array.of(7, 100, 9, 0), [7, 7, 7, 100, 9, 9, 9, 0]],
    3: [Uint8Array.of(1, 2, 3, 4, 5, 6), [1, 2, 3, 255, 4, 5, 6, 255]],
    4: [Uint8Array.of(1, 2, 3, 4, 5, 6, 7, 0), [1, 2, 3, 4, 5, 6, 7, 0]],
  } as const;

  test.each([1, 2, 3, 4] as const)("of %i channels becomes RGBA", async (channels) => {
    const [data, expected] = pixels[channels];
    const image = await decodeImage(encode({ width: 2, height: 1, channels, data }), "image/png");
    expect(image).toMatchObject({ width: 2, height: 1 });
    expect([...image.texels]).toEqual(expected);
  });

  test("of 16 bits keeps the upper eight", async () => {
    const data = Uint16Array.of(0x1234, 0x5678, 0x9abc);
    const image = await decodeImage(encode({ width: 1, height: 1, channels: 3, depth: 16, data }), "image/png");
    expect([...image.texels]).toEqual([0x12, 0x56, 0x9a, 255]);
  });
});

test("JPEG becomes RGBA, near to what it was", async () => {
  const data = new Uint8Array(8 * 8 * 4).map((_, i) => [200, 100, 50, 255][i % 4]!);
  const { width, height, texels } = await decodeImage(encodeJpeg({ width: 8, height: 8, data }, 95).data, "image/jpeg");
  expect([width, height, texels.length]).toEqual([8, 8, 256]);
  const differences = texels.map((value, i) => Math.abs(value - data[i]!));
  expect(Math.max(...differences)).toBeLessThan(4);
});

test("other formats, and damage, are errors", async () => {
  await expect(decodeImage(new Uint8Array(20), "image/webp")).rejects.toThrow(
    "image/webp can be decoded in a browser only",
  );
  await expect(decodeImage(new Uint8Array(20), "image/png")).rejects.toThrow();
  await expect(decodeImage(new Uint8Array(20), "image/jpeg")).rejects.toThrow();
});

describe("a small file that would become a large picture", () => {
  // Of a processor: a hundred megabytes of zeros take 30 ms to unpack, and a second to be spread to RGBA.
  const QUICK_MS = 300;

  async function quickly(act: () => Promise<unknown>, complaint: string | RegExp): Promise<void> {
    const start = process.cpuUsage();
    const memory = process.memoryUsage().arrayBuffers;
    await expect(act()).rejects.toThrow(complaint);
    expect(process.cpuUsage(start).user / 1000).toBeLessThan(QUICK_MS);
    expect(process.memoryUsage().arrayBuffers - memory).toBeLessThan(50e6);
  }

  const bomb = deflateSync(new Uint8Array(1e8));

  test("by its header", async () => {
    const file = png([30000, 30000], deflateSync(new Uint8Array(3e6)));
    await quickly(() => decodeImage(file, "image/png"), "is 30000 × 30000, which is more than 67108864 texels");
  });

  test("by data that its header does not speak of", async () => {
    await quickly(() => decodeImage(png([16, 16], bomb), "image/png"), "more than 16 × 16 texels have");
  });

  test("by a colour profile, which is not looked at", async () => {
    const data = encode({ width: 1, height: 1, channels: 3, data: Uint8Array.of(1, 2, 3) });
    const profile = chunk("iCCP", Buffer.concat([Buffer.from("x\0\0"), bomb]));
    const file = Buffer.concat([data.subarray(0, 33), profile, data.subarray(33)]);
    const start = process.cpuUsage();
    expect([...(await decodeImage(file, "image/png")).texels]).toEqual([1, 2, 3, 255]);
    expect(process.cpuUsage(start).user / 1000).toBeLessThan(QUICK_MS);
  });

  test("by a JPEG's header", async () => {
    const { data } = encodeJpeg({ width: 8, height: 8, data: new Uint8Array(256) }, 50);
    const size = data.indexOf(Buffer.of(0xff, 0xc0)) + 5;
    data.writeUInt16BE(60000, size);
    data.writeUInt16BE(60000, size + 2);
    await quickly(() => decodeImage(data, "image/jpeg"), /limit exceeded/);
  });
});

test("a JPEG that goes through its picture a thousand times is refused", async () => {
  const { data } = encodeJpeg({ width: 8, height: 8, data: new Uint8Array(256) }, 50);
  const scan = data.subarray(data.lastIndexOf(Buffer.of(0xff, 0xda)), -2);
  const file = Buffer.concat([data.subarray(0, -2), ...Array<Uint8Array>(1000).fill(scan), data.subarray(-2)]);
  await expect(decodeImage(file, "image/jpeg")).rejects.toThrow("has more than 100 scans");
});

test("an interlaced PNG may have more rows than its height", async () => {
  // Adam7 of one column: passes 1, 3, 5 and 7 have rows of one texel, each after the byte of its filter.
  const rows = [0, 8, 4, 2, 6, 10, 1, 3, 5, 7, 9, 11];
  const data = Buffer.concat(rows.map((row) => Buffer.of(0, 10 * row)));
  const { texels } = await decodeImage(png([1, 12], deflateSync(data), 1), "image/png");
  expect([...texels.filter((_, i) => i % 4 === 0)]).toEqual(Array.from({ length: 12 }, (_, row) => 10 * row));
});

/** Grey, of eight bits. */
function png([width, height]: readonly [number, number], data: Uint8Array, interlace = 0): Uint8Array {
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set([8, 0, 0, 0, interlace], 8);
  const signature = Buffer.of(137, 80, 78, 71, 13, 10, 26, 10);
  return Buffer.concat([signature, chunk("IHDR", header), chunk("IDAT", data), chunk("IEND", Buffer.alloc(0))]);
}

function chunk(type: string, data: Uint8Array): Buffer {
  const body = Buffer.concat([Buffer.from(type), data]);
  const [length, checksum] = [Buffer.alloc(4), Buffer.alloc(4)];
  length.writeUInt32BE(data.length);
  checksum.writeUInt32BE(crc32(body));
  return Buffer.concat([length, body, checksum]);
}
