import type { Locator } from "@playwright/test";
import { decode } from "fast-png";

/** Bytes of a screenshot: `channels` per pixel, top row first. */
export type Picture = {
  readonly width: number;
  readonly height: number;
  readonly channels: number;
  readonly data: Uint8Array;
};

/** Left, top, right and bottom, in shares of a picture's size. */
export type Area = readonly [number, number, number, number];

/** What the page shows of an element. */
export async function pictureOf(element: Locator): Promise<Picture> {
  const { width, height, channels, data } = decode(await element.screenshot());
  return { width, height, channels, data: new Uint8Array(data) };
}

/** Mean of each colour, 0…255. */
export function meanColor(picture: Picture, [left, top, right, bottom]: Area = [0, 0, 1, 1]): [number, number, number] {
  const { width, height, channels, data } = picture;
  const sum: [number, number, number] = [0, 0, 0];
  let count = 0;
  for (let y = Math.floor(top * height); y < bottom * height; y++) {
    for (let x = Math.floor(left * width); x < right * width; x++) {
      for (const channel of [0, 1, 2] as const) sum[channel] += data[(y * width + x) * channels + channel]!;
      count += 1;
    }
  }
  return [sum[0] / count, sum[1] / count, sum[2] / count];
}

/** Standard deviation of all values: 0 for a picture of one grey. */
export function contrast({ data, channels }: Picture): number {
  const values = data.filter((_, index) => channels < 4 || index % channels !== 3);
  const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
  return Math.sqrt(values.reduce((sum, value) => sum + (value - mean) ** 2, 0) / values.length);
}

/** Mean absolute difference of two pictures of the same size, 0…255. */
export function difference(a: Picture, b: Picture): number {
  if (a.data.length !== b.data.length) return 255;
  return a.data.reduce((sum, value, index) => sum + Math.abs(value - b.data[index]!), 0) / a.data.length;
}
