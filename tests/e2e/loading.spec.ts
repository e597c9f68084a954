import type { Locator, Page } from "@playwright/test";
import type { RtViewerElement } from "../../src/element";
import { countHoldings, holdingsOf } from "./support/counting";
import { meanColor, pictureOf } from "./support/picture";
import { expect, test } from "./support/test";
import { addViewer, openFixture, samplesOf, waitForSamples } from "./support/viewer";

const GREEN =
  "<svg xmlns='http://www.w3.org/2000/svg' width='40' height='30' viewBox='0 0 4 3'><rect width='4' height='3' fill='lime'/></svg>";

/** Keeps back a scene file until it is released. */
async function holdScene(page: Page): Promise<() => void> {
  let release = () => {};
  const held = new Promise<void>((resolve) => {
    release = resolve;
  });
  await page.route("**/spheres.json", async (route) => {
    await held;
    await route.continue();
  });
  await page.route("**/green.svg", (route) => route.fulfill({ body: GREEN, contentType: "image/svg+xml" }));
  await page.route("**/other.svg", (route) =>
    route.fulfill({ body: GREEN.replace("lime", "red"), contentType: "image/svg+xml" }),
  );
  return release;
}

const isGreen = async (viewer: Locator) => {
  const [red, green, blue] = meanColor(await pictureOf(viewer), [0, 0, 1, 0.9]);
  return green > 200 && red < 50 && blue < 50;
};

test("a poster is shown until there is a picture, and again once there is none", async ({ page }) => {
  const release = await holdScene(page);
  await openFixture(page);
  const viewer = await addViewer(page, { src: "spheres.json", poster: "green.svg" });
  await expect.poll(() => isGreen(viewer)).toBe(true);
  await expect(viewer.getByRole("progressbar", { name: "Loading" })).toBeVisible();
  release();
  await waitForSamples(viewer, 2);
  await expect.poll(() => isGreen(viewer)).toBe(false);
  await expect(viewer.getByRole("progressbar")).toBeHidden();
  await viewer.evaluate((element: RtViewerElement) => element.removeAttribute("src"));
  await expect.poll(() => isGreen(viewer)).toBe(true);
});

test("a poster covers its viewer, whatever its own size", async ({ page }) => {
  await holdScene(page);
  await openFixture(page);
  const viewer = await addViewer(page, { src: "spheres.json", poster: "green.svg" });
  const sizeOf = async (locator: Locator) => {
    const { width = 0, height = 0 } = (await locator.boundingBox()) ?? {};
    return [Math.round(width), Math.round(height)];
  };
  await expect.poll(() => isGreen(viewer)).toBe(true);
  expect(await sizeOf(viewer.locator("[part=poster]"))).toEqual(await sizeOf(viewer));
});

test("what is in the slot poster stands in for the attribute", async ({ page }) => {
  const release = await holdScene(page);
  await openFixture(page);
  const viewer = await addViewer(page, { src: "spheres.json", poster: "other.svg" });
  await viewer.evaluate((element: RtViewerElement) => {
    const poster = document.createElement("div");
    poster.slot = "poster";
    poster.style.background = "lime";
    element.append(poster);
  });
  await expect.poll(() => isGreen(viewer)).toBe(true);
  release();
  await waitForSamples(viewer, 2);
  await expect.poll(() => isGreen(viewer)).toBe(false);
});

test("what is in the slot fallback stands in for a picture there cannot be, not for a mistake in the scene", async ({
  page,
}) => {
  await page.addInitScript(() => {
    GPU.prototype.requestAdapter = async () => null;
  });
  await openFixture(page);
  const viewer = await addViewer(page, { src: "spheres.json" });
  await viewer.evaluate((element: RtViewerElement) => {
    const fallback = document.createElement("p");
    fallback.slot = "fallback";
    fallback.textContent = "A photograph of three balls";
    element.append(fallback);
  });
  const fallback = viewer.getByText("A photograph");
  await expect(fallback).toBeVisible();
  await expect(viewer.getByText(/adapter/)).toBeHidden();
});

test("loading=lazy fetches nothing and asks for no device before it is near, and then loads", async ({ page }) => {
  await countHoldings(page);
  const requested: string[] = [];
  page.on("request", (request) => requested.push(new URL(request.url()).pathname));
  await openFixture(page);
  await page.evaluate(() => {
    document.body.style.paddingTop = "5000px";
  });
  const lazy = page.locator("rt-viewer").first();
  await addViewer(page, { loading: "lazy", src: "spheres.json", poster: "missing.svg" });
  const eager = await addViewer(page, { src: "furnace.json" });
  await waitForSamples(eager, 1);
  expect(await samplesOf(lazy)).toBe(0);
  expect(requested.filter((path) => /spheres|missing/.test(path))).toEqual([]);
  await eager.evaluate((element) => element.remove());
  await expect.poll(() => holdingsOf(page)).toMatchObject({ devices: 0, devicesMade: 1 });

  await lazy.evaluate((element) => element.removeAttribute("poster"));
  await page.evaluate(() => scrollTo(0, 3900)); // a screen of 600 pixels ends half a screen above it
  await waitForSamples(lazy, 1);
});

test("a lazy viewer that becomes eager loads at once", async ({ page }) => {
  await openFixture(page);
  await page.evaluate(() => {
    document.body.style.paddingTop = "5000px";
  });
  const viewer = await addViewer(page, { loading: "lazy", src: "spheres.json" });
  await viewer.evaluate((element: RtViewerElement) => {
    element.loading = "eager";
  });
  await waitForSamples(viewer, 1);
});

test("loadprogress tells the phases in their order, and ready ends them", async ({ page }) => {
  await openFixture(page);
  const seen = await page.evaluate(
    () =>
      new Promise<string[]>((resolve) => {
        const seen: string[] = [];
        const viewer = document.createElement("rt-viewer");
        viewer.addEventListener("loadprogress", ({ detail }) => seen.push(detail.phase));
        viewer.addEventListener("ready", () => resolve([...seen, "ready"]));
        viewer.src = "spheres.json";
        document.body.append(viewer);
      }),
  );
  expect(seen.filter((phase, index) => phase !== seen[index - 1])).toEqual(["fetching", "compiling", "ready"]);
});
