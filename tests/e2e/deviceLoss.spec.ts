import type { RtViewerElement } from "../../src/element";
import { contrast, pictureOf } from "./support/picture";
import { expect, test } from "./support/test";
import { addViewer, openFixture, openViewer, waitForSamples } from "./support/viewer";

const SMALL = { src: "spheres.json", style: "width:160px;height:120px" };

test("20 lost devices in a row are survived, half of them lost before their first picture", async ({ page }) => {
  await page.addInitScript(() => {
    const { requestDevice } = GPUAdapter.prototype;
    GPUAdapter.prototype.requestDevice = async function (...args) {
      const device = await requestDevice.apply(this, args);
      (globalThis as unknown as { newest: GPUDevice }).newest = device;
      return device;
    };
  });
  const viewer = await openViewer(page, SMALL, 2);
  await viewer.evaluate((element: RtViewerElement) => {
    element.camera = { position: [2, 1, 6], target: [0, 0.5, 0] };
  });
  const counts = await viewer.evaluate(async (element: RtViewerElement) => {
    const page = globalThis as unknown as { newest: GPUDevice };
    const counts: number[] = [];
    let onCount = () => {};
    element.addEventListener("devicelost", ({ detail }) => {
      counts.push(detail.count);
      onCount();
    });
    const tracers = new Set([element.tracer]);
    while (counts.length < 20) {
      const ready = new Promise((resolve) => element.addEventListener("ready", resolve, { once: true }));
      element.tracer!.device.destroy();
      const lostTwice = new Promise<void>((resolve) => {
        onCount = () => void (counts.length % 2 === 0 && resolve());
      });
      // The one that comes after is taken away while the scene is compiled for it.
      const first = page.newest;
      while (page.newest === first) await new Promise(requestAnimationFrame);
      page.newest.destroy();
      await lostTwice;
      await ready;
      tracers.add(element.tracer);
    }
    return { counts, tracerCount: tracers.size };
  });
  expect(counts.counts).toEqual(Array.from({ length: 20 }, (_, index) => index + 1));
  expect(counts.tracerCount).toBe(11);
  await waitForSamples(viewer, 4);
  expect(contrast(await pictureOf(viewer))).toBeGreaterThan(20);
  const camera = await viewer.evaluate((element: RtViewerElement) => element.camera);
  expect(camera).toMatchObject({ position: [2, 1, 6], target: [0, 0.5, 0] });
  await expect(viewer.getByRole("alert")).toBeHidden();
});

test("viewers that lost the same device share the next one", async ({ page }) => {
  await openViewer(page, SMALL, 2);
  await addViewer(page, SMALL);
  await waitForSamples(page.locator("rt-viewer").nth(1), 2);
  const isShared = await page.evaluate(async () => {
    const viewers = [...document.querySelectorAll("rt-viewer")];
    const ready = viewers.map((viewer) => new Promise((resolve) => viewer.addEventListener("ready", resolve)));
    viewers[0]!.tracer!.device.destroy();
    await Promise.all(ready);
    return viewers[0]!.tracer!.device === viewers[1]!.tracer!.device;
  });
  expect(isShared).toBe(true);
  for (const index of [0, 1]) await waitForSamples(page.locator("rt-viewer").nth(index), 2);
});

test("an adapter that is gone for a moment is waited for", async ({ page }) => {
  const viewer = await openViewer(page, SMALL, 2);
  await viewer.evaluate(async (element: RtViewerElement) => {
    const { requestAdapter } = GPU.prototype;
    let misses = 2;
    GPU.prototype.requestAdapter = async function (options) {
      return misses-- > 0 ? null : requestAdapter.call(this, options);
    };
    const ready = new Promise((resolve) => element.addEventListener("ready", resolve));
    element.tracer?.device.destroy();
    await ready;
  });
  await waitForSamples(viewer, 2);
});

test("where there is no other device, the element says so", async ({ page }) => {
  const viewer = await openViewer(page, SMALL, 2);
  await viewer.evaluate((element: RtViewerElement) => {
    GPU.prototype.requestAdapter = async () => null;
    element.tracer?.device.destroy();
  });
  await expect(viewer.getByRole("alert")).toContainText(/no graphics adapter/);
});

test("out of memory is told as what it is, and gives back what there was", async ({ page }) => {
  await openFixture(page);
  const viewer = await addViewer(page, SMALL);
  await waitForSamples(viewer, 2);
  const isLost = await viewer.evaluate(async (element: RtViewerElement) => {
    const { device } = element.tracer!;
    const error = new GPUOutOfMemoryError("Failed to allocate memory for buffer");
    device.dispatchEvent(new GPUUncapturedErrorEvent("uncapturederror", { error }));
    await device.lost;
    return element.tracer === undefined;
  });
  expect(isLost).toBe(true);
  await expect(viewer.getByRole("alert")).toContainText("The GPU is out of memory");
  await viewer.evaluate((element: RtViewerElement) => element.setAttribute("src", "furnace.json"));
  await waitForSamples(viewer, 2);
  await expect(viewer.getByRole("alert")).toBeHidden();
});
