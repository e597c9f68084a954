import type { Browser, Page } from "@playwright/test";
import type { RtViewerElement } from "../../src/element";
import { SOFTWARE_WEBGPU_FLAGS } from "../support/chromium";
import { report } from "./support/report";
import { expect, test } from "./support/test";
import { openFixture, openViewer, samplesOf, waitForSamples } from "./support/viewer";

/** Milliseconds from the element being connected until its first picture has been drawn by the GPU and shown. */
async function firstPicture(page: Page): Promise<{ milliseconds: number; compileSeconds: number; adapter: string }> {
  await openFixture(page);
  return await page.evaluate(async () => {
    const viewer = document.createElement("rt-viewer");
    viewer.src = "spheres.json";
    const ready = new Promise((resolve) => viewer.addEventListener("ready", resolve, { once: true }));
    const start = performance.now();
    document.body.append(viewer);
    await ready;
    await viewer.tracer?.device.queue.onSubmittedWorkDone();
    await new Promise(requestAnimationFrame);
    const milliseconds = performance.now() - start;
    return { milliseconds, compileSeconds: viewer.stats?.compileSeconds ?? 0, adapter: viewer.stats?.adapter ?? "" };
  });
}

test("the first picture of spheres at 320×240 comes soon after the element is connected", async ({ browser, page }) => {
  const cold = await inFreshBrowser(browser, firstPicture);
  const warm = await firstPicture(page);
  report("first-picture", {
    scene: "spheres",
    size: "320x240",
    adapter: cold.adapter,
    coldMs: Math.round(cold.milliseconds),
    warmMs: Math.round(warm.milliseconds),
    coldCompileMs: Math.round(cold.compileSeconds * 1000),
    targetMs: 1500,
  });
  // The target is 1.5 s on a quiet machine; twice that catches what matters (a peer takes 32 s) on a busy one.
  expect(Math.min(cold.milliseconds, warm.milliseconds)).toBeLessThan(3000);
});

test("reports frames and samples per second", async ({ page }) => {
  const viewer = await openViewer(page, { src: "spheres.json" }, 4);
  const [start, samples] = [Date.now(), await samplesOf(viewer)];
  await waitForSamples(viewer, samples + 12);
  const seconds = (Date.now() - start) / 1000;
  const taken = (await samplesOf(viewer)) - samples;
  const stats = await viewer.evaluate((element: RtViewerElement) => ({ ...element.stats }));
  report("fps", {
    scene: "spheres",
    size: "320x240",
    adapter: stats.adapter,
    fps: stats.fps,
    frameMs: stats.frameMs,
    gpuMs: stats.gpuMs,
    samplesPerSecond: taken / seconds,
    pathsPerSecond: stats.pathsPerSecond,
    raysPerSecond: stats.raysPerSecond,
    errorAtSamples: [stats.samples, stats.error],
  });
  expect(stats.fps).toBeGreaterThan(1);
  expect(stats.fps).toBeLessThan(1000);
  expect(stats.pathsPerSecond).toBeGreaterThan(0);
  expect(stats.raysPerSecond).toBeGreaterThan(stats.pathsPerSecond!);
  expect(stats.adapter).not.toBe("");
});

test("after start-up no task holds the main thread for 50 ms, with the panel open", async ({ page }) => {
  const viewer = await openViewer(page, { src: "spheres.json", stats: "", style: "width:480px;height:360px" }, 2);
  const { longest, frames, seconds, seesLongTasks } = await page.evaluate(async () => {
    let longest = 0;
    let frames = 0;
    const observer = new PerformanceObserver((list) => {
      for (const { duration } of list.getEntries()) longest = Math.max(longest, duration);
    });
    observer.observe({ type: "longtask" }); // those of 50 ms and more
    const start = performance.now();
    while (performance.now() - start < 4000) {
      await new Promise(requestAnimationFrame);
      frames += 1;
    }
    const measured = { longest, frames, seconds: (performance.now() - start) / 1000 };

    // Nothing seen is good news only if something would have been seen.
    const blocked = performance.now();
    while (performance.now() - blocked < 80);
    for (let frame = 0; frame < 120 && longest === measured.longest; frame++) await new Promise(requestAnimationFrame);
    observer.disconnect();
    return { ...measured, seesLongTasks: longest >= 80 };
  });
  report("responsiveness", { longestTaskMs: longest, longTaskThresholdMs: 50, framesPerSecond: frames / seconds });
  expect(seesLongTasks).toBe(true);
  expect(longest).toBeLessThan(50);
  await waitForSamples(viewer, 4);
});

async function inFreshBrowser<T>(browser: Browser, use: (page: Page) => Promise<T>): Promise<T> {
  const { executablePath } = test.info().project.use.launchOptions ?? {};
  const fresh = await browser.browserType().launch({
    args: [...SOFTWARE_WEBGPU_FLAGS],
    ...(executablePath === undefined ? {} : { executablePath }),
  });
  try {
    return await use(await fresh.newPage());
  } finally {
    await fresh.close();
  }
}
