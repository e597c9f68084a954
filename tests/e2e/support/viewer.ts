import type { Locator, Page } from "@playwright/test";
import type { RtViewerElement } from "../../../src/element";
import { expect } from "./test";
import { FIXTURE_URL } from "./urls";

/** Opens the empty page on which `rt-viewer` is defined. */
export async function openFixture(page: Page): Promise<void> {
  await page.goto(FIXTURE_URL);
  await page.evaluate(() => customElements.whenDefined("rt-viewer"));
}

/** Adds a viewer to the page. An attribute without a value is `""`. */
export async function addViewer(page: Page, attributes: Readonly<Record<string, string>>): Promise<Locator> {
  await page.evaluate((given) => {
    const viewer = document.createElement("rt-viewer");
    for (const [name, value] of Object.entries(given)) viewer.setAttribute(name, value);
    document.body.append(viewer);
  }, attributes);
  return page.locator("rt-viewer").last();
}

/** Opens the page with one viewer on it and waits until its picture is shown, with some samples: it has said `ready`. */
export async function openViewer(
  page: Page,
  attributes: Readonly<Record<string, string>>,
  samples = 1,
): Promise<Locator> {
  await openFixture(page);
  const viewer = await addViewer(page, attributes);
  await waitForSamples(viewer, samples);
  // A sample is counted when the GPU has made it, and `ready`, which hides the bar, comes with the frame that draws it.
  await expect(viewer.getByRole("progressbar")).toBeHidden();
  return viewer;
}

/** Samples per pixel in the picture; 0 before there is one. */
export function samplesOf(viewer: Locator): Promise<number> {
  return viewer.evaluate((element: RtViewerElement) => element.stats?.samples ?? 0);
}

/** @param timeout - in milliseconds; by default that of every expectation. */
export async function waitForSamples(viewer: Locator, samples: number, timeout?: number): Promise<void> {
  const options = { intervals: [50], ...(timeout !== undefined && { timeout }) };
  await expect.poll(() => samplesOf(viewer), options).toBeGreaterThanOrEqual(samples);
}

/** Rests the picture, so that two screenshots of it are equal unless something changes it. */
export async function pause(viewer: Locator): Promise<void> {
  await viewer.evaluate((element: RtViewerElement) => element.toggleAttribute("paused", true));
}
