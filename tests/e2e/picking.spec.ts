import type { Locator, Page } from "@playwright/test";
import type { PickDetail, RtViewerElement } from "../../src/element";
import { type Area, meanColor, pictureOf } from "./support/picture";
import { expect, test } from "./support/test";
import { addViewer, openFixture, openViewer, waitForSamples } from "./support/viewer";

const ROOMY = { src: "spheres.json", stats: "", style: "width:640px;height:480px" };
// In the picture of `spheres`.
const [GOLD, SKY, FLOOR] = [{ x: 320, y: 240 } as const, { x: 60, y: 20 } as const, { x: 60, y: 450 } as const];

/** The details of all `pick` events from now on. */
async function watchPicks(viewer: Locator): Promise<() => Promise<PickDetail[]>> {
  const picks = await viewer.evaluateHandle((element: RtViewerElement) => {
    const details: PickDetail[] = [];
    element.addEventListener("pick", ({ detail }) => details.push(detail));
    return details;
  });
  return () => picks.jsonValue();
}

/** Counts what is compiled on any device of the page from now on. */
async function countCompilations(page: Page): Promise<() => Promise<number>> {
  const counter = await page.evaluateHandle(() => {
    const seen = { count: 0 };
    const { createShaderModule } = GPUDevice.prototype;
    GPUDevice.prototype.createShaderModule = function (...args) {
      seen.count += 1;
      return createShaderModule.apply(this, args);
    };
    return seen;
  });
  return () => counter.evaluate(({ count }) => count);
}

/** The picture; colour fields have canvases of their own. */
const canvasOf = (viewer: Locator) => viewer.locator("canvas[part=canvas]");
const folderOf = (viewer: Locator, name: string) => viewer.getByRole("button", { name, exact: true });
const listOf = (viewer: Locator) => viewer.getByLabel("object or light");
const goldOf = (viewer: Locator) =>
  viewer.evaluate((element: RtViewerElement) => element.tracer!.scene.materials.gold!);

async function setNumber(viewer: Locator, label: string, value: string): Promise<void> {
  const field = viewer.getByLabel(label, { exact: true });
  await field.fill(value);
  await field.press("Enter");
}

test("a click on the picture picks what is seen there, one on nothing lets go, and so does Escape", async ({
  page,
}) => {
  const viewer = await openViewer(page, { ...ROOMY, controls: "" });
  await expect(listOf(viewer)).toBeVisible();
  const picks = await watchPicks(viewer);
  const canvas = canvasOf(viewer);

  await canvas.click({ position: GOLD });
  await expect(listOf(viewer)).toHaveValue("objects[2] · sphere · gold");
  await expect(folderOf(viewer, "material · gold")).toBeVisible();
  await canvas.click({ position: SKY });
  await expect(folderOf(viewer, "material · gold")).toHaveCount(0);
  await canvas.click({ position: FLOOR });
  await expect(folderOf(viewer, "material · floor")).toBeVisible();
  await page.keyboard.press("Escape");
  await expect(folderOf(viewer, "material · floor")).toHaveCount(0);

  const seen = await picks();
  expect(seen.map((pick) => (pick.kind === "none" ? pick.kind : pick.index))).toEqual([2, "none", 0, "none"]);
  expect(seen[0]).toMatchObject({ kind: "object", object: { type: "sphere", material: "gold" } });
});

test("objects and lights are picked by keyboard in the panel, too", async ({ page }) => {
  const viewer = await openViewer(page, ROOMY);
  const picks = await watchPicks(viewer);
  await listOf(viewer).focus();
  await page.keyboard.press("End");
  await expect(folderOf(viewer, "sphere light")).toBeVisible();
  await expect
    .poll(async () => (await picks()).at(-1))
    .toMatchObject({ kind: "light", index: 0, light: { radius: 0.5 } });
});

test("a drag picks nothing, with a mouse or a finger; a tap picks", async ({ page }) => {
  const viewer = await openViewer(page, { ...ROOMY, controls: "" });
  await expect(listOf(viewer)).toBeVisible();
  const picks = await watchPicks(viewer);
  await page.mouse.move(GOLD.x, GOLD.y);
  await page.mouse.down();
  await page.mouse.move(GOLD.x + 12, GOLD.y);
  await page.mouse.move(GOLD.x, GOLD.y); // and back
  await page.mouse.up();

  const touch = (moves: readonly (readonly [string, number])[]) =>
    canvasOf(viewer).evaluate(
      (canvas, { moves, x, y }) => {
        canvas.setPointerCapture = () => {}; // knows no pointer that is made up
        for (const [type, dx] of moves) {
          const place = { clientX: x + dx, clientY: y, pointerId: 7, pointerType: "touch", isPrimary: true };
          canvas.dispatchEvent(new PointerEvent(type, { ...place, button: 0, bubbles: true }));
        }
      },
      { moves, ...FLOOR },
    );
  await touch([
    ["pointerdown", 0],
    ["pointermove", 30],
    ["pointerup", 30],
  ]);
  await touch([
    ["pointerdown", 0],
    ["pointercancel", 0],
  ]); // the page scrolls
  await touch([
    ["pointerdown", 0],
    ["pointermove", 6],
    ["pointerup", 6],
  ]);
  await expect.poll(async () => (await picks()).length).toBe(1);
  expect(await picks()).toMatchObject([{ kind: "object", index: 0 }]);
});

test("dragging a slider changes the scene frame by frame, compiles nothing, and leaves the camera alone", async ({
  page,
}) => {
  const viewer = await openViewer(page, ROOMY);
  // What a scene at rest is compiled to would be counted too.
  await viewer.evaluate((element: RtViewerElement) => {
    element.settings = { constants: false };
    element.camera = { position: [0.5, 1.7, 5.2] };
  });
  await listOf(viewer).selectOption({ label: "objects[2] · sphere · gold" });
  await waitForSamples(viewer, 1);
  const compilations = await countCompilations(page);

  const slider = viewer.locator(".tp-lblv", { hasText: /^roughness$/ }).locator(".tp-sldv_t");
  const box = (await slider.boundingBox())!;
  const seen = new Set<number>();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  for (const share of [0.5, 0.6, 0.7, 0.8]) {
    await page.mouse.move(box.x + box.width * share, box.y + box.height / 2);
    await expect.poll(async () => (await goldOf(viewer)).roughness).toBeCloseTo(share, 1);
    seen.add((await goldOf(viewer)).roughness);
  }
  await page.mouse.up();
  expect(seen.size).toBe(4);
  await waitForSamples(viewer, 2);
  expect(await compilations()).toBe(0);
  expect(await viewer.evaluate((element: RtViewerElement) => element.camera!.position)).toEqual([0.5, 1.7, 5.2]);
  expect(await goldOf(viewer)).toMatchObject({ metallic: 1, baseColor: [1, 0.78, 0.34] });

  // A mirror is another program.
  await setNumber(viewer, "roughness", "0");
  await expect.poll(() => compilations()).toBeGreaterThan(0);
  await expect.poll(async () => (await goldOf(viewer)).roughness).toBe(0);
  await expect(viewer.getByLabel("masking")).toBeHidden();
});

test("a light turned up brightens the picture and keeps its colour", async ({ page }) => {
  const viewer = await openViewer(page, ROOMY, 4);
  const floor: Area = [0.1, 0.8, 0.4, 0.95];
  const before = meanColor(await pictureOf(canvasOf(viewer)), floor);
  await listOf(viewer).selectOption({ label: "lights[0] · sphere" });
  await setNumber(viewer, "power (W)", "1680");
  const lightOf = () =>
    viewer.evaluate((element: RtViewerElement) => {
      const light = element.tracer!.scene.lights[0]!;
      return light.type === "sphere" ? light : undefined;
    });
  await expect.poll(async () => (await lightOf())?.power).toEqual([1680, 1530, 1410]);
  await waitForSamples(viewer, 2);
  await expect
    .poll(async () => meanColor(await pictureOf(canvasOf(viewer)), floor)[1])
    .toBeGreaterThan(1.15 * before[1]);
  // The field of colours is there when it is asked for.
  await viewer.getByLabel("choose colour").click();
  await expect.poll(async () => (await viewer.locator(".tp-svpv_c").first().boundingBox())?.height).toBeGreaterThan(60);
  await setNumber(viewer, "position y", "5");
  await expect.poll(async () => (await lightOf())?.position).toEqual([2, 5, 2]);
});

test("the element's scene is the edited one, until another is loaded", async ({ page }) => {
  const viewer = await openViewer(page, ROOMY);
  const sceneOf = () => viewer.evaluate((element: RtViewerElement) => element.scene);
  expect(await sceneOf()).toBeUndefined();
  await listOf(viewer).selectOption({ label: "objects[1] · sphere · red" });
  await setNumber(viewer, "metallic", "0.5");
  await expect.poll(async () => (await sceneOf())?.materials?.red).toMatchObject({ metallic: 0.5, roughness: 0.6 });

  await viewer.evaluate((element: RtViewerElement) => element.setAttribute("src", "furnace.json"));
  await expect(listOf(viewer).locator("option", { hasText: "red" })).toHaveCount(0);
  expect(await sceneOf()).toBeUndefined();
  await expect(listOf(viewer)).toHaveValue(/choose/);

  // And one that the page itself has set.
  await viewer.evaluate((element: RtViewerElement) => {
    element.scene = {
      camera: { position: [0, 1, 5] },
      materials: { only: {} },
      objects: [{ type: "sphere", center: [0, 1, 0], radius: 1, material: "only" }],
    };
  });
  await listOf(viewer).selectOption({ label: "objects[0] · sphere · only" });
  await setNumber(viewer, "ior", "2");
  await expect.poll(async () => (await sceneOf())?.materials?.only?.ior).toBe(2);
});

test("names from a scene file are text, whatever they say", async ({ page }) => {
  await openFixture(page);
  const name = `<img src="x" onerror="document.title='owned'">`;
  const viewer = await addViewer(page, { stats: "", style: "width:640px;height:480px" });
  await viewer.evaluate((element: RtViewerElement, material) => {
    element.scene = {
      camera: { position: [0, 0, 5] },
      materials: { [material]: {} },
      objects: [{ type: "sphere", center: [0, 0, 0], radius: 1, material }],
      environment: { radiance: [1, 1, 1] },
    };
  }, name);
  await waitForSamples(viewer, 1);
  await canvasOf(viewer).click({ position: GOLD });
  await expect(folderOf(viewer, `material · ${name}`)).toBeVisible();
  await expect(viewer.locator("[part=panel] img")).toHaveCount(0);
  expect(await page.title()).not.toBe("owned");
});
