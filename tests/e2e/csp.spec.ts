import type { Locator, Page } from "@playwright/test";
import { encode } from "fast-png";
import { MIN_WORKER_PRIMITIVES } from "../../src/bvh/buildInWorker";
import type { RtViewerElement } from "../../src/element";
import { triangleFile } from "../support/gltf";
import { ktx2Picture } from "../support/ktx2Pictures";
import { bumpyScene } from "./support/bumpyScene";
import { contrast, pictureOf } from "./support/picture";
import { expect, test } from "./support/test";
import { FIXTURE_URL } from "./support/urls";
import { addViewer, waitForSamples } from "./support/viewer";

// The least that a page can allow: its own scripts, scenes and images. No eval, nothing inline, no style sheet.
const POLICY = "default-src 'none'; script-src 'self'; connect-src 'self'; img-src 'self' data:";
const TRUSTED_TYPES = "require-trusted-types-for 'script'";

async function openStrictFixture(page: Page, policy = `${POLICY}; ${TRUSTED_TYPES}`): Promise<void> {
  await page.route(FIXTURE_URL, async (route) => {
    const response = await route.fetch();
    const body = (await response.text()).replace(/<style>.*?<\/style>/s, "");
    await route.fulfill({ response, body, headers: { ...response.headers(), "content-security-policy": policy } });
  });
  await page.addInitScript(() => {
    const violations: string[] = [];
    Object.assign(globalThis, { violations });
    document.addEventListener("securitypolicyviolation", ({ violatedDirective, sourceFile, sample }) => {
      violations.push(`${violatedDirective} ${sourceFile} ${sample}`);
    });
  });
  await page.goto(FIXTURE_URL);
  await page.evaluate(() => customElements.whenDefined("rt-viewer"));
}

const violationsOf = (page: Page) =>
  page.evaluate(() => (globalThis as unknown as { violations: string[] }).violations);

test("a strict content security policy is in force, and the element works under it", async ({
  page,
  expectedErrors,
}) => {
  // Without a style the element is as wide as the page, which has to take four samples of it in time.
  await page.setViewportSize({ width: 400, height: 300 });
  await openStrictFixture(page);
  const viewer = await addViewer(page, { src: "spheres.json", controls: "", alt: "Three balls" });
  await waitForSamples(viewer, 4);
  expect(contrast(await pictureOf(viewer))).toBeGreaterThan(20);
  await page.keyboard.press("Tab");
  await page.keyboard.press("ArrowRight");
  expect(await violationsOf(page)).toEqual([]);

  expectedErrors.push(/Content Security Policy/);
  const isRefused = await page.evaluate(async () => {
    const style = document.createElement("style");
    style.textContent = "body { color: red }";
    document.head.append(style);
    return style.sheet === null;
  });
  expect(isRefused).toBe(true);
});

test("the panel keeps to a strict content security policy too, and is styled", async ({ page }) => {
  await openStrictFixture(page, POLICY); // Tweakpane makes its icons by innerHTML, which trusted types would refuse
  const viewer = await addViewer(page, { src: "spheres.json", stats: "" });
  await waitForSamples(viewer, 2);
  const title = viewer.getByRole("button").first();
  await expect(title).toHaveCSS("display", "block");
  await expect(viewer.locator(".tp-rotv")).toHaveCSS("border-radius", "8px");
  expect(await violationsOf(page)).toEqual([]);
});

test("a model with a picture is shown under a strict content security policy", async ({ page }) => {
  const png = encode({ width: 2, height: 1, channels: 3, data: Uint8Array.of(255, 0, 0, 0, 255, 0) });
  const model = triangleFile((json, packer) => {
    json.images = [{ bufferView: packer.addView(png) }, { uri: `data:;base64,${Buffer.from(png).toString("base64")}` }];
    json.textures = [{ source: 0 }, { source: 1 }];
    json.materials = [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } }, normalTexture: { index: 1 } }];
    json.meshes[0].primitives[0].material = 0;
    json.meshes[0].primitives[0].attributes.TEXCOORD_0 = packer.add(Float32Array.of(0, 0, 1, 0, 0, 1), "VEC2");
  });
  await page.route("**/model.glb", (route) => route.fulfill({ body: Buffer.from(model) }));
  const policy = "default-src 'none'; script-src 'self'; connect-src 'self'";
  await openStrictFixture(page, `${policy}; img-src data:; ${TRUSTED_TYPES}`); // the fixture's icon is a data: URL
  const viewer = await addViewer(page, { src: "model.glb" });
  await waitForSamples(viewer, 1);
  expect(contrast(await pictureOf(viewer))).toBeGreaterThan(10);
  expect(await violationsOf(page)).toEqual([]);
});

/** A triangle with a KTX2 picture. */
function ktx2Model(): Uint8Array {
  return triangleFile((json, packer) => {
    json.images = [{ bufferView: packer.addView(ktx2Picture("uastc")) }];
    json.textures = [{ extensions: { KHR_texture_basisu: { source: 0 } } }];
    json.materials = [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }];
    json.meshes[0].primitives[0].material = 0;
    json.meshes[0].primitives[0].attributes.TEXCOORD_0 = packer.add(Float32Array.of(0, 0, 1, 0, 0, 1), "VEC2");
  });
}

const texturesOf = (viewer: Locator) =>
  viewer.evaluate((element: RtViewerElement) => Object.keys(element.tracer!.scene.textures));

test("a KTX2 picture is shown where a content security policy allows WebAssembly, in a worker or without", async ({
  page,
  expectedErrors,
}) => {
  await page.route("**/model.glb", (route) => route.fulfill({ body: Buffer.from(ktx2Model()) }));
  const workers: string[] = [];
  page.on("worker", (worker) => workers.push(worker.url()));
  const policy = POLICY.replace("'self'", "'self' 'wasm-unsafe-eval'");
  await openStrictFixture(page, policy);
  const viewer = await addViewer(page, { src: "model.glb" });
  await waitForSamples(viewer, 1);
  expect(await texturesOf(viewer)).toEqual(["image 0"]);
  expect(await violationsOf(page)).toEqual([]);
  expect(workers).toHaveLength(1);

  expectedErrors.push(/requires 'TrustedScriptURL'/);
  await page.unroute(FIXTURE_URL);
  await openStrictFixture(page, `${policy}; ${TRUSTED_TYPES}`);
  const another = await addViewer(page, { src: "model.glb" });
  await waitForSamples(another, 1);
  expect(await texturesOf(another)).toEqual(["image 0"]);
  expect(workers).toHaveLength(1);
});

test("a KTX2 picture is left out where WebAssembly is forbidden, and the model shown", async ({
  page,
  expectedErrors,
}) => {
  expectedErrors.push(/WebAssembly/);
  await page.route("**/model.glb", (route) => route.fulfill({ body: Buffer.from(ktx2Model()) }));
  await openStrictFixture(page, POLICY);
  const viewer = await addViewer(page, {});
  const warnings = viewer.evaluate(
    (element: RtViewerElement) =>
      new Promise<readonly string[]>((resolve) => {
        element.addEventListener("loadwarnings", ({ detail }) => resolve(detail.warnings));
        element.src = "model.glb";
      }),
  );
  expect(await warnings).toContainEqual(expect.stringContaining("needs the Basis Universal transcoder"));
  await waitForSamples(viewer, 1);
  expect(await texturesOf(viewer)).toEqual([]);
});

for (const [what, policy, refusal] of [
  ["forbids workers", `${POLICY}; worker-src 'none'`, /worker-src 'none'/],
  ["wants trusted types", `${POLICY}; ${TRUSTED_TYPES}`, /requires 'TrustedScriptURL'/],
] as const) {
  test(`under a policy that ${what} the tree of a big mesh is built in the page`, async ({ page, expectedErrors }) => {
    expectedErrors.push(refusal);
    const workers: string[] = [];
    page.on("worker", (worker) => workers.push(worker.url()));
    await page.setViewportSize({ width: 320, height: 240 }); // there is no style sheet to make the viewer small
    await page.route("**/bumpy.json", (route) => route.fulfill({ json: bumpyScene(2 * MIN_WORKER_PRIMITIVES) }));
    await openStrictFixture(page, policy);
    const viewer = await addViewer(page, { src: "bumpy.json" });
    await waitForSamples(viewer, 1);
    expect(contrast(await pictureOf(viewer))).toBeGreaterThan(20);
    expect(workers).toEqual([]);
    expect(await violationsOf(page)).toHaveLength(1); // there would have been a worker
  });
}
