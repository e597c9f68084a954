import type { RtViewerElement } from "../../src/element";
import type { PathTracer } from "../../src/renderer/pathTracer";
import { collectGpuErrors, gpuErrorsOf } from "./support/gpuErrors";
import { expect, test } from "./support/test";
import { addViewer, openFixture, openViewer, samplesOf, waitForSamples } from "./support/viewer";

const SMALL = { src: "spheres.json", style: "width:160px;height:120px" };

test("one viewer's GPU error ends it alone, with its own message, and its neighbour goes on", async ({ page }) => {
  await collectGpuErrors(page);
  await openViewer(page, { ...SMALL, id: "own" });
  await addViewer(page, { ...SMALL, id: "neighbour" });
  const [own, neighbour] = [page.locator("#own"), page.locator("#neighbour")];
  await waitForSamples(neighbour, 1);
  const error = await own.evaluate(async (element: RtViewerElement) => {
    const { createBuffer } = GPUDevice.prototype;
    GPUDevice.prototype.createBuffer = function (descriptor) {
      const isBroken = descriptor.label === "film" && descriptor.size === 2 * 100 * 50 * 16;
      return createBuffer.call(this, isBroken ? { ...descriptor, usage: 0 } : descriptor);
    };
    const failed = new Promise<Error>((resolve) => {
      element.addEventListener("error", ({ detail }) => resolve(detail.error), { once: true });
    });
    element.style.cssText = "width:100px;height:50px";
    const { name, message } = await failed;
    return { name, message };
  });
  expect(error.name).toBe("WebGpuError");
  expect(error.message).toContain("usages must not be 0");
  await expect(own.getByRole("alert")).toContainText("usages must not be 0");
  await waitForSamples(neighbour, (await samplesOf(neighbour)) + 4);
  await expect(neighbour.getByRole("alert")).toBeHidden();
  expect((await gpuErrorsOf(page)).uncaptured).toEqual([]);
  // And it is not lost for good.
  await own.evaluate((element: RtViewerElement) => {
    element.style.cssText = "width:104px;height:50px";
    element.reset();
  });
  await waitForSamples(own, 1);
  await expect(own.getByRole("alert")).toBeHidden();
});

test("a page's own error on a device it lent reaches the page, and no tracer", async ({ page }) => {
  await collectGpuErrors(page);
  const viewer = await openViewer(page, SMALL);
  const seen = await viewer.evaluate(async (element: RtViewerElement) => {
    const { scene } = element.tracer!;
    const { create } = element.tracer!.constructor as typeof PathTracer;
    const device = await (await navigator.gpu.requestAdapter())!.requestDevice();
    const told: string[] = [];
    device.onuncapturederror = ({ error }) => void told.push(error.message);
    const tracer = await create({ scene, width: 32, height: 24, device });
    device.createBuffer({ label: "the page's", size: 16, usage: 0 });
    await tracer.sample(4);
    device.createBuffer({ label: "the page's", size: 16, usage: 0 });
    const picture = await tracer.readPicture();
    tracer.dispose();
    device.destroy();
    return { told, samples: tracer.stats.samples, bytes: picture.length };
  });
  expect(seen).toMatchObject({ samples: 4, bytes: 4 * 32 * 24 });
  expect(seen.told).toHaveLength(2);
  for (const message of seen.told) expect(message).toContain("the page's");
  expect((await gpuErrorsOf(page)).captured).toEqual([]);
});

test("a picture or a canvas too large for the device is refused with the limit and the need", async ({ page }) => {
  await collectGpuErrors(page);
  const viewer = await openViewer(page, SMALL);
  const refusals = await viewer.evaluate(async (element: RtViewerElement) => {
    const { scene, device } = element.tracer!;
    const { create } = element.tracer!.constructor as typeof PathTracer;
    const messageOf = async (work: () => unknown) => {
      try {
        await work();
        return "none";
      } catch (error) {
        return `${(error as Error).name}: ${(error as Error).message}`;
      }
    };
    const tracer = await create({ scene, width: 32, height: 24, device });
    await tracer.sample(1);
    const canvas = document.createElement("canvas");
    const context = canvas.getContext("webgpu")!;
    context.configure({ device, format: "rgba8unorm" });
    Object.assign(canvas, { width: 20_000, height: 10 });
    const present = async () => {
      while (!tracer.present(context)) await new Promise(requestAnimationFrame);
    };
    const refusals = [
      await messageOf(() => create({ scene, width: 20_000, height: 20_000, device })),
      await messageOf(() => tracer.resize(20_000, 20_000)),
      await messageOf(present),
      await messageOf(() => tracer.sample(1)),
    ];
    tracer.dispose();
    return refusals;
  });
  const film = /^UnsupportedError: max\w+Size is \d+ MiB; a picture of 20000 × 20000 pixels needs 12208 MiB$/;
  expect(refusals[0]).toMatch(film);
  expect(refusals[1]).toMatch(film);
  expect(refusals[2]).toMatch(
    /^UnsupportedError: maxTextureDimension2D is \d+; a picture of 20000 × 10 pixels needs 20000$/,
  );
  expect(refusals[3]).toBe("none");
  expect((await gpuErrorsOf(page)).uncaptured).toEqual([]);
});

test("out of memory is told as what it is, and gives back what there was", async ({ page }) => {
  await openFixture(page);
  const viewer = await addViewer(page, SMALL);
  await waitForSamples(viewer, 2);
  const isLost = await viewer.evaluate(async (element: RtViewerElement) => {
    const { device } = element.tracer!;
    // The last scope of a resize says that there was no memory; a software adapter has too much of it.
    const { createBuffer } = GPUDevice.prototype;
    GPUDevice.prototype.createBuffer = function (descriptor) {
      const { popErrorScope } = GPUDevice.prototype;
      GPUDevice.prototype.popErrorScope = function () {
        GPUDevice.prototype.popErrorScope = popErrorScope;
        return popErrorScope.call(this).then(() => new GPUOutOfMemoryError("Failed to allocate memory for buffer"));
      };
      GPUDevice.prototype.createBuffer = createBuffer;
      return createBuffer.call(this, descriptor);
    };
    element.style.cssText = "width:100px;height:50px";
    await device.lost;
    return element.tracer === undefined;
  });
  expect(isLost).toBe(true);
  await expect(viewer.getByRole("alert")).toContainText("The GPU is out of memory");
  await viewer.evaluate((element: RtViewerElement) => element.setAttribute("src", "furnace.json"));
  await waitForSamples(viewer, 2);
  await expect(viewer.getByRole("alert")).toBeHidden();
});
