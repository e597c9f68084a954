import type { RtViewerElement } from "../../src/element";
import { difference, meanColor, pictureOf } from "./support/picture";
import { expect, test } from "./support/test";
import { addViewer, openFixture, openViewer, pause, waitForSamples } from "./support/viewer";

test("every attribute is a property and every property an attribute", async ({ page }) => {
  await openFixture(page);
  const viewer = await addViewer(page, {});
  // Attribute, property, what the attribute is set to and the property then, what the property is set to and the attribute then.
  const table = [
    ["alt", "alt", "Balls", "Balls", "Boxes", "Boxes"],
    ["poster", "poster", "data:,a", "data:,a", "data:,b", "data:,b"],
    ["controls", "controls", "", true, false, null],
    ["stats", "showStats", "folded", true, false, null],
    ["paused", "paused", "", true, false, null],
    ["loading", "loading", "LAZY", "lazy", "eager", "eager"],
    ["tone-map", "toneMap", "agx", "agx", "none", "none"],
    ["tone-map", "toneMap", "filmic", "aces", "aces", "aces"],
    ["camera-orbit", "cameraOrbit", "1deg 2deg 3m", "1deg 2deg 3m", "auto auto 4m", "auto auto 4m"],
    ["exposure", "exposure", "1.5", 1.5, -2, "-2"],
    ["max-bounces", "maxBounces", "3", 3, 4, "4"],
    ["samples-per-frame", "samplesPerFrame", "2", 2, 8, "8"],
    ["samples-per-frame", "samplesPerFrame", "many", "auto", "auto", "auto"],
    ["light-samples", "lightSamples", "2", 2, 3, "3"],
    ["target-error", "targetError", "0.01", 0.01, 0.5, "0.5"],
    ["max-samples", "maxSamples", "64", 64, 128, "128"],
    ["variant-name", "variantName", "Night", "Night", null, null],
    ["variant-name", "variantName", "", "", "Day", "Day"],
    ["src", "src", "furnace.json", "furnace.json", "spheres.json", "spheres.json"],
  ] as const;
  const seen = await viewer.evaluate((element: RtViewerElement, rows) => {
    return rows.map(([attribute, property, text, , value]) => {
      element.setAttribute(attribute, text);
      const read: unknown = Reflect.get(element, property);
      Reflect.set(element, property, value);
      return [read, element.getAttribute(attribute)];
    });
  }, table);
  expect(seen).toEqual(table.map(([, , , read, , written]) => [read, written]));
});

test("camera-orbit moves the camera around the scene's target, and its removal back", async ({ page }) => {
  const viewer = await openViewer(page, { src: "spheres.json", "camera-orbit": "90deg 0deg 4m" }, 2);
  const cameraOf = () => viewer.evaluate((element: RtViewerElement) => element.camera!);
  const { position, target } = await cameraOf();
  expect(position[0] - target[0]).toBeCloseTo(4);
  expect(position[1]).toBeCloseTo(target[1]);
  expect(position[2]).toBeCloseTo(target[2]);
  await viewer.evaluate((element: RtViewerElement) => {
    element.cameraOrbit = "auto 30deg auto";
  });
  const raised = await cameraOf();
  const home = await viewer.evaluate((element: RtViewerElement) => element.tracer!.scene.camera);
  const distance = Math.hypot(...home.position.map((value, axis) => value - home.target[axis]!));
  expect(raised.position[1] - raised.target[1]).toBeCloseTo(distance / 2);
  await viewer.evaluate((element: RtViewerElement) => element.removeAttribute("camera-orbit"));
  expect(await cameraOf()).toEqual(home);
});

test("a camera that is set before there is a scene is that scene's", async ({ page }) => {
  await openFixture(page);
  const viewer = await addViewer(page, {});
  await viewer.evaluate((element: RtViewerElement) => {
    element.camera = { position: [0, 9, 1] };
    element.src = "spheres.json";
  });
  await waitForSamples(viewer, 1);
  const camera = await viewer.evaluate((element: RtViewerElement) => element.camera);
  expect(camera?.position).toEqual([0, 9, 1]);
});

test("another tone map is another picture of the same samples", async ({ page }) => {
  const viewer = await openViewer(page, { src: "spheres.json" }, 8);
  await pause(viewer);
  const aces = await pictureOf(viewer);
  const samples = await viewer.evaluate((element: RtViewerElement) => element.stats!.samples);
  for (const toneMap of ["agx", "none"] as const) {
    await viewer.evaluate((element: RtViewerElement, value) => {
      element.toneMap = value;
    }, toneMap);
    await expect.poll(async () => difference(aces, await pictureOf(viewer))).toBeGreaterThan(5);
  }
  expect(await viewer.evaluate((element: RtViewerElement) => element.stats!.samples)).toBeGreaterThanOrEqual(samples);
});

test("toBlob is what the page shows, screenshot can be linear float, readRadiance is what was sampled", async ({
  page,
}) => {
  const viewer = await openViewer(
    page,
    { src: "spheres.json", exposure: "0.5", "tone-map": "agx", "max-samples": "8" },
    8,
  );
  await expect.poll(() => viewer.evaluate((element: RtViewerElement) => element.stats!.converged)).toBe(true);
  const shown = await pictureOf(viewer);
  const files = await viewer.evaluate(async (element: RtViewerElement) => {
    const png = await element.toBlob();
    const jpeg = await element.toBlob("image/jpeg", 0.9);
    const pfm = await element.screenshot("pfm");
    const radiance = await element.readRadiance();
    const header = await pfm.slice(0, 16).text();
    const floats = new DataView(await pfm.slice(16).arrayBuffer());
    return {
      types: [png.type, jpeg.type, pfm.type, (await element.screenshot()).type],
      png: [...new Uint8Array(await png.arrayBuffer())],
      header,
      pfmBytes: pfm.size,
      // The first pixel of the last row comes first in a PFM.
      bottomLeft: [floats.getFloat32(0, true), floats.getFloat32(4, true), floats.getFloat32(8, true)],
      radianceBottomLeft: [...radiance.slice(320 * 239 * 4, 320 * 239 * 4 + 3)],
      radianceLength: radiance.length,
    };
  });
  expect(files.types).toEqual(["image/png", "image/jpeg", "image/x-portable-floatmap", "image/png"]);
  expect(files.header).toBe("PF\n320 240\n-1.0\n");
  expect(files.pfmBytes).toBe(16 + 320 * 240 * 12);
  expect(files.bottomLeft).toEqual(files.radianceBottomLeft);
  expect(files.radianceLength).toBe(320 * 240 * 4);
  const { decode } = await import("fast-png");
  const { width, height, channels, data } = decode(Uint8Array.from(files.png));
  const saved = { width, height, channels, data: new Uint8Array(data) };
  expect([width, height]).toEqual([320, 240]);
  // The screenshot has three channels, and passes through the compositor.
  for (const [channel, value] of meanColor(saved).entries()) expect(value).toBeCloseTo(meanColor(shown)[channel]!, 0);
});

test("before there is a picture, there is none to save", async ({ page }) => {
  await openFixture(page);
  const viewer = await addViewer(page, {});
  const reason = await viewer.evaluate((element: RtViewerElement) =>
    element.toBlob().catch(({ message }: Error) => message),
  );
  expect(reason).toMatch(/ready/);
});
