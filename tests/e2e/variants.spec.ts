import type { Locator, Page } from "@playwright/test";
import type { RtViewerElement } from "../../src/element";
import { triangleFile, variantFile } from "../support/gltf";
import { meanColor, pictureOf } from "./support/picture";
import { expect, test } from "./support/test";
import { addViewer, openFixture, openViewer, samplesOf, waitForSamples } from "./support/viewer";

/** Within the triangle of the file, as it is framed. */
const MIDDLE = [0.44, 0.5, 0.5, 0.58] as const;

/** Serves the file as model.glb. @returns what has been fetched so far. */
async function serve(page: Page, file = variantFile()): Promise<string[]> {
  const fetched: string[] = [];
  await page.route("**/*.glb", (route) => {
    fetched.push(new URL(route.request().url()).pathname);
    return route.fulfill({ body: Buffer.from(file) });
  });
  return fetched;
}

/** The channel that stands out where the triangle is. */
async function colorOf(viewer: Locator): Promise<string> {
  const mean = meanColor(await pictureOf(viewer), MIDDLE);
  const [first, second] = mean.map((value, channel) => ({ value, channel })).sort((a, b) => b.value - a.value);
  return first!.value > second!.value + 40 ? ["red", "green", "blue"][first!.channel]! : `none: ${mean}`;
}

const setVariant = (viewer: Locator, name: string | null) =>
  viewer.evaluate((element: RtViewerElement, value) => {
    element.variantName = value;
  }, name);

const variantsOf = (viewer: Locator) => viewer.evaluate((element: RtViewerElement) => [...element.variants]);
const cameraOf = (viewer: Locator) => viewer.evaluate((element: RtViewerElement) => element.camera!);

/** What comes into the console as a warning. */
function warningsOf(page: Page): string[] {
  const warnings: string[] = [];
  page.on("console", (message) => {
    if (message.type() === "warning" && message.text().includes("<rt-viewer>")) warnings.push(message.text());
  });
  return warnings;
}

test("a variant is shown without another download, in a new accumulation, from where the camera is", async ({
  page,
}) => {
  const fetched = await serve(page);
  const attributes = { src: "model.glb", "camera-orbit": "10deg 20deg auto", "max-samples": "6" };
  const viewer = await openViewer(page, attributes, 6);
  expect(await variantsOf(viewer)).toEqual(["Red", "Blue"]);
  expect(await colorOf(viewer)).toBe("green");

  const before = await viewer.evaluate((element: RtViewerElement) => {
    const { position } = element.camera!;
    element.camera = { position: [position[0], position[1] + 0.2, position[2]] };
    return element.camera!;
  });
  for (const [name, color] of [
    ["Red", "red"],
    ["Blue", "blue"],
    [null, "green"],
  ] as const) {
    await waitForSamples(viewer, 6);
    const seen = await viewer.evaluateHandle((element: RtViewerElement, value) => {
      const { tracer } = element;
      const seen = { readies: 0, hasSameTracer: false, leastSamples: Number.POSITIVE_INFINITY };
      element.addEventListener("ready", ({ detail }) => {
        seen.readies += 1;
        seen.hasSameTracer = detail.tracer === tracer;
      });
      element.addEventListener("progress", ({ detail }) => {
        seen.leastSamples = Math.min(seen.leastSamples, detail.samples);
      });
      element.variantName = value;
      return seen;
    }, name);
    await expect.poll(() => colorOf(viewer)).toBe(color);
    const { readies, hasSameTracer, leastSamples } = await seen.jsonValue();
    expect([readies, hasSameTracer]).toEqual([1, true]);
    expect(leastSamples).toBeLessThan(6);
    expect(await cameraOf(viewer)).toEqual(before);
  }
  await expect(viewer).not.toHaveAttribute("variant-name");
  expect(fetched).toEqual(["/model.glb"]);
});

test("of quick changes the last one holds, though the camera moves meanwhile", async ({ page }) => {
  const fetched = await serve(page);
  const viewer = await openViewer(page, { src: "model.glb", "variant-name": "Red" }, 4);
  const moved = await viewer.evaluate((element: RtViewerElement) => {
    const names = ["Blue", null, "Red", "Moon", "Blue", "Red", "Blue"];
    for (const name of names) element.variantName = name;
    const { position } = element.camera!;
    element.camera = { position: [position[0] + 0.1, position[1], position[2]] };
    return element.camera;
  });
  await expect.poll(() => colorOf(viewer)).toBe("blue");
  expect(await cameraOf(viewer)).toEqual(moved);
  await expect(viewer.getByRole("progressbar")).toBeHidden();
  expect(await colorOf(viewer)).toBe("blue");
  expect(fetched).toEqual(["/model.glb"]);
});

test("a change while the file is on its way does not fetch it again", async ({ page }) => {
  let release = () => {};
  const held = new Promise<void>((resolve) => {
    release = resolve;
  });
  const fetched: string[] = [];
  await page.route("**/model.glb", async (route) => {
    fetched.push(route.request().url());
    await held;
    await route.fulfill({ body: Buffer.from(variantFile()) });
  });
  await openFixture(page);
  const viewer = await addViewer(page, { src: "model.glb", "variant-name": "Red" });
  await expect.poll(() => fetched.length).toBe(1);
  await setVariant(viewer, "Blue");
  expect(await variantsOf(viewer)).toEqual([]);
  release();
  await waitForSamples(viewer, 4);
  await expect.poll(() => colorOf(viewer)).toBe("blue");
  expect(fetched).toHaveLength(1);
});

test("a name that is set before the element is in a document is honoured", async ({ page }) => {
  await serve(page);
  await openFixture(page);
  await page.evaluate(() => {
    const viewer = document.createElement("rt-viewer");
    viewer.variantName = "Blue";
    viewer.src = "model.glb";
    document.body.append(viewer);
  });
  const viewer = page.locator("rt-viewer");
  await waitForSamples(viewer, 4);
  expect(await colorOf(viewer)).toBe("blue");
  await expect(viewer).toHaveAttribute("variant-name", "Blue");
});

test("a name that is set while the element is moved is honoured", async ({ page }) => {
  const fetched = await serve(page);
  const viewer = await openViewer(page, { src: "model.glb" }, 4);
  await viewer.evaluate((element: RtViewerElement) => {
    element.remove();
    element.variantName = "Red";
    document.body.append(element);
  });
  await expect.poll(() => colorOf(viewer)).toBe("red");
  expect(fetched).toHaveLength(1);
});

test("an unknown name shows the default, and a warning lists the names; without a picture that changes, none starts over", async ({
  page,
}) => {
  const warnings = warningsOf(page);
  await serve(page);
  const viewer = await openViewer(page, { src: "model.glb", "variant-name": "Moon", "max-samples": "6" }, 6);
  expect(await colorOf(viewer)).toBe("green");
  const ofMoon = '<rt-viewer>: The file has no variant "Moon": it has "Red", "Blue"';
  expect(warnings).toEqual([ofMoon]);

  const told = await viewer.evaluate((element: RtViewerElement) => {
    const told: string[] = [];
    element.addEventListener("loadwarnings", ({ detail }) => told.push(...detail.warnings));
    element.variantName = "Mars";
    return told;
  });
  expect(told).toEqual(['The file has no variant "Mars": it has "Red", "Blue"']);
  expect(await samplesOf(viewer)).toBe(6);
  await setVariant(viewer, "Red");
  await expect.poll(() => colorOf(viewer)).toBe("red");
  await setVariant(viewer, "Moon");
  await expect.poll(() => colorOf(viewer)).toBe("green");
  expect(warnings).toEqual([ofMoon, ofMoon.replace("Moon", "Mars"), ofMoon]);
});

test("another file, a broken one too, has its own variants or none", async ({ page, expectedErrors }) => {
  const warnings = warningsOf(page);
  await serve(page);
  await page.route("**/plain.glb", (route) => route.fulfill({ body: Buffer.from(triangleFile()) }));
  await page.route("**/broken.glb", (route) => route.fulfill({ body: "glTF?" }));
  const viewer = await openViewer(page, { src: "model.glb", "variant-name": "Red" }, 2);
  expect(await variantsOf(viewer)).toEqual(["Red", "Blue"]);
  const show = (src: string) =>
    viewer.evaluate(
      (element: RtViewerElement, value) =>
        new Promise<string>((resolve) => {
          for (const type of ["ready", "error"] as const) {
            element.addEventListener(type, () => resolve(type), { once: true });
          }
          element.src = value;
        }),
      src,
    );
  expectedErrors.push(/404/);
  expect(await show("broken.glb")).toBe("error");
  expect(await variantsOf(viewer)).toEqual([]);
  expect(await show("model.glb")).toBe("ready");
  expect(await variantsOf(viewer)).toEqual(["Red", "Blue"]);
  await expect.poll(() => colorOf(viewer)).toBe("red");
  expect(await show("plain.glb")).toBe("ready");
  expect(await variantsOf(viewer)).toEqual([]);
  expect(warnings).toEqual(['<rt-viewer>: The file has no variant "Red": it has none']);
  expect(await show("nowhere.json")).toBe("error");
  expect(await variantsOf(viewer)).toEqual([]);
});

test("files that were opened have variants, until a scene is set", async ({ page }) => {
  await openFixture(page);
  const viewer = await addViewer(page, { "variant-name": "Red" });
  await viewer.evaluate(
    (element: RtViewerElement, bytes) => element.open(new Blob([Uint8Array.from(bytes)])),
    [...variantFile()],
  );
  await waitForSamples(viewer, 4);
  expect(await colorOf(viewer)).toBe("red");
  expect(await variantsOf(viewer)).toEqual(["Red", "Blue"]);
  await setVariant(viewer, "Blue");
  await expect.poll(() => colorOf(viewer)).toBe("blue");
  const materials = await viewer.evaluate(({ scene }: RtViewerElement) => Object.keys(scene?.materials ?? {}));
  expect(materials).toContain("blue");
  await viewer.evaluate((element: RtViewerElement) => {
    element.scene = { camera: { position: [0, 0, 5] }, objects: [], environment: { radiance: [1, 1, 1] } };
  });
  expect(await variantsOf(viewer)).toEqual([]);
});

test("the variant and the camera outlive the loss of the device, also while another variant is on its way", async ({
  page,
}) => {
  await serve(page);
  const viewer = await openViewer(page, { src: "model.glb", "camera-orbit": "10deg 20deg auto" }, 4);
  const moved = await viewer.evaluate((element: RtViewerElement) => {
    const { position } = element.camera!;
    element.camera = { position: [position[0], position[1] + 0.1, position[2]] };
    const { camera } = element;
    element.variantName = "Red";
    element.tracer!.device.destroy();
    return camera;
  });
  await expect.poll(() => colorOf(viewer)).toBe("red");
  expect(await cameraOf(viewer)).toEqual(moved);
  await viewer.evaluate((element: RtViewerElement) => element.tracer!.device.destroy());
  await expect
    .poll(() => viewer.evaluate(({ tracer }: RtViewerElement) => tracer?.stats.samples ?? 0))
    .toBeGreaterThan(2);
  await setVariant(viewer, "Blue");
  await expect.poll(() => colorOf(viewer)).toBe("blue");
  expect(await cameraOf(viewer)).toEqual(moved);
});
