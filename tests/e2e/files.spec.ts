import type { Page } from "@playwright/test";
import { encode } from "fast-png";
import type { RtViewerElement } from "../../src/element";
import { triangleFile } from "../support/gltf";
import { packedFiles } from "../support/packedGltf";
import { contrast, pictureOf } from "./support/picture";
import { expect, test } from "./support/test";
import { addViewer, openFixture, openViewer, waitForSamples } from "./support/viewer";

const SPHERE = {
  camera: { position: [0, 0, 4] },
  materials: { red: { baseColor: [0.8, 0.1, 0.1] } },
  objects: [{ type: "sphere", center: [0, 0, 0], radius: 1, material: "red" }],
  environment: { radiance: [1, 1, 1] },
};

type Dropped = { readonly name: string; readonly base64: string };

const jsonFile = (name: string, json: unknown): Dropped => ({ name, base64: btoa(JSON.stringify(json)) });
const binaryFile = (name: string, bytes: Uint8Array): Dropped => ({
  name,
  base64: Buffer.from(bytes).toString("base64"),
});

/** What a browser does when files are dragged onto a viewer and dropped, or dragged only. */
async function drag(page: Page, files: readonly Dropped[], ...types: readonly ("dragenter" | "dragleave" | "drop")[]) {
  await page.locator("rt-viewer").evaluate(
    (element: RtViewerElement, [given, names]) => {
      const dataTransfer = new DataTransfer();
      for (const { name, base64 } of given) {
        const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
        dataTransfer.items.add(new File([bytes], name));
      }
      for (const name of names) {
        element.dispatchEvent(new DragEvent(name, { dataTransfer, bubbles: true, cancelable: true }));
      }
    },
    [files, types] as const,
  );
}

const objectsOf = (page: Page) =>
  page
    .locator("rt-viewer")
    .evaluate((element: RtViewerElement) => element.tracer?.scene.objects.map(({ type }) => type));

test("a dropped file is shown, and a frame invites to drop it", async ({ page }) => {
  const viewer = await openViewer(page, { src: "spheres.json", drop: "" });
  const frame = viewer.locator("[part=drop]");
  await expect(frame).toBeHidden();
  await drag(page, [jsonFile("sphere.json", SPHERE)], "dragenter");
  await expect(frame).toHaveText("Drop to view");
  await drag(page, [jsonFile("sphere.json", SPHERE)], "dragleave");
  await expect(frame).toBeHidden();
  await drag(page, [jsonFile("sphere.json", SPHERE)], "dragenter", "drop");
  await expect.poll(() => objectsOf(page)).toEqual(["sphere"]);
  await expect(frame).toBeHidden();
});

test("a dropped file that is broken says so, and leaves the picture and its samples", async ({ page }) => {
  const viewer = await openViewer(page, { src: "spheres.json", drop: "", "max-samples": "8" }, 8);
  const before = await viewer.evaluate((element: RtViewerElement) => {
    Object.assign(globalThis, { tracerBefore: element.tracer, sceneBefore: element.tracer!.scene });
    return element.stats!.samples;
  });
  await drag(page, [binaryFile("half.glb", triangleFile().subarray(0, 300))], "drop");
  await expect(viewer.locator("[part=drop]")).toHaveText(
    /^half\.glb is cut off: it should have \d+ bytes and has 300$/,
  );
  await expect(viewer.getByRole("alert")).toBeHidden();
  const isSame = await viewer.evaluate((element: RtViewerElement) => {
    const { tracerBefore, sceneBefore } = globalThis as unknown as Record<string, unknown>;
    return element.tracer === tracerBefore && element.tracer?.scene === sceneBefore;
  });
  expect(isSame).toBe(true);
  expect(await viewer.evaluate((element: RtViewerElement) => element.stats!.samples)).toBe(before);
});

test("progress is told from the moment a file is dropped, and no more once it turns out to be broken", async ({
  page,
}) => {
  const viewer = await openViewer(page, { src: "spheres.json", drop: "" });
  const bar = viewer.getByRole("progressbar");
  await viewer.evaluate((element: RtViewerElement) => {
    const seen: string[] = [];
    element.addEventListener("loadprogress", ({ detail }) => seen.push(detail.phase));
    element.addEventListener("ready", () => seen.push("ready"));
    Object.assign(globalThis, { seen });
  });
  const seen = () => page.evaluate(() => (globalThis as unknown as { seen: string[] }).seen.splice(0));
  await drag(page, [binaryFile("triangle.glb", triangleFile())], "drop");
  await expect.poll(() => objectsOf(page)).toContain("mesh");
  await expect(bar).toBeHidden();
  const phases = await seen();
  expect(phases.filter((phase, index) => phase !== phases[index - 1])).toEqual(["fetching", "compiling", "ready"]);

  await drag(page, [binaryFile("half.glb", triangleFile().subarray(0, 300))], "drop");
  await expect(viewer.locator("[part=drop]")).toContainText("is cut off");
  await expect(bar).toBeHidden();
  expect(await seen()).toEqual(["fetching"]);
});

test("without the attribute a drop is the page's business", async ({ page }) => {
  const viewer = await openViewer(page, { src: "spheres.json" });
  const isTaken = await viewer.evaluate((element: RtViewerElement) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File(["{}"], "a.json"));
    const event = new DragEvent("dragenter", { dataTransfer, cancelable: true });
    element.dispatchEvent(event);
    return event.defaultPrevented;
  });
  expect(isTaken).toBe(false);
});

test("open() shows a file, tells what is left out, and rejects with what is wrong", async ({ page }) => {
  await openFixture(page);
  const viewer = await addViewer(page, {});
  const base64 = binaryFile(
    "",
    triangleFile((json) => {
      json.animations = [{}];
    }),
  ).base64;
  const [warnings, error] = await viewer.evaluate(async (element: RtViewerElement, text) => {
    const told = new Promise<readonly string[]>((resolve) => {
      element.addEventListener("loadwarnings", ({ detail }) => resolve(detail.warnings));
    });
    await element.open(new Blob([Uint8Array.from(atob(text), (character) => character.charCodeAt(0))]));
    const failure = await element.open(new Blob(["?"])).catch(({ name, message }: Error) => `${name}: ${message}`);
    return [await told, failure] as const;
  }, base64);
  expect(warnings).toEqual(["Animations are not supported: the pose at rest is shown"]);
  expect(error).toMatch(/^LoadError: the file is not JSON/);
  await waitForSamples(viewer, 2);
  expect(await objectsOf(page)).toEqual(["mesh", "plane"]);
});

test("src takes a .glb, frames the model and lights it", async ({ page }) => {
  await page.route("**/model.glb", (route) => route.fulfill({ body: Buffer.from(triangleFile()) }));
  const viewer = await openViewer(page, { src: "model.glb" }, 4);
  expect(await objectsOf(page)).toEqual(["mesh", "plane"]);
  expect(contrast(await pictureOf(viewer))).toBeGreaterThan(10);
});

test("src takes a .gltf with its files beside it, and names one that is missing", async ({ page, expectedErrors }) => {
  expectedErrors.push(/404/);
  const gltf = { asset: { version: "2.0" }, buffers: [{ uri: "model.bin", byteLength: 36 }], ...meshOfOneView() };
  await page.route("**/models/model.gltf", (route) => route.fulfill({ json: gltf }));
  await page.route("**/models/model.bin", (route) => route.fulfill({ status: 404 }));
  await openFixture(page);
  const viewer = await addViewer(page, { src: "models/model.gltf" });
  await expect(viewer.getByRole("alert")).toContainText(
    /models\/model\.gltf: buffers\[0\]: .*\/models\/model\.bin could not be fetched: 404/,
  );
});

function meshOfOneView() {
  return {
    bufferViews: [{ buffer: 0, byteLength: 36 }],
    accessors: [{ bufferView: 0, componentType: 5126, type: "VEC3", count: 3 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
  };
}

test("packed vertex data is unpacked, by decoders that are loaded then", async ({ page }) => {
  const { meshopt, draco } = await packedFiles();
  await openFixture(page);
  for (const file of [meshopt, draco]) {
    const counts = await page.evaluate(async (text) => {
      const { loadGltf } = await globalThis.importGltf();
      const { scene } = await loadGltf(Uint8Array.from(atob(text), (character) => character.charCodeAt(0)));
      return scene.objects.map((object) => (object.type === "mesh" ? object.indices.length / 3 : 0));
    }, binaryFile("", file).base64);
    expect(counts).toEqual([200, 0]);
  }
});

test("pictures are decoded to the bytes in the file, where alpha is 0 too", async ({ page }) => {
  const texels = Uint8Array.of(200, 100, 50, 0, 1, 2, 3, 255, 9, 128, 250, 100, 255, 255, 255, 1);
  const png = encode({ width: 2, height: 2, channels: 4, data: texels });
  const file = triangleFile((json, packer) => {
    json.images = [{ bufferView: packer.addView(png), mimeType: "image/png" }];
    json.textures = [{ source: 0 }];
    json.materials = [{ normalTexture: { index: 0 } }];
    json.meshes[0].primitives[0].material = 0;
    json.meshes[0].primitives[0].attributes.TEXCOORD_0 = packer.add(new Float32Array(6), "VEC2");
  });
  await openFixture(page);
  const decoded = await page.evaluate(async (text) => {
    const { loadGltf } = await globalThis.importGltf();
    const { scene } = await loadGltf(Uint8Array.from(atob(text), (character) => character.charCodeAt(0)));
    return Array.from(Object.values(scene.textures ?? {})[0]?.texels ?? []);
  }, binaryFile("", file).base64);
  expect(decoded).toEqual([...texels]);
});
