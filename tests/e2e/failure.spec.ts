import type { RtViewerElement } from "../../src/element";
import { expect, test } from "./support/test";
import { addViewer, openFixture, waitForSamples } from "./support/viewer";

const HOSTILE = "<img src=x onerror=alert(1)>";

test("a bad scene shows every issue with its path, as text", async ({ page }) => {
  await page.route("**/bad.json", (route) =>
    route.fulfill({
      json: {
        camera: { position: [0, 0, 5], target: [0, 0, 0] },
        materials: { red: { baseColor: [2, 0, 0] } },
        objects: [
          { type: "sphere", center: [0, 0, 0], radius: -1, material: "red" },
          { type: "sphere", center: [0, 0, 0], radius: 1, material: HOSTILE },
        ],
      },
    }),
  );
  await openFixture(page);
  const viewer = await addViewer(page, { src: "bad.json" });
  const alert = viewer.getByRole("alert");
  await expect(alert).toContainText("The scene has 3 mistakes");
  await expect(alert).toContainText("objects[0].radius: expected a finite number > 0, got -1");
  await expect(alert).toContainText("materials.red.baseColor");
  await expect(alert).toContainText(HOSTILE);
  await expect(alert.locator("li")).toHaveCount(3);
  await expect(alert.locator("img")).toHaveCount(0);
});

test("a file that is not there, or no JSON, is named", async ({ page, expectedErrors }) => {
  expectedErrors.push(/404/);
  await page.route("**/missing.json", (route) => route.fulfill({ status: 404 }));
  await page.route("**/broken.json", (route) => route.fulfill({ body: "{ oops" }));
  await openFixture(page);
  const viewer = await addViewer(page, { src: "missing.json" });
  await expect(viewer.getByRole("alert")).toContainText(/missing\.json could not be fetched: 404/);
  await viewer.evaluate((element: RtViewerElement) => element.setAttribute("src", "broken.json"));
  await expect(viewer.getByRole("alert")).toContainText(/broken\.json is not JSON/);
});

test("a server that does not answer is a fetch failure", async ({ page, expectedErrors }) => {
  expectedErrors.push(/ERR_FAILED/);
  await page.route("**/gone.json", (route) => route.abort());
  await openFixture(page);
  const viewer = await addViewer(page, { src: "gone.json" });
  await expect(viewer.getByRole("alert")).toContainText(/gone\.json could not be fetched/);
});

test("the error event carries the error, and a good scene clears the message", async ({ page }) => {
  await page.route("**/empty.json", (route) => route.fulfill({ json: {} }));
  await openFixture(page);
  const viewer = await addViewer(page, {});
  const name = await viewer.evaluate(
    (element: RtViewerElement) =>
      new Promise<string>((resolve) => {
        element.addEventListener("error", ({ detail }) => resolve(detail.error.name), { once: true });
        element.src = "empty.json";
      }),
  );
  expect(name).toBe("SceneError");
  await expect(viewer.getByRole("alert")).toBeVisible();
  await viewer.evaluate((element: RtViewerElement) => element.setAttribute("src", "spheres.json"));
  await waitForSamples(viewer, 1);
  await expect(viewer.getByRole("alert")).toBeHidden();
});

test("without WebGPU the element says what is missing", async ({ page }) => {
  await page.addInitScript(() => Reflect.deleteProperty(Navigator.prototype, "gpu"));
  await openFixture(page);
  const viewer = await addViewer(page, { src: "spheres.json" });
  await expect(viewer.getByRole("alert")).toContainText("This browser has no WebGPU");
});

test("without an adapter the element says so", async ({ page }) => {
  await page.addInitScript(() => {
    GPU.prototype.requestAdapter = async () => null;
  });
  await openFixture(page);
  const viewer = await addViewer(page, { src: "spheres.json" });
  await expect(viewer.getByRole("alert")).toContainText(/adapter/);
});
