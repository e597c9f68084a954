import { deflateSync } from "node:zlib";
import { encode } from "fast-png";
import { encode as encodeJpeg } from "jpeg-js";
import { describe, expect, test } from "vitest";
import { decodeImage } from "../../../src/cli/decodeImage";
import { chunk, pngFile } from "../../support/png";
import { pngCases } from "../../support/pngKinds";
import { smallPicture, texelsOfSmallPictures } from "../../support/smallPictures";

describe("PNG", () => {
  test.each(pngCases(1))("$name becomes RGBA", async ({ file, texels }) => {
    const image = await decodeImage(file, "image/png");
    expect(image).toMatchObject({ width: 13, height: 11 });
    expect([...image.texels]).toEqual([...texels]);
  });

  test("of another encoder is the same", async () => {
    const data = Uint8Array.from({ length: 4 * 40 * 30 }, (_, i) => (i * i) >> 4);
    const image = await decodeImage(encode({ width: 40, height: 30, channels: 4, data }), "image/png");
    expect([...image.texels]).toEqual([...data]);
  });

  test.each([
    ["without a palette", pngFile([1, 1], [8, 3, 0, 0, 0], [chunk("IDAT", deflateSync(Uint8Array.of(0, 0)))])],
    ["of three bits", pngFile([1, 1], [3, 0, 0, 0, 0], [chunk("IDAT", deflateSync(Uint8Array.of(0, 0)))])],
    [
      "of five rows where it has one",
      pngFile([1, 5], [8, 0, 0, 0, 0], [chunk("IDAT", deflateSync(Uint8Array.of(0, 0)))]),
    ],
    ["of an unknown filter", pngFile([1, 1], [8, 0, 0, 0, 0], [chunk("IDAT", deflateSync(Uint8Array.of(5, 0)))])],
    ["without data", pngFile([1, 1], [8, 0, 0, 0, 0], [])],
  ])("%s is an error", async (_, file) => {
    await expect(decodeImage(file, "image/png")).rejects.toMatchObject({ name: "RtViewerError" });
  });
});

test("JPEG becomes RGBA, near to what it was", async () => {
  const data = new Uint8Array(8 * 8 * 4).map((_, i) => [200, 100, 50, 255][i % 4]!);
  const { width, height, texels } = await decodeImage(encodeJpeg({ width: 8, height: 8, data }, 95).data, "image/jpeg");
  expect([width, height, texels.length]).toEqual([8, 8, 256]);
  const differences = texels.map((value, i) => Math.abs(value - data[i]!));
  expect(Math.max(...differences)).toBeLessThan(4);
});

test("lossless WebP is what it was, colours where it is transparent too", async () => {
  const image = await decodeImage(smallPicture("losslessWebp"), "image/webp");
  expect(image).toMatchObject({ width: 12, height: 10 });
  expect([...image.texels]).toEqual([...texelsOfSmallPictures()]);
});

test("what Chromium refuses is an error: a file that is cut off, even of its last bytes, and a wrong checksum", async () => {
  const data = new Uint8Array(16 * 16 * 4).map((_, i) => (i * i) >> 3);
  const jpeg: Uint8Array = encodeJpeg({ width: 16, height: 16, data }, 92).data;
  const png = encode({ width: 16, height: 16, channels: 4, data });
  for (const length of [jpeg.length - 2, jpeg.length - 40]) {
    await expect(decodeImage(jpeg.subarray(0, length), "image/jpeg")).rejects.toThrow("it is cut off");
  }
  await expect(decodeImage(png.subarray(0, png.length - 12), "image/png")).rejects.toThrow("it is cut off");
  const checksum = png.length - 12 - 4; // of the texels' chunk, before the last
  png[checksum]! ^= 1;
  await expect(decodeImage(png, "image/png")).rejects.toThrow("its data is damaged");
});

test("a JPEG that is cut off is an error, and leaves the decoder whole", async () => {
  const data = new Uint8Array(16 * 16 * 4).map((_, i) => [30, 200, 30, 255][i % 4]!);
  const file: Uint8Array = encodeJpeg({ width: 16, height: 16, data }, 92).data;
  const texel = async () => [...(await decodeImage(file, "image/jpeg")).texels.subarray(0, 4)];
  const before = await texel();
  await expect(decodeImage(file.subarray(0, 200), "image/jpeg")).rejects.toThrow();
  expect(await texel()).toEqual(before);
});

test.each([
  ["lossyWebp", "image/webp"],
  ["avif", "image/avif"],
] as const)("%s is near to what it was", async (name, type) => {
  const image = await decodeImage(smallPicture(name), type);
  expect(image).toMatchObject({ width: 12, height: 10 });
  const differences = texelsOfSmallPictures().map((value, i) => Math.abs(value - image.texels[i]!));
  // Colour has half the resolution of light, so near the edge of red it is mixed. On average the files are off by 5.
  expect(differences.reduce((sum, difference) => sum + difference) / differences.length).toBeLessThan(10);
});

test.each(["image/png", "image/jpeg", "image/webp", "image/avif", "image/gif"])(
  "damage of %s is an error",
  async (type) => {
    await expect(decodeImage(new Uint8Array(20), type)).rejects.toThrow();
  },
);

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
    await quickly(() => decodeImage(file, "image/png"), "is 30000 × 30000, which is more than 268435456 texels");
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
    await quickly(() => decodeImage(data, "image/jpeg"), "is 60000 × 60000, which is more than 268435456 texels");
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
function png(size: readonly [number, number], data: Uint8Array, interlace = 0): Uint8Array {
  return pngFile(size, [8, 0, 0, 0, interlace], [chunk("IDAT", data)]);
}
