import { encode } from "fast-png";
import { encode as encodeJpeg } from "jpeg-js";
import { expect, test } from "vitest";
import { withoutExif } from "../../../src/loaders/withoutExif";
import { turnedJpeg, turnedPng, turnedWebp } from "../../support/exif";
import { smallPicture } from "../../support/smallPictures";

const joined = async (bytes: Uint8Array, type: string) =>
  new Uint8Array(await new Blob(withoutExif(bytes as Uint8Array<ArrayBuffer>, type)).arrayBuffer());
const has = (bytes: Uint8Array, text: string) => Buffer.from(bytes).includes(text);

const JPEG: Uint8Array = encodeJpeg({ width: 8, height: 8, data: new Uint8Array(256) }, 90).data;
const PNG = encode({ width: 2, height: 1, channels: 3, data: new Uint8Array(6) });
const WEBP = smallPicture("losslessWebp");

test("a JPEG's segment and a PNG's chunk are cut out", async () => {
  expect(Buffer.compare(await joined(turnedJpeg(JPEG, 6), "image/jpeg"), JPEG)).toBe(0);
  expect(Buffer.compare(await joined(turnedPng(PNG, 6), "image/png"), PNG)).toBe(0);
});

test("a WebP's chunk gets a name that no decoder knows, and the file keeps its length", async () => {
  const turned = turnedWebp(WEBP, [12, 10], 6);
  const bytes = await joined(turned, "image/webp");
  expect(bytes.length).toBe(turned.length);
  expect([has(turned, "EXIF"), has(bytes, "EXIF"), has(bytes, "none")]).toEqual([true, false, true]);
});

test("what has none is as it was, and so is what is cut off anywhere", async () => {
  for (const [bytes, type] of [
    [JPEG, "image/jpeg"],
    [PNG, "image/png"],
    [WEBP, "image/webp"],
  ] as const) {
    for (let length = 0; length <= bytes.length; length++) {
      const start = bytes.subarray(0, length);
      expect(Buffer.compare(await joined(start, type), start)).toBe(0);
    }
  }
});
