import { createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { deflateSync } from "node:zlib";
import type { Page } from "@playwright/test";
import { encode } from "fast-png";
import { encode as encodeJpeg } from "jpeg-js";
import { decodeImage } from "../../src/cli/decodeImage";
import type { RtViewerElement } from "../../src/element";
import { transcodeByScript } from "../support/basisScript";
import { turnedJpeg, turnedPng, turnedWebp } from "../support/exif";
import { triangleFile } from "../support/gltf";
import { ktx2File, ktx2Picture, tiledUastc } from "../support/ktx2Pictures";
import { chunk, pngFile } from "../support/png";
import { pngCases } from "../support/pngKinds";
import { createRandom } from "../support/random";
import { smallPicture } from "../support/smallPictures";
import { contrast, pictureOf } from "./support/picture";
import { report } from "./support/report";
import { tasksDuring } from "./support/tasks";
import { expect, test } from "./support/test";
import { addViewer, openFixture, waitForSamples } from "./support/viewer";

const RED_GREEN = encode({ width: 2, height: 1, channels: 3, data: Uint8Array.of(255, 0, 0, 0, 255, 0) });

/** A triangle for each of these pictures, which lie beside the file unless it has other addresses. */
async function serveTextured(page: Page, pictures: readonly Uint8Array[], uris?: readonly string[]): Promise<void> {
  const file = triangleFile((json, packer) => {
    json.images = pictures.map((_, i) => ({ uri: uris?.[i] ?? `picture-${i}` }));
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

test("a picture that claims to have 30000 × 30000 texels is left out, and the model shown", async ({ page }) => {
  await serveTextured(page, [pngFile([30_000, 30_000], [8, 2, 0, 0, 0], [])]);
  await openFixture(page);
  const warnings = await warningsOf(page);
  expect(warnings).toEqual([expect.stringContaining("it is 30000 × 30000, which is more than 268435456 texels")]);
  await expect(page.getByRole("alert")).toBeHidden();
});

test("pictures that are not there, not pictures or blocked are named, and the model is shown", async ({
  page,
  expectedErrors,
}) => {
  expectedErrors.push(/404/, /CORS/, /ERR_FAILED/);
  const pictures = [0, 1, 2, 3].map(() => new Uint8Array());
  // Of another origin, without a header that allows it; Playwright's own answers have one.
  const server = createServer((_, response) => response.end(RED_GREEN)).listen(0);
  const { port } = server.address() as AddressInfo;
  await serveTextured(page, pictures, ["not-there.png", "page.png", `http://localhost:${port}/far.png`, "good.png"]);
  await page.route("**/not-there.png", (route) => route.fulfill({ status: 404 }));
  await page.route("**/page.png", (route) => route.fulfill({ body: "<!doctype html>", contentType: "text/html" }));
  await page.route("**/good.png", (route) => route.fulfill({ body: Buffer.from(RED_GREEN) }));
  await openFixture(page);
  const warnings = await warningsOf(page);
  server.close();
  expect(warnings).toHaveLength(3);
  for (const pattern of [
    /not-there\.png could not be fetched: 404 .*\(images\[0\] "not-there\.png"\)$/,
    /it is a web page \(HTML\), not a picture \(images\[1\] "page\.png"\)$/,
    /far\.png could not be fetched: .*\(images\[2\] "http:\/\/localhost:\d+\/far\.png"\)$/,
  ]) {
    expect(warnings).toContainEqual(expect.stringMatching(pattern));
  }
  const textures = await page
    .locator("rt-viewer")
    .evaluate((element: RtViewerElement) => Object.keys(element.tracer!.scene.textures));
  expect(textures).toEqual(["image 3"]);
});

/** Adds a viewer of the file, waits for its first sample, and says what it was warned of. */
async function warningsOf(page: Page): Promise<readonly string[]> {
  const viewer = await addViewer(page, {});
  await viewer.evaluate((element: RtViewerElement) => {
    element.addEventListener("loadwarnings", ({ detail }) => Object.assign(globalThis, { warnings: detail.warnings }));
    element.setAttribute("src", "textured.glb");
  });
  await waitForSamples(viewer, 1);
  return page.evaluate(() => (globalThis as unknown as { warnings?: readonly string[] }).warnings ?? []);
}

/** The texels of these pictures, as a page decodes them. */
async function decodedInPage(page: Page, pictures: readonly Uint8Array[]) {
  await serveTextured(page, pictures);
  await openFixture(page);
  const decoded = await page.evaluate(async () => {
    const { loadGltf } = await globalThis.importGltf();
    const file = new Uint8Array(await (await fetch("textured.glb")).arrayBuffer());
    const { scene, warnings } = await loadGltf(file, { baseUrl: location.href });
    return {
      warnings,
      textures: Object.values(scene.textures!).map((texture) => ({ ...texture, texels: Array.from(texture.texels) })),
    };
  });
  expect(decoded.warnings).toEqual([]);
  return decoded.textures;
}

/** Texels of any colour, opaque. */
function noise(count: number): Uint8Array {
  const random = createRandom(7);
  return Uint8Array.from({ length: 4 * count }, (_, i) => (i % 4 === 3 ? 255 : Math.floor(256 * random())));
}

function largestDifference(a: ArrayLike<number>, b: ArrayLike<number>): number {
  return Math.max(...Array.from(a, (value, i) => Math.abs(value - b[i]!)));
}

test("PNGs of every kind, JPEG, WebP and AVIF have the same texels in a page and on the command line, seed 3", async ({
  page,
}) => {
  const files = [
    ...pngCases(3).map(({ name, file }) => [name, "image/png", file] as const),
    ["lossless WebP", "image/webp", smallPicture("losslessWebp")] as const,
    ["lossy WebP", "image/webp", smallPicture("lossyWebp")] as const,
    ["AVIF", "image/avif", smallPicture("avif")] as const,
    ["JPEG", "image/jpeg", encodeJpeg({ width: 33, height: 17, data: noise(33 * 17) }, 70).data as Uint8Array] as const,
  ];
  const textures = await decodedInPage(
    page,
    files.map(([, , file]) => file),
  );
  for (const [i, [name, type, file]] of files.entries()) {
    const { texels, ...size } = await decodeImage(file, type);
    expect.soft(textures[i], name).toMatchObject(size);
    // libavif and Chromium turn AV1's colours to RGB with different roundings.
    expect.soft(largestDifference(texels, textures[i]!.texels), name).toBeLessThanOrEqual(name === "AVIF" ? 2 : 0);
  }
});

test("KTX2 pictures have the texels that Binomial's script gives", async ({ page }) => {
  const names = ["etc1s", "etc1sAlpha", "uastc", "uastcZstandard", "mixedEtc1s", "mixedUastc"] as const;
  const plain = ktx2File(
    { vkFormat: 43, width: 3, height: 2 },
    Uint8Array.from({ length: 24 }, (_, i) => 10 * i),
  );
  const textures = await decodedInPage(page, [...names.map(ktx2Picture), plain]);
  for (const [i, name] of names.entries()) {
    expect.soft(textures[i]!.texels, name).toEqual([...(await transcodeByScript(ktx2Picture(name)))]);
  }
  expect(textures.at(-1)).toMatchObject({ width: 3, height: 2, texels: Array.from({ length: 24 }, (_, i) => 10 * i) });
});

test("while five KTX2 pictures of 2048² load no task of the page takes long, and workers end with it", async ({
  page,
}) => {
  const workers: string[] = [];
  page.on("worker", (worker) => {
    if (!worker.url().includes("transcodeWorker")) return;
    workers.push("start");
    worker.on("close", () => workers.push("close"));
  });
  await serveTextured(page, Array(5).fill(tiledUastc(2048)));
  await openFixture(page);
  const tasks = await tasksDuring(page, async () => {
    const viewer = await addViewer(page, { src: "textured.glb" });
    await waitForSamples(viewer, 1);
  });
  report("pictures-ktx2", { pictures: "5 × 2048² in UASTC", longest: tasks.slice(0, 3) });
  await expect(page.getByRole("alert")).toBeHidden();
  expect(tasks[0]!.processorMs).toBeLessThan(100); // as above
  expect(contrast(await pictureOf(page.locator("rt-viewer")))).toBeGreaterThan(10);
  expect(workers.filter((event) => event === "start").length).toBeLessThanOrEqual(2);
  await expect.poll(() => workers.filter((event) => event === "close").length).toBe(workers.length / 2);
});

test("a picture is not turned, whatever it says of its orientation", async ({ page }) => {
  const [width, height] = [32, 16];
  const halves = Uint8Array.from(
    { length: 4 * width * height },
    (_, i) => [Math.floor(i / 4) % width < 16 ? 200 : 30, 30, 30, 255][i % 4]!,
  );
  const webp = smallPicture("losslessWebp");
  const files = [
    ["image/jpeg", turnedJpeg(encodeJpeg({ width, height, data: halves }, 95).data, 6)],
    ["image/jpeg", turnedJpeg(encodeJpeg({ width, height, data: halves }, 95).data, 3)],
    ["image/png", turnedPng(encode({ width, height, data: halves, channels: 4 }), 6)],
    ["image/webp", turnedWebp(webp, [12, 10], 8)],
  ] as const;
  const textures = await decodedInPage(
    page,
    files.map(([, file]) => file),
  );
  for (const [i, [type, file]] of files.entries()) {
    const image = await decodeImage(file, type);
    const { texels, ...size } = textures[i]!;
    expect(size).toMatchObject({ width: image.width, height: image.height });
    expect(largestDifference(texels, image.texels), type).toBe(0);
    if (i < 3) expect([texels[0], texels[4 * (width - 1)]].map((red) => Math.round(red! / 50))).toEqual([4, 1]);
  }
});

test("a picture that is decoded in strips has every row in its place, seed 6", async ({ page }) => {
  const [width, height] = [2048, 5000]; // 4096 rows at a time
  const random = createRandom(6);
  const data = new Uint8Array(width * height);
  for (let row = 0; row < height; row++) data.fill(256 * random(), row * width, (row + 1) * width);
  await serveTextured(page, [encode({ width, height, channels: 1, data })]);
  await openFixture(page);
  const rows = await page.evaluate(async () => {
    const { loadGltf } = await globalThis.importGltf();
    const file = new Uint8Array(await (await fetch("textured.glb")).arrayBuffer());
    const { scene } = await loadGltf(file, { baseUrl: location.href });
    const { width, height, texels } = scene.textures!["image 0"]!;
    return Array.from({ length: height }, (_, row) => [texels[4 * row * width], texels[4 * (row + 1) * width - 2]]);
  });
  expect(rows).toEqual(Array.from({ length: height }, (_, row) => [data[row * width], data[row * width]]));
});

test("a picture that is wider than a texture of WebGL is read whole, seed 4", async ({ page }) => {
  const [width, height] = [10_000, 3]; // the software adapter's are 8192
  const random = createRandom(4);
  const data = new Uint8Array(4 * width * height).map(() => 256 * random());
  const [texture] = await decodedInPage(page, [encode({ width, height, channels: 4, data })]);
  expect(Buffer.compare(Buffer.from(texture!.texels), Buffer.from(data))).toBe(0);
});

test("five pictures of 4096² are shown, halved where the adapter can't hold them, and no task of the page takes long", async ({
  page,
}) => {
  test.slow();
  const side = 4096;
  const rows = Buffer.alloc(side * (side + 1)); // each after the byte of its filter
  for (let row = 0; row < side; row++)
    rows.fill((row >> 6) % 2 ? 255 : 0, row * (side + 1) + 1, (row + 1) * (side + 1));
  const file = pngFile([side, side], [8, 0, 0, 0, 0], [chunk("IDAT", deflateSync(rows))]);
  await serveTextured(page, Array(5).fill(file));
  await openFixture(page);
  let warnings: readonly string[] = [];
  const tasks = await tasksDuring(page, async () => {
    warnings = await warningsOf(page);
  });
  const { sizes, most } = await page.locator("rt-viewer").evaluate(async (element: RtViewerElement) => {
    const adapter = await navigator.gpu.requestAdapter();
    const { maxStorageBufferBindingSize, maxBufferSize } = adapter!.limits;
    const textures = Object.values(element.tracer!.scene.textures);
    return {
      sizes: textures.map(({ width }) => width),
      most: Math.min(maxStorageBufferBindingSize, maxBufferSize, 2 ** 29),
    };
  });
  report("pictures-4096", { sizes, most, warnings, longest: tasks.slice(0, 3) });
  const bytes = sizes.reduce((sum, width) => sum + 4 * width * width, 0);
  expect(sizes).toHaveLength(5);
  expect(bytes).toBeLessThanOrEqual(most);
  const isHalved = 5 * 4 * side * side > most;
  expect(sizes.includes(2048)).toBe(isHalved);
  expect(warnings).toEqual(isHalved ? [expect.stringContaining("2048 × 2048 instead of 4096 × 4096")] : []);
  expect(tasks[0]!.processorMs).toBeLessThan(100); // as above
});

test("while pictures of 4096² are made smaller no task of the page takes long", async ({ page }) => {
  const side = 4096;
  const rows = Buffer.alloc(side * (side + 1));
  for (let row = 0; row < side; row += 2) rows.fill(255, row * (side + 1) + 1, (row + 1) * (side + 1));
  const file = pngFile([side, side], [8, 0, 0, 0, 0], [chunk("IDAT", deflateSync(rows))]);
  await serveTextured(page, [file, file]);
  await openFixture(page);
  await page.evaluate(() => globalThis.importGltf());
  let made: unknown;
  const tasks = await tasksDuring(page, async () => {
    made = await page.evaluate(async () => {
      const { loadGltf } = await globalThis.importGltf();
      const glb = new Uint8Array(await (await fetch("textured.glb")).arrayBuffer());
      const { scene } = await loadGltf(glb, { baseUrl: location.href, maxTexelBytes: 2 ** 25 });
      return Object.values(scene.textures!).map(({ width, texels }) => [width, texels[0], texels[3], texels.at(-2)]);
    });
  });
  report("pictures-halved", { pictures: "2 × 4096² to 2048²", longest: tasks.slice(0, 3) });
  // Half the light of white, opaque.
  expect(made).toEqual([0, 1].map(() => [2048, 188, 255, 188]));
  expect(tasks[0]!.processorMs).toBeLessThan(100); // as above
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
