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
