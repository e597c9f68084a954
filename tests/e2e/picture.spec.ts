import type { RtViewerElement } from "../../src/element";
import { contrast, meanColor, pictureOf } from "./support/picture";
import { expect, test } from "./support/test";
import { openViewer, waitForSamples } from "./support/viewer";

test("an element with src shows the scene", async ({ page }) => {
  const viewer = await openViewer(page, { src: "spheres.json", alt: "Three balls" }, 8);
  const picture = await pictureOf(viewer);

  expect([picture.width, picture.height]).toEqual([320, 240]);
  expect(contrast(picture)).toBeGreaterThan(20);
  // The red ball on the left, the bluish sky, the grey floor.
  const [red, green, blue] = meanColor(picture, [0.22, 0.42, 0.3, 0.55]);
  expect(red).toBeGreaterThan(2 * Math.max(green, blue));
  const sky = meanColor(picture, [0.3, 0.02, 0.7, 0.2]);
  expect(sky[2]).toBeGreaterThan(1.1 * sky[0]);
  const floor = meanColor(picture, [0.3, 0.85, 0.7, 0.98]);
  expect(Math.max(...floor) - Math.min(...floor)).toBeLessThan(40);
});

test("no sample is bad, the error falls, and the canvas has the element's physical pixels", async ({ page }) => {
  const viewer = await openViewer(page, { src: "spheres.json" }, 4);
  const early = await viewer.evaluate((element: RtViewerElement) => ({ ...element.stats }));
  await waitForSamples(viewer, 16);
  await expect
    .poll(() => viewer.evaluate((element: RtViewerElement) => element.stats?.error))
    .toBeLessThan(early.error!);
  const late = await viewer.evaluate((element: RtViewerElement) => {
    const { stats, tracer } = element;
    return { ...stats, width: tracer?.width, height: tracer?.height };
  });
  expect(late).toMatchObject({ badSamples: 0, width: 320, height: 240 });
  expect(late.features).not.toHaveLength(0);
});

test("it is an image to those who do not see it", async ({ page }) => {
  await openViewer(page, { src: "spheres.json", alt: "Three balls" });
  await expect(page.getByRole("img", { name: "Three balls" })).toBeVisible();
});

test("a scene can be set as a property, and overrides src", async ({ page }) => {
  const viewer = await openViewer(page, { src: "spheres.json" });
  await viewer.evaluate((element: RtViewerElement) => {
    element.scene = {
      camera: { position: [0, 0, 3], target: [0, 0, 0] },
      materials: { lamp: { baseColor: [0, 0, 0], emission: [0, 1, 0] } },
      objects: [{ type: "quad", corner: [-5, -5, 0], edge1: [10, 0, 0], edge2: [0, 10, 0], material: "lamp" }],
    };
  });
  await expect
    .poll(async () => {
      const [red, green, blue] = meanColor(await pictureOf(viewer));
      return green > 100 && green > 2 * Math.max(red, blue);
    })
    .toBe(true);
});
