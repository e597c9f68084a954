import { FEATURE_NAMES } from "../../demo/features/list";
import type { RtViewerElement } from "../../src/element";
import { contrast, difference, meanColor, pictureOf } from "./support/picture";
import { expect, test } from "./support/test";
import { DEMO_URL } from "./support/urls";
import { waitForSamples } from "./support/viewer";

// As on a phone, where the picture is small and quickly made.
test.use({ viewport: { width: 390, height: 844 } });

const address = (name: string) => `${DEMO_URL}features/${name}.html`;

// What these pages show takes about 17 s to compile and to sample twice on two cores of a software adapter; all others keep to the time
// that every expectation has.
const SLOW = new Set(["glass", "fabrics-and-coats"]);
const SLOW_MS = 60_000;

for (const name of FEATURE_NAMES) {
  test(`the code of ${name} makes a picture`, async ({ page }) => {
    if (SLOW.has(name)) test.setTimeout(2 * SLOW_MS);
    await page.goto(address(name));
    for (const viewer of await page.locator("rt-viewer").all()) {
      await viewer.scrollIntoViewIfNeeded();
      await waitForSamples(viewer, 2, SLOW.has(name) ? SLOW_MS : undefined);
      expect(await viewer.evaluate((element: RtViewerElement) => element.stats?.badSamples)).toBe(0);
      expect(contrast(await pictureOf(viewer))).toBeGreaterThan(5);
    }
  });
}

test("white balls vanish once no light is lost", async ({ page }) => {
  await page.goto(address("energy"));
  const viewer = page.locator("rt-viewer");
  // How much darker the middle of the roughest ball is than what is behind it, 0…255.
  const loss = async () => {
    const picture = await pictureOf(viewer);
    return meanColor(picture, [0.4, 0.1, 0.6, 0.2])[0] - meanColor(picture, [0.85, 0.45, 0.91, 0.55])[0];
  };
  await waitForSamples(viewer, 4);
  expect(await loss()).toBeGreaterThan(20);
  await page.getByRole("checkbox").check();
  await expect.poll(async () => Math.abs(await loss())).toBeLessThan(4);
});

test("more bounces give more light", async ({ page }) => {
  await page.goto(address("bounces"));
  const viewer = page.locator("rt-viewer");
  const brightness = async () => meanColor(await pictureOf(viewer))[0];
  await waitForSamples(viewer, 4);
  const all = await brightness();
  await page.getByLabel("Bounces").fill("1");
  await expect.poll(brightness).toBeLessThan(0.8 * all);
});

test("the sliders focus the lens, open and close it", async ({ page }) => {
  await page.goto(address("lens"));
  const viewer = page.locator("rt-viewer");
  const lensOf = () => viewer.evaluate(({ camera }: RtViewerElement) => [camera?.focusDistance, camera?.aperture]);
  await waitForSamples(viewer, 1);
  expect(await lensOf()).toEqual([0.5, 0.012]);
  await page.getByLabel("Focus").fill("0.8");
  await page.getByLabel("Aperture").fill("0");
  expect(await lensOf()).toEqual([0.8, 0]);
  await page.getByLabel("Aperture").fill("0.02");
  expect(await lensOf()).toEqual([0.8, 0.02]);
});

test("parallel rays turn into a perspective, and back", async ({ page }) => {
  await page.goto(address("orthographic"));
  const viewer = page.locator("rt-viewer");
  const heightOf = () => viewer.evaluate(({ camera }: RtViewerElement) => camera?.orthographicHeight);
  await waitForSamples(viewer, 1);
  const height = await heightOf();
  expect(height).toBeGreaterThan(1);
  const before = await pictureOf(viewer);
  await page.getByRole("checkbox").uncheck();
  expect(await heightOf()).toBeUndefined();
  await expect.poll(async () => difference(before, await pictureOf(viewer))).toBeGreaterThan(10);
  await page.getByRole("checkbox").check();
  expect(await heightOf()).toBe(height);
});

test("a feature's scene opens in the playground as it stands", async ({ page }) => {
  await page.goto(address("soft-shadows"));
  await page.getByLabel("Radius of the lamp").fill("1.25");
  await page.getByRole("link", { name: "Change it in the playground" }).click();
  await expect(page).toHaveURL(/playground\.html#scene=/);
  await expect(page.locator(".cm-content")).toContainText('"radius": 1.25');
});

test("the list leads to every feature, and each to the next", async ({ page }) => {
  await page.addInitScript(() => {
    GPU.prototype.requestAdapter = () => new Promise(() => {});
  });
  await page.goto(`${DEMO_URL}features.html`);
  await expect(page.locator(".cards a")).toHaveCount(FEATURE_NAMES.length);
  for (const image of await page.locator(".cards img").all()) {
    await image.scrollIntoViewIfNeeded();
    await expect.poll(() => image.evaluate((element: HTMLImageElement) => element.naturalWidth)).toBe(640);
  }
  await page.locator(".cards a").first().click();
  for (const name of FEATURE_NAMES.slice(1)) {
    await page.getByRole("navigation", { name: "Features" }).getByRole("link", { name: "Next" }).click();
    await expect(page).toHaveURL(address(name));
  }
});
