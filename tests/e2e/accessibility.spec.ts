import AxeBuilder from "@axe-core/playwright";
import type { Locator, Page } from "@playwright/test";
import type { RtViewerElement } from "../../src/element";
import { difference, pictureOf } from "./support/picture";
import { expect, test } from "./support/test";
import { addViewer, openFixture, openViewer, samplesOf, waitForSamples } from "./support/viewer";

const ALT = "Three balls on a floor";

async function expectNoViolations(page: Page): Promise<void> {
  const { violations } = await new AxeBuilder({ page }).include("rt-viewer").analyze();
  expect(violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join(" ")}`)).toEqual([]);
}

test("axe finds nothing to object to: loading, with controls and without, and in an error, light and dark", async ({
  page,
}) => {
  let release = () => {};
  const held = new Promise<void>((resolve) => {
    release = resolve;
  });
  await page.route("**/spheres.json", async (route) => {
    await held;
    await route.continue();
  });
  await page.route("**/bad.json", (route) =>
    route.fulfill({ json: { objects: Array.from({ length: 30 }, () => ({})) } }),
  );
  await openFixture(page);
  const viewer = await addViewer(page, { src: "spheres.json", controls: "", alt: ALT });
  await expect(viewer.getByRole("progressbar")).toBeVisible();
  await expectNoViolations(page);
  release();
  await waitForSamples(viewer, 1);
  await expectNoViolations(page);
  await viewer.evaluate((element: RtViewerElement) => {
    element.controls = false;
  });
  await expectNoViolations(page);
  for (const colorScheme of ["light", "dark"] as const) {
    await page.emulateMedia({ colorScheme });
    await viewer.evaluate((element: RtViewerElement) => element.setAttribute("src", "bad.json"));
    await expect(viewer.getByRole("alert")).toBeVisible();
    await expectNoViolations(page);
  }
});

test("the accessibility tree has one thing with a name, a role in words and the keys it takes", async ({ page }) => {
  const viewer = await openViewer(page, { src: "spheres.json", alt: ALT, "max-samples": "2" }, 2);
  await expect(viewer.getByRole("status")).toHaveText("The picture is finished");
  await expect(viewer).toMatchAriaSnapshot(`
    - img "${ALT}"
    - status: The picture is finished
  `);
  await viewer.evaluate((element: RtViewerElement) => {
    element.controls = true;
  });
  await expect(viewer).toMatchAriaSnapshot(`
    - application "${ALT}"
    - status: The picture is finished
  `);
  const canvas = viewer.getByRole("application");
  await expect(canvas).toHaveAccessibleDescription(/Arrow keys turn.*Plus and minus zoom/);
  await expect(canvas).toHaveAttribute("aria-roledescription", "3D view");
  await viewer.evaluate((element: RtViewerElement) => element.removeAttribute("alt"));
  await expect(canvas).toHaveAccessibleName("3D scene");
});

test("the live region is silent while a scene loads fast, and speaks once when the picture is finished", async ({
  page,
}) => {
  await openFixture(page);
  const said = await page.evaluate(
    () =>
      new Promise<string[]>((resolve) => {
        const viewer = document.createElement("rt-viewer");
        const region = viewer.shadowRoot!.querySelector("[role=status]")!;
        const said: string[] = [];
        new MutationObserver(() => said.push(region.textContent)).observe(region, { childList: true });
        let convergedCount = 0;
        viewer.addEventListener("converged", () => {
          convergedCount += 1;
          if (convergedCount === 3) setTimeout(resolve, 0, said);
          else viewer.reset();
        });
        viewer.maxSamples = 2;
        viewer.src = "furnace.json";
        document.body.append(viewer);
      }),
  );
  expect(said.filter((text) => text !== "" && !/Loading|finer/.test(text))).toEqual(["The picture is finished"]);
});

test("a slow scene is announced", async ({ page }) => {
  await page.route("**/slow.json", () => {});
  await openFixture(page);
  const viewer = await addViewer(page, { src: "slow.json" });
  await expect(viewer.getByRole("status")).toHaveText("Loading the scene");
});

/** Pixels of the element's own ring: the colour asked for, which nothing in the scene has. */
async function ringPixels(viewer: Locator): Promise<number> {
  const { data, channels } = await pictureOf(viewer);
  let count = 0;
  for (let i = 0; i < data.length; i += channels) {
    if (data[i] === 255 && data[i + 1] === 0 && data[i + 2] === 255) count += 1;
  }
  return count;
}

test("the keyboard's focus is seen all around the picture, a click's is not", async ({ page }) => {
  const style = "--rt-viewer-focus-color: #ff00ff";
  const viewer = await openViewer(page, { src: "spheres.json", controls: "", style }, 1);
  await viewer.click();
  expect(await ringPixels(viewer)).toBe(0);
  await page.keyboard.press("Tab");
  await page.keyboard.press("Shift+Tab");
  // Two pixels wide along 320 and 240.
  await expect.poll(() => ringPixels(viewer)).toBeGreaterThan(2000);
});

test.describe("with a finger", () => {
  test.use({ hasTouch: true });

  /** A swipe over the middle of the viewer as the browser's own input pipeline sees it. */
  async function swipe(page: Page, [dx, dy]: readonly [number, number]): Promise<void> {
    const session = await page.context().newCDPSession(page);
    const touch = (type: "touchStart" | "touchMove" | "touchEnd", x: number, y: number) =>
      session.send("Input.dispatchTouchEvent", { type, touchPoints: type === "touchEnd" ? [] : [{ x, y }] });
    await touch("touchStart", 160, 120);
    for (let step = 1; step <= 8; step++) await touch("touchMove", 160 + (dx * step) / 8, 120 + (dy * step) / 8);
    await touch("touchEnd", 0, 0);
  }

  test("an upright swipe scrolls the page, a level one turns the view", async ({ page }) => {
    const viewer = await openViewer(page, { src: "spheres.json", controls: "" }, 1);
    const cameraOf = () => viewer.evaluate((element: RtViewerElement) => element.camera!);
    const ends = await viewer.evaluateHandle((element: RtViewerElement) => {
      document.body.style.height = "4000px";
      const seen: string[] = [];
      for (const type of ["pointerup", "pointercancel"]) element.addEventListener(type, () => seen.push(type));
      return seen;
    });
    const endsOf = () => ends.evaluate((seen) => seen);

    const before = await cameraOf();
    await swipe(page, [80, 0]);
    await expect.poll(endsOf).toEqual(["pointerup"]);
    const turned = await cameraOf();
    expect(Math.abs(turned.position[0] - before.position[0])).toBeGreaterThan(1);
    expect(await page.evaluate(() => scrollY)).toBe(0);

    await swipe(page, [0, -100]);
    await expect.poll(() => page.evaluate(() => scrollY)).toBeGreaterThan(20);
    expect(await endsOf()).toEqual(["pointerup", "pointercancel"]);
    expect(await cameraOf()).toEqual(turned);
  });
});

test("less motion: the picture is drawn again only when it has twice the samples, and at once when it is another", async ({
  page,
}) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.addInitScript(() => {
    const counts = { drawn: 0 };
    Object.assign(globalThis, { counts });
    const { getCurrentTexture } = GPUCanvasContext.prototype;
    GPUCanvasContext.prototype.getCurrentTexture = function () {
      counts.drawn += 1;
      return getCurrentTexture.call(this);
    };
  });
  const drawnOf = () => page.evaluate(() => (globalThis as unknown as { counts: { drawn: number } }).counts.drawn);
  const viewer = await openViewer(page, { src: "furnace.json" }, 40);
  // Of 40 samples those are six, and one more where the canvas gets its size.
  expect(await drawnOf()).toBeLessThanOrEqual(2 + Math.log2(await samplesOf(viewer)) + 1);
  const before = await pictureOf(viewer);
  await viewer.evaluate((element: RtViewerElement) => {
    element.exposure = -4;
  });
  await expect.poll(async () => difference(before, await pictureOf(viewer))).toBeGreaterThan(20);
});
