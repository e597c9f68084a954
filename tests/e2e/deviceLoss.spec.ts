import type { RtViewerElement } from "../../src/element";
import { contrast, pictureOf } from "./support/picture";
import { report } from "./support/report";
import { expect, test } from "./support/test";
import { addViewer, openViewer, waitForSamples } from "./support/viewer";

const SMALL = { src: "spheres.json", style: "width:160px;height:120px" };

test("20 lost devices are survived where they are minutes apart, half of them lost before their first picture", async ({
  page,
}) => {
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
    const { now } = performance;
    for (let minutes = 2; counts.length < 20; minutes += 2) {
      performance.now = () => now.call(performance) + minutes * 60_000;
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

test("a scene that loses the device each time is given up with a message, and its neighbour goes on", async ({
  page,
}) => {
  test.slow();
  await openViewer(page, { ...SMALL, id: "killer" });
  await addViewer(page, { ...SMALL, id: "neighbour" });
  const [killer, neighbour] = [page.locator("#killer"), page.locator("#neighbour")];
  await waitForSamples(neighbour, 1);
  const counts = await killer.evaluate(async (element: RtViewerElement) => {
    const destroy = () => void element.tracer?.device.destroy();
    element.addEventListener("ready", destroy);
    const losses = [...document.querySelectorAll("rt-viewer")].map((viewer) => {
      const seen = { count: 0 };
      viewer.addEventListener("devicelost", () => {
        seen.count += 1;
      });
      return seen;
    });
    const failed = new Promise((resolve) => element.addEventListener("error", resolve, { once: true }));
    destroy();
    await failed;
    return losses.map(({ count }) => count);
  });
  report("killer-scene", { counts });
  expect(counts[0]).toBeLessThanOrEqual(8);
  await expect(killer.getByRole("alert")).toContainText("lost again and again with this scene");
  await waitForSamples(neighbour, 4);
  await expect(neighbour.getByRole("alert")).toBeHidden();
});
