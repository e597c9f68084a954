import { expect, test } from "vitest";
import { encodePfm } from "../../../src/renderer/encodePfm";

test("a PFM is a header and little-endian RGB, bottom row first", () => {
  const alpha = 1;
  // biome-ignore format: a picture, two pixels wide and three high
  const radiance = new Float32Array([
     1,  2,  3, alpha,    4,  5,    6, alpha,
     7,  8,  9, alpha,   10, 11,   12, alpha,
    13, 14, 15, alpha, 1e20,  0, 0.25, alpha,
  ]);
  const file = encodePfm(radiance, 2, 3);

  const header = "PF\n2 3\n-1.0\n";
  expect(new TextDecoder().decode(file.subarray(0, header.length))).toBe(header);
  const view = new DataView(file.buffer, header.length);
  const floats = Array.from({ length: view.byteLength / 4 }, (_, i) => view.getFloat32(4 * i, true));
  expect(floats).toEqual([13, 14, 15, Math.fround(1e20), 0, 0.25, 7, 8, 9, 10, 11, 12, 1, 2, 3, 4, 5, 6]);
});
