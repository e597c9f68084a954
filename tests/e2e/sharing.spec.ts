import type { RtViewerElement } from "../../src/element";
import { countHoldings, holdingsOf } from "./support/counting";
import { report } from "./support/report";
import { expect, test } from "./support/test";
import { addViewer, openFixture, waitForSamples } from "./support/viewer";

const TINY = { src: "furnace.json", style: "width:64px;height:48px" };

test("ten viewers share one device, and the last one to go gives it back", async ({ page }) => {
  await countHoldings(page);
  await openFixture(page);
  for (let count = 0; count < 10; count++) await addViewer(page, { ...TINY, "max-samples": "2" });
  const viewers = page.locator("rt-viewer");
  for (let index = 0; index < 10; index++) await waitForSamples(viewers.nth(index), 2);
  const deviceCount = await page.evaluate(
    () => new Set([...document.querySelectorAll("rt-viewer")].map(({ tracer }) => tracer?.device)).size,
  );
  expect(deviceCount).toBe(1);
  expect(await holdingsOf(page)).toMatchObject({ devices: 1, devicesMade: 1 });

  await page.evaluate(() => {
    for (const viewer of [...document.querySelectorAll("rt-viewer")].slice(1)) viewer.remove();
  });
  await expect.poll(() => viewers.count()).toBe(1);
  const first = viewers.first();
  await first.evaluate((element: RtViewerElement) => {
    element.maxSamples = 4;
  });
  await waitForSamples(first, 4);
  expect(await holdingsOf(page)).toMatchObject({ devices: 1 });
  await first.evaluate((element) => element.remove());
  await expect.poll(() => holdingsOf(page)).toMatchObject({ devices: 0, gpuObjects: 0 });
});

test("200 viewers that came and went leave no GPU objects, no listeners and no observers", async ({ page }) => {
  await countHoldings(page);
  await openFixture(page);
  const before = await holdingsOf(page);
  const started = Date.now();
  const seen = await page.evaluate(async (attributes) => {
    // Two of each batch are let finish, eight are taken away about when they compile, the others while they fetch, or before.
    const seen = { readyCount: 0, gpuObjects: 0, listeners: 0 };
    const { holdings } = globalThis as unknown as { holdings: () => typeof seen };
    const frame = () => new Promise(requestAnimationFrame);
    for (let batch = 0; batch < 5; batch++) {
      const viewers = Array.from({ length: 40 }, (_, index) => {
        const viewer = document.createElement("rt-viewer");
        for (const [name, value] of Object.entries(attributes)) viewer.setAttribute(name, value);
        viewer.toggleAttribute("controls", index % 2 === 0);
        if (index % 4 === 1) viewer.loading = "lazy";
        document.body.append(viewer);
        return viewer;
      });
      const finished = viewers
        .slice(0, 2)
        .map((viewer) => new Promise((resolve) => viewer.addEventListener("ready", resolve, { once: true })));
      for (const viewer of viewers.slice(10, 25)) viewer.remove();
      for (const viewer of viewers.slice(25, 30)) document.body.prepend(viewer);
      for (const viewer of viewers.slice(30)) viewer.src = "bleed.json";
      await frame();
      for (const viewer of viewers.slice(10)) viewer.remove();
      for (let frames = 0; frames < 3; frames++) await frame();
      for (const viewer of viewers.slice(2, 10)) viewer.remove();
      await Promise.all(finished);
      const { gpuObjects, listeners } = holdings();
      seen.readyCount += finished.length;
      seen.gpuObjects = Math.max(seen.gpuObjects, gpuObjects);
      seen.listeners = Math.max(seen.listeners, listeners);
      for (const viewer of viewers) viewer.remove();
    }
    return seen;
  }, TINY);
  expect(seen.readyCount).toBe(10);
  expect(seen.gpuObjects).toBeGreaterThan(10);
  expect(seen.listeners).toBeGreaterThan(before.listeners + 10);
  await expect
    .poll(() => holdingsOf(page))
    .toMatchObject({ gpuObjects: 0, devices: 0, listeners: before.listeners, observers: before.observers });
  report("two-hundred-viewers", { seconds: (Date.now() - started) / 1000, ...(await holdingsOf(page)) });
});
