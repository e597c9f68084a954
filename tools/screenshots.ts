import { mkdir } from "node:fs/promises";
import { expect, type Page } from "@playwright/test";
import type { RtViewerElement } from "../src/element";
import { visitDemo } from "./demoSite";

const FOLDER = "docs/images/";
const QUALITY = 82;
const TIMEOUT_MS = 120_000;

type Screenshot = {
  readonly name: string;
  readonly path: string;
  readonly colorScheme?: "dark";
  /** Waits until the page shows what it is for. */
  readonly ready: (page: Page) => Promise<void>;
};

const SCREENSHOTS: readonly Screenshot[] = [
  { name: "gallery", path: "", ready: (page) => samples(page, 48) },
  {
    name: "playground",
    path: "playground.html",
    colorScheme: "dark",
    ready: async (page) => {
      await samples(page, 48);
      await page.locator(".cm-content").press("Control+Home");
    },
  },
  {
    name: "performance",
    path: "performance.html",
    ready: async (page) => {
      await expect(page.getByRole("button", { name: "Run again" })).toBeVisible({ timeout: TIMEOUT_MS });
      await page.locator(".race").evaluate((race) => race.scrollIntoView());
    },
  },
];

/** `npm run screenshots [-- NAME…]`: the pictures in the README and docs, of the demo as built, on the software adapter. */
export async function main(names: string[]): Promise<void> {
  await mkdir(FOLDER, { recursive: true });
  await visitDemo(async (browser, url) => {
    for (const { name, path, colorScheme = "light", ready } of SCREENSHOTS) {
      if (names.length > 0 && !names.includes(name)) continue;
      const page = await browser.newPage({ viewport: { width: 1280, height: 800 }, colorScheme });
      await page.goto(url + path);
      await ready(page);
      await page.screenshot({ path: `${FOLDER}${name}.jpg`, type: "jpeg", quality: QUALITY });
      await page.close();
      console.log(name);
    }
  });
}

/** Waits until the page's first picture has so many samples per pixel. */
async function samples(page: Page, count: number): Promise<void> {
  const viewer = page.locator("rt-viewer").first();
  const sampled = () => viewer.evaluate((element: RtViewerElement) => element.stats?.samples ?? 0);
  await expect.poll(sampled, { timeout: TIMEOUT_MS }).toBeGreaterThanOrEqual(count);
}
