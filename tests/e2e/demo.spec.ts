import type { RtViewerElement } from "../../src/element";
import { contrast, pictureOf } from "./support/picture";
import { expect, test } from "./support/test";
import { DEMO_URL } from "./support/urls";

test("the gallery's six viewers become ready and show something", async ({ page }) => {
  test.setTimeout(150_000);
  await page.goto(DEMO_URL);
  const viewers = page.locator("rt-viewer");
  await expect(viewers).toHaveCount(6);
  for (const viewer of await viewers.all()) {
    await viewer.scrollIntoViewIfNeeded();
    const stats = () => viewer.evaluate((element: RtViewerElement) => element.stats);
    await expect.poll(async () => (await stats())?.samples ?? 0, { timeout: 60_000 }).toBeGreaterThanOrEqual(1);
    expect((await stats())?.badSamples).toBe(0);
    await expect(viewer.getByRole("alert")).toBeHidden();
    await expect(viewer.getByText(/% error|– error/).first()).toBeVisible();
    expect(contrast(await pictureOf(viewer))).toBeGreaterThan(10);
  }
});

test("on a software adapter one viewer computes at a time", async ({ page }) => {
  await page.goto(DEMO_URL);
  await expect(page.locator("#adapter")).toContainText(/Running on/, { timeout: 30_000 });
  const running = () => page.locator("rt-viewer:not([paused])").count();
  await expect.poll(running).toBe(1);
});

for (const width of [360, 1280]) {
  test(`nothing sticks out of a page ${width} px wide`, async ({ page }) => {
    await page.setViewportSize({ width, height: 800 });
    await page.goto(DEMO_URL);
    const overflow = () => page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    expect(await overflow()).toBeLessThanOrEqual(0);
  });
}
