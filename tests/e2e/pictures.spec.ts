import type { Page } from "@playwright/test";
import { encode } from "fast-png";
import { encode as encodeJpeg } from "jpeg-js";
import { triangleFile } from "../support/gltf";
import { createRandom } from "../support/random";
import { contrast, pictureOf } from "./support/picture";
import { report } from "./support/report";
import { tasksDuring } from "./support/tasks";
import { expect, test } from "./support/test";
import { addViewer, openFixture, waitForSamples } from "./support/viewer";

/** A triangle for each of these pictures, which lie beside the file. */
async function serveTextured(page: Page, pictures: readonly Uint8Array[]): Promise<void> {
  const file = triangleFile((json, packer) => {
    json.images = pictures.map((_, i) => ({ uri: `picture-${i}` }));
    json.textures = pictures.map((_, source) => ({ source }));
    json.materials = pictures.map((_, index) => ({ pbrMetallicRoughness: { baseColorTexture: { index } } }));
    const uvs = Float32Array.of(0, 0, 1, 0, 0, 1);
    const attributes = { ...json.meshes[0].primitives[0].attributes, TEXCOORD_0: packer.add(uvs, "VEC2") };
    json.meshes = pictures.map((_, material) => ({ primitives: [{ attributes, material }] }));
    json.nodes = pictures.map((_, mesh) => ({ mesh, translation: [mesh, 0, 0] }));
    json.scenes = [{ nodes: [...pictures.keys()] }];
  });
  await page.route("**/textured.glb", (route) => route.fulfill({ body: Buffer.from(file) }));
  for (const [i, body] of pictures.entries()) {
    await page.route(`**/picture-${i}`, (route) => route.fulfill({ body: Buffer.from(body) }));
  }
}

/** A picture with some detail: stripes of this many texels. */
function stripes(side: number, width: number): Uint8Array {
  const data = new Uint8Array(4 * side * side);
  for (let i = 0; i < side * side; i++)
    data.set(Math.floor(i / width) % 2 ? [250, 200, 40, 255] : [20, 60, 90, 255], 4 * i);
  return encodeJpeg({ width: side, height: side, data }, 85).data;
}

test("while five pictures of 2048² load no task of the page takes long", async ({ page }) => {
  test.slow(); // to make them
  const pictures = Array.from({ length: 5 }, (_, i) => stripes(2048, 8 + i));
  await serveTextured(page, pictures);
  await openFixture(page);
  const tasks = await tasksDuring(page, async () => {
    const viewer = await addViewer(page, { src: "textured.glb" });
    await waitForSamples(viewer, 1);
  });
  report("pictures", { pictures: "5 × 2048²", longest: tasks.slice(0, 3) });
  await expect(page.getByRole("alert")).toBeHidden();
  // 15 to 45 ms: most of that to link shaders. Texels that were checked and joined in one task took 500.
  expect(tasks[0]!.processorMs).toBeLessThan(100);
  expect(contrast(await pictureOf(page.locator("rt-viewer")))).toBeGreaterThan(10);
});

test("a picture that is read in several slices has every row in its place, seed 2", async ({ page }) => {
  const [width, height] = [1000, 1400]; // 524 rows at a time
  const random = createRandom(2);
  const data = new Uint8Array(4 * width * height).map(() => 256 * random());
  const png = encode({ width, height, channels: 4, data });
  await serveTextured(page, [png]);
  await openFixture(page);
  const texels = await page.evaluate(async () => {
    const { loadGltf } = await globalThis.importGltf();
    const file = new Uint8Array(await (await fetch("textured.glb")).arrayBuffer());
    const { scene } = await loadGltf(file, { baseUrl: location.href });
    const digest = await crypto.subtle.digest("SHA-256", scene.textures!["image 0"]!.texels as Uint8Array<ArrayBuffer>);
    return Array.from(new Uint8Array(digest));
  });
  expect(texels).toEqual(Array.from(new Uint8Array(await crypto.subtle.digest("SHA-256", data))));
});

test("a picture that claims to have 30000 × 30000 texels is refused before it is decoded", async ({ page }) => {
  const png = encode({ width: 1, height: 1, channels: 1, data: new Uint8Array(1) });
  const header = new DataView(png.buffer, png.byteOffset);
  header.setUint32(16, 30_000);
  header.setUint32(20, 30_000);
  await serveTextured(page, [png]);
  await openFixture(page);
  const viewer = await addViewer(page, { src: "textured.glb" });
  await expect(viewer.getByRole("alert")).toContainText("has pictures of more than 67108864 texels");
});

test("a scene with a hundred thousand mistakes shows twenty, and how many more there are", async ({ page }) => {
  const lights = Array.from({ length: 100_000 }, () => 0);
  await page.route("**/bad.json", (route) =>
    route.fulfill({ json: { camera: { position: [0, 0, 5] }, objects: [], lights } }),
  );
  await openFixture(page);
  const viewer = await addViewer(page, { src: "bad.json" });
  const alert = viewer.getByRole("alert");
  await expect(alert).toContainText("The scene has 100,000 mistakes");
  const items = alert.getByRole("listitem");
  await expect(items).toHaveCount(21);
  await expect(items.first()).toHaveText("lights[0]: expected an object, got 0");
  await expect(items.last()).toHaveText("… and 99,980 more");
});
