import type { RtViewerElement } from "../../src/element";
import { contrast, pictureOf } from "./support/picture";
import { expect, test } from "./support/test";
import { addViewer, openFixture, openViewer, samplesOf, waitForSamples } from "./support/viewer";

test("moving it in the document keeps the tracer, the samples and the picture", async ({ page }) => {
  const viewer = await openViewer(page, { src: "spheres.json" }, 4);
  const isSame = await viewer.evaluate(async (element: RtViewerElement) => {
    const { tracer } = element;
    const samples = element.stats!.samples;
    const section = document.createElement("section");
    document.body.append(section);
    section.append(element);
    await new Promise((resolve) => setTimeout(resolve, 100)); // longer than the grace after which it would be disposed
    return element.tracer === tracer && element.stats!.samples >= samples;
  });
  expect(isSame).toBe(true);
  await waitForSamples(viewer, (await samplesOf(viewer)) + 2);
  expect(contrast(await pictureOf(viewer))).toBeGreaterThan(20);
});

test("removing it gives back the GPU, and putting it back starts anew", async ({ page }) => {
  const viewer = await openViewer(page, { src: "spheres.json" });
  const isLost = await viewer.evaluate(async (element: RtViewerElement) => {
    const { device } = element.tracer!;
    element.remove();
    await device.lost;
    const isGone = element.tracer === undefined;
    document.body.append(element);
    return isGone;
  });
  expect(isLost).toBe(true);
  await waitForSamples(viewer, 2);
});

test("of two sources set in a row the last one is shown, though the first comes later", async ({ page }) => {
  let release = () => {};
  const held = new Promise<void>((resolve) => {
    release = resolve;
  });
  await page.route("**/furnace.json", async (route) => {
    await held;
    await route.continue().catch(() => undefined); // the element has cancelled it
  });
  await openFixture(page);
  const viewer = await addViewer(page, { src: "furnace.json" });
  await viewer.evaluate((element: RtViewerElement) => element.setAttribute("src", "spheres.json"));
  await waitForSamples(viewer, 1);
  release();
  await waitForSamples(viewer, 4);
  const objects = await viewer.evaluate((element: RtViewerElement) => element.tracer?.scene.objects.length);
  expect(objects).toBe(4);
});

test("a scene that is set while the element is moved takes the place of one that is downloaded, without an error", async ({
  page,
}) => {
  let isAsked = false;
  await page.route("**/furnace.json", () => {
    isAsked = true; // and never answered
  });
  await openFixture(page);
  const viewer = await addViewer(page, { src: "furnace.json" });
  await expect.poll(() => isAsked).toBe(true);
  const errors = await viewer.evaluateHandle((element: RtViewerElement) => {
    const errors: string[] = [];
    element.addEventListener("error", ({ detail }) => errors.push(String(detail.error)));
    element.remove();
    element.scene = { camera: { position: [0, 0, 5] }, objects: [], environment: { radiance: [1, 1, 1] } };
    return new Promise<string[]>((resolve) => {
      setTimeout(() => {
        document.body.append(element);
        resolve(errors);
      }, 1);
    });
  });
  await waitForSamples(viewer, 1);
  expect(await errors.jsonValue()).toEqual([]);
});

test("ready comes once per scene, then progress, then converged at max-samples", async ({ page }) => {
  await openFixture(page);
  const events = await page.evaluate(
    () =>
      new Promise<string[]>((resolve) => {
        const seen: string[] = [];
        const viewer = document.createElement("rt-viewer");
        viewer.maxSamples = 4;
        for (const type of ["ready", "progress", "converged", "error"] as const) {
          viewer.addEventListener(type, () => seen.push(type));
        }
        viewer.addEventListener("converged", () => resolve(seen));
        viewer.src = "spheres.json";
        document.body.append(viewer);
      }),
  );
  expect(events[0]).toBe("ready");
  expect(events.filter((type) => type === "ready")).toHaveLength(1);
  expect(events).toContain("progress");
  expect(events).not.toContain("error");
  expect(await samplesOf(page.locator("rt-viewer"))).toBe(4);
});

test("properties that were set before the element was defined are honoured", async ({ page }) => {
  await page.route("**/*.js", async (route) => {
    await page.waitForFunction(() => document.querySelector("rt-viewer") !== null);
    await route.continue();
  });
  const { FIXTURE_URL } = await import("./support/urls");
  await page.goto(FIXTURE_URL, { waitUntil: "commit" });
  await page.waitForFunction(() => document.body !== null);
  await page.evaluate(() => {
    const viewer = document.createElement("rt-viewer");
    Object.assign(viewer, { src: "spheres.json", controls: true, settings: { lightSamples: 3 }, exposure: 1 });
    Object.assign(viewer, { maxSamples: 64, toneMap: "agx", camera: { position: [0, 2, 9] } });
    document.body.append(viewer);
  });
  const viewer = page.locator("rt-viewer");
  await waitForSamples(viewer, 1);
  await expect(viewer).toHaveAttribute("controls");
  await expect(viewer).toHaveAttribute("light-samples", "3");
  await expect(viewer).toHaveAttribute("exposure", "1");
  await expect(viewer).toHaveAttribute("max-samples", "64");
  await expect(viewer).toHaveAttribute("tone-map", "agx");
  const camera = await viewer.evaluate((element: RtViewerElement) => element.camera);
  expect(camera?.position).toEqual([0, 2, 9]);
});

test("out of sight it makes its first picture and then rests", async ({ page }) => {
  await openFixture(page);
  await page.evaluate(() => {
    document.body.style.paddingTop = "3000px";
  });
  const viewer = await addViewer(page, { src: "spheres.json" });
  await waitForSamples(viewer, 1);
  // Whatever was under way when it came to rest.
  const rested = await viewer.evaluate(async (element: RtViewerElement) => {
    await element.tracer!.device.queue.onSubmittedWorkDone();
    for (let frame = 0; frame < 3; frame++) await new Promise(requestAnimationFrame);
    const before = element.stats!.samples;
    for (let frame = 0; frame < 60; frame++) await new Promise(requestAnimationFrame);
    return element.stats!.samples === before;
  });
  expect(rested).toBe(true);
  await viewer.scrollIntoViewIfNeeded();
  await waitForSamples(viewer, 5);
});

test("a new size is rendered in its own pixels", async ({ page }) => {
  const viewer = await openViewer(page, { src: "spheres.json" }, 2);
  await viewer.evaluate((element: RtViewerElement) => {
    element.style.cssText = "width:200px;height:100px";
  });
  const size = () =>
    viewer.evaluate((element: RtViewerElement) => {
      const { tracer } = element;
      const canvas = element.shadowRoot!.querySelector("canvas")!;
      return [tracer?.width, tracer?.height, canvas.width, canvas.height];
    });
  await expect.poll(size).toEqual([200, 100, 200, 100]);
  expect(contrast(await pictureOf(viewer))).toBeGreaterThan(20);
});
