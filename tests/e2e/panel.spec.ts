import type { RtViewerElement } from "../../src/element";
import { type Area, meanColor, pictureOf } from "./support/picture";
import { expect, test } from "./support/test";
import { addViewer, openFixture, openViewer, waitForSamples } from "./support/viewer";

const ROOMY = { src: "spheres.json", stats: "", style: "width:640px;height:480px" };

test("the panel's code is loaded only when it is asked for", async ({ page }) => {
  const loaded: string[] = [];
  page.on("request", (request) => loaded.push(request.url()));
  const viewer = await openViewer(page, { src: "spheres.json" });
  expect(loaded.filter((url) => /panel/.test(url))).toEqual([]);
  await viewer.evaluate((element: RtViewerElement) => element.toggleAttribute("stats", true));
  await expect(viewer.getByText("bad samples")).toBeAttached();
  expect(loaded.filter((url) => /panel/.test(url))).toHaveLength(1);
});

test("the panel follows the figures", async ({ page }) => {
  const viewer = await openViewer(page, ROOMY, 2);
  const samples = viewer.locator(".tp-lblv", { hasText: /^samples$/ }).locator("input");
  await expect.poll(async () => Number(await samples.inputValue())).toBeGreaterThanOrEqual(2);
  const early = Number(await samples.inputValue());
  await expect.poll(async () => Number(await samples.inputValue())).toBeGreaterThan(early);
  await expect(viewer.locator(".tp-lblv", { hasText: "bad samples" }).locator("input")).toHaveValue("0");
  await expect(viewer.getByText(/fps · [\d.]+ % error/)).toBeVisible();
  // Both graphs have a line by now.
  await expect(viewer.locator("polyline[points*=',']")).toHaveCount(2);
});

test("the shader's contents can be read in the panel", async ({ page }) => {
  const viewer = await openViewer(page, ROOMY);
  await viewer.getByRole("button", { name: "Shader" }).click();
  await expect(viewer.locator(".tp-lblv", { hasText: "contains" }).locator("textarea")).toHaveValue(/sphere/);
  await expect(viewer.locator(".tp-lblv", { hasText: "adapter" }).locator("textarea")).toHaveValue(/\w/);
});

test("turning up the exposure brightens the picture without starting over", async ({ page }) => {
  const viewer = await openViewer(page, ROOMY, 4);
  const canvas = viewer.locator("canvas");
  const floor: Area = [0.1, 0.8, 0.4, 0.95];
  const before = meanColor(await pictureOf(canvas), floor);
  const exposure = viewer.locator(".tp-lblv", { hasText: "exposure" }).locator("input");
  await exposure.fill("-3");
  await exposure.press("Enter");
  await expect(viewer).toHaveAttribute("exposure", "-3");
  await expect.poll(async () => meanColor(await pictureOf(canvas), floor)[1]).toBeLessThan(0.6 * before[1]);
  await waitForSamples(viewer, 4);
});

test("the knobs set the tracer and start the sampling over", async ({ page }) => {
  const viewer = await openViewer(page, ROOMY, 3);
  const bounces = viewer.locator(".tp-lblv", { hasText: "bounces" }).locator("input");
  await expect(bounces).toHaveValue("6"); // as the scene says
  await bounces.fill("1");
  await bounces.press("Enter");
  await expect(viewer).toHaveAttribute("max-bounces", "1");
  const settings = () => viewer.evaluate((element: RtViewerElement) => element.tracer?.settings.maxBounces);
  await expect.poll(settings).toBe(1);

  // And the other way round: attributes show in the panel.
  await viewer.evaluate((element: RtViewerElement) => element.setAttribute("max-bounces", "4"));
  await expect(bounces).toHaveValue("4");
  await waitForSamples(viewer, 1);
});

test("starting over throws the samples away", async ({ page }) => {
  const viewer = await openViewer(page, ROOMY, 4);
  await viewer.evaluate((element: RtViewerElement) => {
    element.addEventListener("progress", ({ detail }) => {
      element.dataset.fewest = String(Math.min(Number(element.dataset.fewest ?? 1e9), detail.samples));
    });
  });
  await viewer.getByRole("button", { name: "Start over" }).click();
  await expect(viewer).toHaveAttribute("data-fewest", /^[1-3]$/);
});

test("a small element starts with its panel folded, and so does one that asks for it", async ({ page }) => {
  await openFixture(page);
  const small = await addViewer(page, { ...ROOMY, style: "width:240px;height:180px" });
  await expect(small.locator(".tp-rotv")).not.toHaveClass(/expanded/);
  await small.evaluate((element: RtViewerElement) => element.remove());
  const folded = await addViewer(page, { ...ROOMY, stats: "folded" });
  await expect(folded.locator(".tp-rotv")).not.toHaveClass(/expanded/);
});
