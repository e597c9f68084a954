import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { build, type InlineConfig, type Rollup } from "vite";
import { beforeAll, expect, test } from "vitest";
import { deflatedWasm, leanShaders } from "../../vite.config";

const LIMIT_KB = 80;
const PANEL_LIMIT_KB = 40;
const SINGLE_FILE_LIMIT_KB = 150; // the panel, the controls and the tree of meshes too

type Chunk = Rollup.OutputChunk;

async function chunksOf(config: InlineConfig): Promise<Chunk[]> {
  const result = await build({ ...config, logLevel: "error", build: { ...config.build, write: false } });
  const outputs = [result].flat() as Rollup.RollupOutput[]; // a list, if it is built as a library
  return outputs.flatMap(({ output }) => output.filter((chunk) => chunk.type === "chunk"));
}

/** What a page that uses the whole package downloads, its dependencies included, minified as a page's bundler would. */
function bundle(): Promise<Chunk[]> {
  const source = (path: string) => fileURLToPath(new URL(`../../src/${path}`, import.meta.url));
  return chunksOf({
    configFile: false,
    plugins: [leanShaders(), deflatedWasm()],
    build: {
      minify: true,
      target: "es2022",
      rollupOptions: {
        input: { index: source("index.ts"), element: source("element.ts") },
        // All exports stay, as if the page used every one of them.
        preserveEntrySignatures: "strict",
      },
    },
  });
}

/** These and everything they import before they run; not what they load on demand. */
function loadedWith(entries: readonly Chunk[], chunks: readonly Chunk[]): Set<Chunk> {
  const byName = new Map(chunks.map((chunk) => [chunk.fileName, chunk]));
  const loaded = new Set(entries);
  for (const chunk of loaded) for (const name of chunk.imports) loaded.add(byName.get(name)!);
  return loaded;
}

const kilobytes = (chunks: Iterable<Chunk>) =>
  [...chunks].reduce((sum, { code }) => sum + gzipSync(code).length / 1000, 0);
const isPanelCode = (id: string) => /tweakpane|src\/panel\//.test(id);
const isGltfCode = (id: string) => /gltf-transform|src\/loaders\/gltf/.test(id);

let chunks: Chunk[];
let atOnce: Set<Chunk>;
beforeAll(async () => {
  chunks = await bundle();
  atOnce = loadedWith(
    chunks.filter(({ isEntry }) => isEntry),
    chunks,
  );
}, 60_000);

test(`the package and its element take at most ${LIMIT_KB} kB, gzipped, without the panel and the loaders`, () => {
  const lines = chunks.map((chunk) => {
    const when = atOnce.has(chunk) ? "" : " (on demand)";
    return `${kilobytes([chunk]).toFixed(1).padStart(6)} kB gzip  ${chunk.name}${when}`;
  });
  const total = kilobytes(atOnce);
  console.log([...lines, `${total.toFixed(1).padStart(6)} kB gzip  index.js + element.js`].join("\n"));

  expect(total).toBeLessThanOrEqual(LIMIT_KB);
  for (const onDemand of [isPanelCode, isGltfCode, (id: string) => /meshoptimizer|draco|loaders\/ktx2/.test(id)]) {
    expect([...atOnce].flatMap(({ moduleIds }) => moduleIds.filter(onDemand))).toEqual([]);
    expect(chunks.flatMap(({ moduleIds }) => moduleIds).some(onDemand)).toBe(true);
  }
});

test(`the panel adds at most ${PANEL_LIMIT_KB} kB`, () => {
  const panel = loadedWith(
    chunks.filter(({ moduleIds }) => moduleIds.some(isPanelCode)),
    chunks,
  );
  const added = [...panel].filter((chunk) => !atOnce.has(chunk));
  expect(added).not.toEqual([]);
  expect(kilobytes(added)).toBeLessThanOrEqual(PANEL_LIMIT_KB);
});

test(`the single file is one file, of at most ${SINGLE_FILE_LIMIT_KB} kB, that imports glTF only, on demand`, {
  timeout: 60_000,
}, async () => {
  const files = await chunksOf({ mode: "single" });
  console.log(`${kilobytes(files).toFixed(1).padStart(6)} kB gzip  rt-viewer.min.js`);
  expect(files.map(({ fileName }) => fileName)).toEqual(["rt-viewer.min.js"]);
  expect(files[0]!.imports).toEqual([]);
  const elsewhere = files[0]!.dynamicImports.filter((name) => name !== files[0]!.fileName);
  expect(elsewhere).toEqual(["./rt-viewer.gltf.min.js"]);
  expect(kilobytes(files)).toBeLessThanOrEqual(SINGLE_FILE_LIMIT_KB);
});

test("what the files beside the single file import, they find", { timeout: 60_000 }, async () => {
  const modes = ["single", "single-gltf", "single-ktx2"];
  const files = (await Promise.all(modes.map((mode) => chunksOf({ mode })))).flat();
  const exported = new Map(files.map((chunk) => [chunk.fileName, chunk.exports]));
  const found: string[] = [];
  for (const { code } of files) {
    for (const [, names, file] of code.matchAll(/import\{([^}]*)\}from"\.\/([^"]+)"/g)) {
      found.push(file!);
      const wanted = names!.split(",").map((name) => name.split(" as ")[0]!);
      expect(exported.get(file!)).toEqual(expect.arrayContaining(wanted));
    }
    for (const [, file] of code.matchAll(/import\([`"]\.\/([^`"]+)[`"]\)/g)) {
      found.push(file!);
      expect([...exported.keys()]).toContain(file);
    }
  }
  expect(new Set(found)).toEqual(new Set(["rt-viewer.min.js", "rt-viewer.gltf.min.js", "rt-viewer.ktx2.min.js"]));
});
