import type { Locator, Page } from "@playwright/test";
import type { RtViewerElement } from "../../src/element";
import type { Camera, Scene } from "../../src/scene/schema";
import { difference, pictureOf } from "./support/picture";
import { expect, test } from "./support/test";
import { addViewer, openFixture, openViewer, pause, samplesOf, waitForSamples } from "./support/viewer";

const cameraOf = (viewer: Locator) => viewer.evaluate((element: RtViewerElement) => element.camera!);

/** Carries out a gesture and expects the sampling to start over, with another picture. */
async function expectMove(viewer: Locator, gesture: () => Promise<void>): Promise<void> {
  await waitForSamples(viewer, 6);
  const before = await pictureOf(viewer);
  const restarts = await viewer.evaluateHandle((element: RtViewerElement) => {
    const seen = { last: element.stats!.samples, count: 0 };
    element.addEventListener("progress", ({ detail }) => {
      if (detail.samples < seen.last) seen.count += 1;
      seen.last = detail.samples;
    });
    return seen;
  });
  await gesture();
  await expect.poll(() => restarts.evaluate(({ count }) => count)).toBeGreaterThanOrEqual(1);
  await waitForSamples(viewer, 4);
  // A few samples of noise are a difference of about 5; another view is one of tens.
  expect(difference(before, await pictureOf(viewer))).toBeGreaterThan(8);
}

async function drag(page: Page, viewer: Locator, [dx, dy]: readonly [number, number]): Promise<void> {
  const box = (await viewer.boundingBox())!;
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + dx / 2, y + dy / 2);
  await page.mouse.move(x + dx, y + dy);
  await page.mouse.up();
}

test("a drag turns the camera around its target", async ({ page }) => {
  const viewer = await openViewer(page, { src: "spheres.json", controls: "" });
  const before = await cameraOf(viewer);
  await expectMove(viewer, () => drag(page, viewer, [60, 0]));
  const after = await cameraOf(viewer);
  expect(after.target).toEqual(before.target);
  expect(after.position[0]).toBeLessThan(-1); // the picture's content goes with the pointer
  expect(after.position[1]).toBeCloseTo(before.position[1]);
});

test("arrow keys turn, plus and minus zoom, and others are left to the page", async ({ page }) => {
  const viewer = await openViewer(page, { src: "spheres.json", controls: "" });
  const before = await cameraOf(viewer);
  await page.keyboard.press("Tab");
  await expectMove(viewer, async () => {
    for (let press = 0; press < 4; press++) await page.keyboard.press("ArrowRight");
  });
  const turned = await cameraOf(viewer);
  expect(turned.position[0]).toBeGreaterThan(1);

  await expectMove(viewer, async () => {
    for (let press = 0; press < 4; press++) await page.keyboard.press("+");
  });
  const near = await cameraOf(viewer);
  expect(near.position[2]).toBeLessThan(turned.position[2]);

  await page.keyboard.press("a");
  expect(await cameraOf(viewer)).toEqual(near);
  expect(near.target).toEqual(before.target);
});

test("shift-drag pans", async ({ page }) => {
  const viewer = await openViewer(page, { src: "spheres.json", controls: "" });
  const before = await cameraOf(viewer);
  await expectMove(viewer, async () => {
    await page.keyboard.down("Shift");
    await drag(page, viewer, [80, 0]);
    await page.keyboard.up("Shift");
  });
  const after = await cameraOf(viewer);
  expect(after.target[0]).toBeLessThan(before.target[0] - 0.5);
  expect(after.position[0] - after.target[0]).toBeCloseTo(before.position[0] - before.target[0]);
});

test("the wheel zooms where the pointer has been moved", async ({ page }) => {
  const viewer = await openViewer(page, { src: "spheres.json", controls: "" });
  await page.evaluate(() => {
    document.body.style.height = "4000px";
  });
  const before = await cameraOf(viewer);
  await page.mouse.move(160, 120);
  await page.mouse.move(165, 120);
  await page.mouse.wheel(0, 200);
  await expect.poll(async () => (await cameraOf(viewer)).position[2]).toBeGreaterThan(before.position[2] + 0.5);
  expect(await page.evaluate(() => scrollY)).toBe(0);
});

test("the wheel scrolls a page that passes under a resting pointer", async ({ page }) => {
  const viewer = await openViewer(page, { src: "spheres.json", controls: "" });
  await page.evaluate(() => {
    document.body.style.cssText = "padding-top:300px;height:4000px";
  });
  const before = await cameraOf(viewer);
  await page.mouse.move(160, 120);
  for (const scrolled of [200, 300, 400]) {
    await page.mouse.wheel(0, scrolled === 200 ? 200 : 100);
    await expect.poll(() => page.evaluate(() => scrollY)).toBe(scrolled);
  }
  expect(await cameraOf(viewer)).toEqual(before);
});

test("without controls nothing moves", async ({ page }) => {
  const viewer = await openViewer(page, { src: "spheres.json" });
  const before = await cameraOf(viewer);
  await drag(page, viewer, [60, 20]);
  await page.keyboard.press("Tab");
  await page.keyboard.press("ArrowRight");
  expect(await cameraOf(viewer)).toEqual(before);
});

/** A square that glows, 1 m wide, in the middle of a black picture of 2.4 m. */
async function openSquare(page: Page, camera: Partial<Camera>): Promise<Locator> {
  const scene: Scene = {
    camera: { position: [0, 0, 4], verticalFov: 33.4, ...camera },
    materials: { glow: { emission: [1, 1, 1] } },
    objects: [{ type: "quad", corner: [-0.5, -0.5, 0], edge1: [1, 0, 0], edge2: [0, 1, 0], material: "glow" }],
    maxBounces: 0,
  };
  await openFixture(page);
  const viewer = await addViewer(page, { controls: "", "tone-map": "none" });
  await viewer.evaluate((element: RtViewerElement, value) => {
    element.scene = value;
  }, scene);
  await waitForSamples(viewer, 4);
  return viewer;
}

/** Which shares of the picture are white, and neither white nor black. */
async function sharesOf(viewer: Locator): Promise<{ white: number; grey: number }> {
  const { data, channels } = await pictureOf(viewer);
  const values = data.filter((_, i) => i % channels === 0);
  const share = (within: (value: number) => boolean) => values.filter(within).length / values.length;
  return { white: share((value) => value > 225), grey: share((value) => value >= 30 && value <= 225) };
}

async function wheel(page: Page, delta: number): Promise<void> {
  await page.mouse.move(160, 120);
  await page.mouse.move(165, 120);
  await page.mouse.wheel(0, delta);
}

test("an orthographic camera zooms by its height, from where it is, and turns without changing it", async ({
  page,
}) => {
  const viewer = await openSquare(page, { orthographicHeight: 2.4 });
  const before = await cameraOf(viewer);
  const { white } = await sharesOf(viewer);
  expect(white).toBeCloseTo(1 / 2.4 / 3.2, 2);

  await wheel(page, -200);
  await expect.poll(async () => (await cameraOf(viewer)).orthographicHeight).toBeLessThan(1.9);
  const { orthographicHeight: height, ...others } = await cameraOf(viewer);
  expect({ ...others, orthographicHeight: 2.4 }).toEqual(before);
  await expect.poll(async () => (await sharesOf(viewer)).white / white).toBeCloseTo((2.4 / height!) ** 2, 1);

  await drag(page, viewer, [80, 0]); // a third of half a turn
  const turned = await cameraOf(viewer);
  expect([turned.orthographicHeight, turned.target]).toEqual([height, before.target]);
  expect(Math.hypot(...turned.position)).toBeCloseTo(4);
  expect(turned.position[0]).toBeCloseTo(-4 * Math.sin(Math.PI / 3));
  await expect.poll(async () => (await sharesOf(viewer)).white / white).toBeCloseTo((2.4 / height!) ** 2 / 2, 1);
});

test("a page that makes the camera orthographic, and back, does not lose the scene to a long turn of the wheel", async ({
  page,
}) => {
  const viewer = await openSquare(page, {});
  await viewer.evaluate((element: RtViewerElement) => {
    element.camera = { orthographicHeight: 2.4 };
  });
  await page.mouse.move(160, 120);
  await page.mouse.move(165, 120);
  for (let turn = 0; turn < 20; turn++) await page.mouse.wheel(0, 300);
  await expect.poll(async () => (await cameraOf(viewer)).orthographicHeight).toBeCloseTo(240, 0);
  await viewer.evaluate((element: RtViewerElement) => {
    element.camera = { orthographicHeight: undefined };
  });
  const { orthographicHeight, position } = await cameraOf(viewer);
  expect([orthographicHeight, position]).toEqual([undefined, [0, 0, 4]]);
});

for (const [name, focus] of [
  ["by default", {}],
  ["that its author named", { focusDistance: 4 }],
] as const) {
  test(`a lens that focuses on the target ${name} does so after a zoom and a turn`, async ({ page }) => {
    const viewer = await openSquare(page, { aperture: 0.3, ...focus });
    const grey = async () => (await sharesOf(viewer)).grey;
    const MOST_GREY = 0.02; // four edges of 150 pixels, two wide, are 1.6 % of the picture
    await expect.poll(grey).toBeLessThan(MOST_GREY);
    await wheel(page, -300);
    await expect.poll(async () => (await cameraOf(viewer)).position[2]).toBeLessThan(2.7);
    // Focused as far as before, the edges are 30 pixels wide.
    await expect.poll(async () => (await sharesOf(viewer)).white).toBeGreaterThan(0.25);
    await expect.poll(grey).toBeLessThan(MOST_GREY);
    await drag(page, viewer, [0, 4]);
    await expect.poll(grey).toBeLessThan(2 * MOST_GREY);

    await viewer.evaluate((element: RtViewerElement) => {
      element.camera = { focusDistance: 8 };
    });
    await expect.poll(grey).toBeGreaterThan(4 * MOST_GREY);
  });
}

test("a paused viewer that is turned shows the new view with its first sample, and rests", async ({ page }) => {
  const viewer = await openViewer(page, { src: "spheres.json", controls: "" }, 4);
  await pause(viewer);
  const before = await pictureOf(viewer);
  await drag(page, viewer, [60, 0]);
  await expect.poll(() => samplesOf(viewer)).toBe(1);
  await expect.poll(async () => difference(before, await pictureOf(viewer))).toBeGreaterThan(8);
});
