import type { Locator, Page } from "@playwright/test";
import { MIN_WORKER_PRIMITIVES } from "../../src/bvh/buildInWorker";
import type { WorkerReply } from "../../src/bvh/workerMessages";
import type { RtViewerElement } from "../../src/element";
import { bumpyScene } from "./support/bumpyScene";
import { contrast, pictureOf } from "./support/picture";
import { expect, test } from "./support/test";
import { addViewer, openFixture, openViewer, waitForSamples } from "./support/viewer";

const BIG = 2 * MIN_WORKER_PRIMITIVES;
const SMALL = MIN_WORKER_PRIMITIVES / 2;

/** Lets a page find meshes of these sizes as `bumpy-SIZE.json`. */
async function serveMeshes(page: Page, ...sizes: readonly number[]): Promise<void> {
  for (const size of sizes) {
    await page.route(`**/bumpy-${size}.json`, (route) => route.fulfill({ json: bumpyScene(size) }));
  }
}

/** What workers do, in the order they do it. To be called before the first of them. */
function watchWorkers(page: Page): string[] {
  const seen: string[] = [];
  page.on("worker", (worker) => {
    seen.push("start");
    worker.on("close", () => seen.push("close"));
  });
  return seen;
}

/** Puts another script in the place of the worker's: it says that it runs, and does this with the bounds it gets. */
async function replaceWorker(page: Page, onBounds: string): Promise<void> {
  const ready: WorkerReply = { type: "ready" };
  const body = `onmessage = () => { ${onBounds} }; postMessage(${JSON.stringify(ready)});`;
  await page.route("**/bvhWorker*.js", (route) => route.fulfill({ body, contentType: "text/javascript" }));
}

/** A worker that gets through a quarter of its work and no further. */
async function stallWorker(page: Page): Promise<void> {
  const progress: WorkerReply = { type: "progress", fraction: 0.25 };
  await replaceWorker(page, `postMessage(${JSON.stringify(progress)})`);
}

const isStalled = (viewer: Locator) =>
  expect(viewer.getByRole("progressbar", { name: "Loading" })).toHaveAttribute("aria-valuenow", "25");

const objectsOf = (viewer: Locator) =>
  viewer.evaluate((element: RtViewerElement) => element.tracer?.scene.objects.map(({ type }) => type));

test("the tree of a big mesh is built in one worker, which tells how far it is and is closed then", async ({
  page,
}) => {
  await serveMeshes(page, BIG);
  const workers = watchWorkers(page);
  await openFixture(page);
  const viewer = await addViewer(page, {});
  const { phases, fractions } = await viewer.evaluate(
    (element: RtViewerElement, src) =>
      new Promise<{ phases: string[]; fractions: number[] }>((resolve) => {
        const [phases, fractions]: [string[], number[]] = [[], []];
        element.addEventListener("loadprogress", ({ detail: { phase, fraction } }) => {
          if (phase !== phases.at(-1)) phases.push(phase);
          if (phase === "building") fractions.push(fraction!);
        });
        element.addEventListener("ready", () => resolve({ phases, fractions }));
        element.src = src;
      }),
    `bumpy-${BIG}.json`,
  );
  expect(phases).toEqual(["fetching", "compiling", "building", "compiling"]);
  expect(fractions.length).toBeGreaterThan(10);
  expect(fractions).toEqual(fractions.toSorted((a, b) => a - b));
  expect(fractions[0]).toBeGreaterThan(0);
  expect(fractions.at(-1)).toBeLessThan(1);
  await expect.poll(() => workers).toEqual(["start", "close"]);
  expect(contrast(await pictureOf(viewer))).toBeGreaterThan(20);
});

test("the tree of a small mesh is built without a worker", async ({ page }) => {
  await serveMeshes(page, SMALL);
  const workers = watchWorkers(page);
  const viewer = await openViewer(page, { src: `bumpy-${SMALL}.json` });
  expect(contrast(await pictureOf(viewer))).toBeGreaterThan(20);
  expect(workers).toEqual([]);
});

for (const shown of [undefined, "spheres.json"]) {
  const before = shown === undefined ? "before there is a picture" : "behind a picture";

  /** A viewer whose worker builds, and will not come to an end. */
  const openBuilding = async (page: Page) => {
    await serveMeshes(page, BIG);
    await stallWorker(page);
    await openFixture(page);
    const viewer = await addViewer(page, shown === undefined ? {} : { src: shown });
    if (shown !== undefined) await waitForSamples(viewer, 1);
    await viewer.evaluate((element, src) => element.setAttribute("src", src), `bumpy-${BIG}.json`);
    await isStalled(viewer);
    return viewer;
  };

  test(`${before}, a scene that is set while a worker builds ends it, and is shown`, async ({ page }) => {
    const workers = watchWorkers(page);
    const viewer = await openBuilding(page);
    expect(workers).toEqual(["start"]);
    await viewer.evaluate((element) => element.setAttribute("src", "furnace.json"));
    await expect.poll(() => workers).toEqual(["start", "close"]);
    await expect.poll(() => objectsOf(viewer)).toEqual(Array(8).fill("sphere"));
    await expect(viewer.getByRole("progressbar")).toBeHidden();
    await waitForSamples(viewer, 2);
  });

  test(`${before}, an element that is removed while a worker builds ends it, and loads when it is put back`, async ({
    page,
  }) => {
    const workers = watchWorkers(page);
    const viewer = await openBuilding(page);
    expect(workers).toEqual(["start"]);
    const element = await viewer.evaluateHandle((element) => element);
    await element.evaluate((element) => element.remove());
    await expect.poll(() => workers).toEqual(["start", "close"]);
    await page.unroute("**/bvhWorker*.js");
    await element.evaluate((element) => document.body.append(element));
    await waitForSamples(viewer, 1);
    expect(await objectsOf(viewer)).toContain("mesh");
  });
}

test("a setting that changes while a worker builds leaves it at work", async ({ page }) => {
  const workers = watchWorkers(page);
  await serveMeshes(page, BIG);
  await stallWorker(page);
  const viewer = await openViewer(page, { src: "spheres.json" });
  await viewer.evaluate((element, src) => element.setAttribute("src", src), `bumpy-${BIG}.json`);
  await isStalled(viewer);
  const isReady = await viewer.evaluate(async (element: RtViewerElement) => {
    let isReady = false;
    element.addEventListener("ready", () => {
      isReady = true;
    });
    element.lightSamples = 3;
    for (let frame = 0; frame < 10; frame++) await new Promise(requestAnimationFrame);
    return isReady;
  });
  expect(isReady).toBe(false);
  await isStalled(viewer);
  expect(workers).toEqual(["start"]);
});

test("a worker that fails is said in the element, not waited for", async ({ page, expectedErrors }) => {
  expectedErrors.push(/out of luck/);
  await serveMeshes(page, BIG);
  await replaceWorker(page, "throw new Error('out of luck')");
  await openFixture(page);
  const viewer = await addViewer(page, { src: `bumpy-${BIG}.json` });
  await expect(viewer.getByRole("alert")).toContainText(/The BVH's worker failed: .*out of luck/);
});
