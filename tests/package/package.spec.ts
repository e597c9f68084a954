import { readdir, readFile } from "node:fs/promises";
import { join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import type { CustomElementDeclaration, Package } from "custom-elements-manifest";
import type { RtViewerElement } from "../../src/element";
import { readExports } from "../../tools/apiDocs";
import { createDocs } from "../../tools/docs";
import { contrast, pictureOf } from "../e2e/support/picture";
import { waitForSamples } from "../e2e/support/viewer";
import { triangleFile } from "../support/gltf";
import { ktx2Picture } from "../support/ktx2Pictures";
import { expect, serve, test } from "./support/test";

const SITE = "https://stranger.example";
const CDN = "https://cdn.example/rt-viewer";
const DOCS = fileURLToPath(new URL("../../docs/api/", import.meta.url));
const SCENES = fileURLToPath(new URL("../reference/scenes/", import.meta.url));

test("a strict TypeScript project type-checks against the package, and mistakes in templates are errors", async ({
  project,
}) => {
  await project.tsc();
});

test("types resolve as Node resolves them", async ({ project }) => {
  await project.tsc("--module", "nodenext", "--moduleResolution", "nodenext", "--types", "", "--noEmit");
});

test("every entry imports in bare Node", async ({ project }) => {
  const { exports } = JSON.parse(await readFile(join(project.package, "package.json"), "utf8"));
  const entries = Object.keys(exports).map((entry) => entry.replace(/^\./, "rt-viewer"));
  expect(entries).toContain("rt-viewer/element");
  const load = (entry: string) =>
    entry.endsWith(".json")
      ? `import("${entry}", { with: { type: "json" } })`
      : `import("${entry}").then((module) => { if (Object.keys(module).length === 0) throw "${entry} is empty"; })`;
  await project.node("--input-type=module", "--eval", `await Promise.all([${entries.map(load)}]);`);
});

test("without a page the package checks scenes", async ({ project }) => {
  const code = `import { parseScene, sphere } from "rt-viewer";
    const objects = [sphere({ center: [0, 0, 0], radius: 1, material: "m" })];
    const { maxBounces } = parseScene({ camera: { position: [0, 0, 5] }, materials: { m: {} }, objects });
    process.stdout.write(String(maxBounces));`;
  expect(await project.node("--input-type=module", "--eval", code)).toBe("8");
});

test("a blank Vite project shows its scene", async ({ page, project }) => {
  await serve(page, SITE, join(project.folder, "dist"));
  await page.goto(`${SITE}/index.html`);

  const viewer = page.locator("rt-viewer");
  await waitForSamples(viewer, 4);
  expect(contrast(await pictureOf(viewer))).toBeGreaterThan(20);
  await expect(page).toHaveTitle(/^ready after \d+ ms$/);
  await expect(viewer.getByText(/% error/).first()).toBeVisible();
});

test("React sets attributes and properties and listens to events", async ({ page, project }) => {
  await serve(page, SITE, join(project.folder, "dist"), SCENES);
  await page.goto(`${SITE}/react.html`);

  const viewer = page.locator("rt-viewer");
  await expect(page.locator("output")).toHaveText(/^[1-9]\d* samples$/);
  const state = await viewer.evaluate(({ settings: { seed, maxSamples, maxBounces } }: RtViewerElement) => ({
    seed,
    maxSamples,
    maxBounces,
  }));
  expect(state).toEqual({ seed: 2, maxSamples: 64, maxBounces: 4 });
  await expect(viewer).toHaveAttribute("controls");
  await expect(viewer).toHaveAttribute("stats", "folded");
});

test("a page that React rendered on a server shows the scene, whatever is hydrated", async ({ page, project }) => {
  await project.vite("build", "--ssr", "src/server.tsx", "--outDir", "server");
  const code = 'process.stdout.write((await import("./server/server.js")).html);';
  const html = await project.node("--input-type=module", "--eval", code);
  expect(html).toMatch(/<rt-viewer [^>]*src="spheres.json"/);

  const template = await readFile(join(project.folder, "dist/react.html"), "utf8");
  await serve(page, SITE, join(project.folder, "dist"), SCENES);
  await page.route(`${SITE}/`, (route) =>
    route.fulfill({ body: template.replace("<!--app-->", html), contentType: "text/html" }),
  );
  await page.goto(`${SITE}/`);

  const viewer = page.locator("rt-viewer");
  await waitForSamples(viewer, 2);
  expect(contrast(await pictureOf(viewer))).toBeGreaterThan(20);
  expect(await viewer.evaluate((element: RtViewerElement) => element.maxBounces)).toBe(4);
});

test("Vue's attributes without a value switch the element's features on", async ({ page, project }) => {
  await serve(page, SITE, join(project.folder, "dist"), SCENES);
  await page.goto(`${SITE}/vue.html`);

  const viewer = page.locator("rt-viewer");
  await expect(page.locator("output")).toHaveText(/^[1-9]\d* samples$/);
  await expect(viewer.getByText(/% error/).first()).toBeVisible();
  const state = await viewer.evaluate(({ controls, targetError }: RtViewerElement) => ({ controls, targetError }));
  expect(state).toEqual({ controls: true, targetError: 0.05 });
});

test("one file from a CDN is all that a page needs", async ({ page, project }) => {
  const requests: string[] = [];
  page.on("request", (request) => requests.push(request.url()));
  const { unpkg, jsdelivr } = JSON.parse(await readFile(join(project.package, "package.json"), "utf8"));
  expect(jsdelivr).toBe(unpkg);
  await serve(page, CDN, SCENES);
  await page.route(CDN, async (route) => {
    const body = await readFile(join(project.package, unpkg));
    await route.fulfill({ body, contentType: "text/javascript", headers: { "Access-Control-Allow-Origin": "*" } });
  });
  await serve(page, SITE, SCENES);
  await page.route(`${SITE}/`, (route) =>
    route.fulfill({
      contentType: "text/html",
      body: `<!doctype html><link rel="icon" href="data:,">
        <script type="module" src="${CDN}"></script>
        <script type="module">
          import { metals } from "${CDN}";
          document.title = "gold is " + metals.gold.map((part) => part.toFixed(2));
        </script>
        <rt-viewer src="spheres.json" controls stats style="width: 480px; height: 320px"></rt-viewer>`,
    }),
  );
  await page.goto(`${SITE}/`);

  const viewer = page.locator("rt-viewer");
  await waitForSamples(viewer, 4);
  expect(contrast(await pictureOf(viewer))).toBeGreaterThan(20);
  await expect(viewer.getByText(/% error/).first()).toBeVisible();
  await expect(page).toHaveTitle(/^gold is [\d.]+,[\d.]+,[\d.]+$/);
  expect(requests.filter((url) => url.startsWith("http")).sort()).toEqual([CDN, `${SITE}/`, `${SITE}/spheres.json`]);

  // What is in the element's shadow is what the manifest says.
  const manifest: Package = JSON.parse(await readFile(join(project.package, "dist/custom-elements.json"), "utf8"));
  const { cssParts, slots } = manifest.modules[0]!.declarations![0] as CustomElementDeclaration;
  const found = await viewer.evaluate(({ shadowRoot }) => ({
    parts: [...shadowRoot!.querySelectorAll("[part]")].flatMap((element) => [...element.part]),
    slots: [...shadowRoot!.querySelectorAll("slot")].map(({ name }) => name),
  }));
  const whileDragging = "drop"; // there while files are dragged over the element
  expect(new Set(cssParts?.map(({ name }) => name))).toEqual(new Set([...found.parts, whileDragging]));
  const onFailure = "fallback"; // there in place of a picture
  expect(new Set(slots?.map(({ name }) => name))).toEqual(new Set([...found.slots, onFailure]));
});

test("from a CDN a glTF file with a KTX2 picture is shown, by two more files", async ({ page, project }) => {
  const names: string[] = [];
  await page.route("https://cdn.example/**", async (route) => {
    const name = new URL(route.request().url()).pathname.slice(1);
    names.push(name);
    const body = await readFile(join(project.package, "dist", name));
    await route.fulfill({ body, contentType: "text/javascript", headers: { "Access-Control-Allow-Origin": "*" } });
  });
  const model = triangleFile((json, packer) => {
    json.images = [{ bufferView: packer.addView(ktx2Picture("uastcZstandard")) }];
    json.textures = [{ extensions: { KHR_texture_basisu: { source: 0 } } }];
    json.materials = [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }];
    json.meshes[0].primitives[0].material = 0;
    json.meshes[0].primitives[0].attributes.TEXCOORD_0 = packer.add(Float32Array.of(0, 0, 1, 0, 0, 1), "VEC2");
  });
  await page.route(`${SITE}/model.glb`, (route) => route.fulfill({ body: Buffer.from(model) }));
  await page.route(`${SITE}/`, (route) =>
    route.fulfill({
      contentType: "text/html",
      body: `<!doctype html><link rel="icon" href="data:,">
        <script type="module" src="https://cdn.example/rt-viewer.min.js"></script>
        <rt-viewer src="model.glb" style="width: 320px; height: 240px"></rt-viewer>`,
    }),
  );
  await page.goto(`${SITE}/`);

  const viewer = page.locator("rt-viewer");
  await waitForSamples(viewer, 1);
  const sizes = await viewer.evaluate((element: RtViewerElement) =>
    Object.values(element.tracer!.scene.textures).map(({ width, height }) => [width, height]),
  );
  expect(sizes).toEqual([[12, 10]]);
  // Of another origin there are no workers, so that it is decoded in the page.
  expect(names).toEqual(["rt-viewer.min.js", "rt-viewer.gltf.min.js", "rt-viewer.ktx2.min.js"]);
});

test("everything that is exported has a docstring", async ({ project }) => {
  const { exports } = JSON.parse(await readFile(join(project.package, "package.json"), "utf8"));
  const undocumented: string[] = [];
  for (const [entry, { types }] of Object.entries<{ types?: string }>(exports)) {
    if (types === undefined) continue;
    for (const { name, docs } of await readExports(pathToFileURL(join(project.package, types)))) {
      if (!docs?.text) undocumented.push(`${entry} ${name}`);
    }
  }
  expect(undocumented).toEqual([]);
});

test("docs/api is what npm run docs writes", async ({ project }) => {
  const written = await Promise.all(
    (await readdir(DOCS)).map(async (name) => [name, await readFile(join(DOCS, name), "utf8")] as const),
  );
  expect(Object.fromEntries(written)).toEqual(Object.fromEntries(await createDocs(project.package)));
});
