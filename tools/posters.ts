import { writeFile } from "node:fs/promises";
import { expect, type Page } from "@playwright/test";
import { FEATURE_NAMES } from "../demo/features/list";
import { EXAMPLES } from "../demo/playground/examples";
import type { RtViewerElement } from "../src/element";
import { visitDemo } from "./demoSite";

const SIZE = { width: 640, height: 427 };
const SAMPLES = 64; // its noise is hardly more than what the compression leaves
const QUALITIES = [0.85, 0.75, 0.65]; // the first that is small enough
const MAX_BYTES = 40_000;
const TIMEOUT_MS = 120_000;
const MODELS = ["perfume"]; // of the gallery, made by code

/**
 * `npm run posters [-- NAME…]`: the pictures shown while a viewer loads, made by the viewers themselves on the pages they
 * are for. A page that says when its picture is done, by `max-samples` or `target-error`, is taken at its word.
 */
export async function main(names: string[]): Promise<void> {
  const places = [
    ...[...EXAMPLES.map(({ name }) => name), ...MODELS].map((name) => ({
      name,
      path: "",
      selector: `#${name} rt-viewer`,
    })),
    ...FEATURE_NAMES.map((name) => ({ name, path: `features/${name}.html`, selector: ".result rt-viewer" })),
  ];
  await visitDemo(async (browser, url) => {
    const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
    for (const { name, path, selector } of places) {
      if (names.length > 0 && !names.includes(name)) continue;
      await page.goto(url + path);
      const picture = await takePicture(page, selector);
      await writeFile(`demo/posters/${name}.webp`, picture);
      console.log(`${name}: ${(picture.length / 1000).toFixed(1)} kB`);
    }
  });
}

async function takePicture(page: Page, selector: string): Promise<Buffer> {
  const original = page.locator(selector).first();
  const hasScene = () =>
    original.evaluate((element: RtViewerElement) => element.dataset.model === undefined || element.scene !== undefined);
  await expect.poll(hasScene, { timeout: TIMEOUT_MS }).toBe(true);
  await original.evaluate(
    (element: RtViewerElement, { width, height, samples }) => {
      // A copy, alone: the page's scripts make its own viewers wait for each other.
      const copy = element.cloneNode() as RtViewerElement;
      copy.src ||= element.dataset.src ?? "";
      if (element.scene !== undefined) copy.scene = element.scene;
      copy.settings = element.settings;
      if (copy.maxSamples === Number.POSITIVE_INFINITY) copy.maxSamples = samples;
      copy.style.cssText = `position: fixed; inset: 0 auto auto 0; width: ${width}px; height: ${height}px`;
      document.body.replaceChildren(copy);
    },
    { ...SIZE, samples: SAMPLES },
  );
  const viewer = page.locator("rt-viewer");
  const isDone = () =>
    viewer.evaluate(
      ({ stats, tracer }: RtViewerElement, width) => stats?.converged === true && tracer?.width === width,
      SIZE.width,
    );
  await expect.poll(isDone, { timeout: TIMEOUT_MS }).toBe(true);
  const encoded = await viewer.evaluate(
    async (element: RtViewerElement, { qualities, maxBytes }) => {
      const { tracer, exposure } = element;
      const { width, height } = tracer!;
      const pixels = new Uint8ClampedArray(await tracer!.readPicture({ exposure }));
      const canvas = new OffscreenCanvas(width, height);
      canvas.getContext("2d")!.putImageData(new ImageData(pixels, width, height), 0, 0);
      let blob: Blob | undefined;
      for (const quality of qualities) {
        if (blob === undefined || blob.size > maxBytes)
          blob = await canvas.convertToBlob({ type: "image/webp", quality });
      }
      const bytes = new Uint8Array(await blob!.arrayBuffer());
      return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
    },
    { qualities: QUALITIES, maxBytes: MAX_BYTES },
  );
  return Buffer.from(encoded, "base64");
}
