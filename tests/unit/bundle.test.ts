import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { build, type Rollup } from "vite";
import { expect, test } from "vitest";
import { leanShaders } from "../../vite.config";

const LIMIT_KB = 70;

/** What a page that uses the whole package downloads, its dependencies included, minified as a page's bundler would. */
async function bundle(): Promise<Rollup.OutputChunk[]> {
  const source = (path: string) => fileURLToPath(new URL(`../../src/${path}`, import.meta.url));
  const result = await build({
    configFile: false,
    plugins: [leanShaders()],
    logLevel: "error",
    build: {
      write: false,
      minify: true,
      target: "es2022",
      rollupOptions: {
        input: { index: source("index.ts"), element: source("element.ts") },
        // All exports stay, as if the page used every one of them.
        preserveEntrySignatures: "strict",
      },
    },
  });
  return (result as Rollup.RollupOutput).output.filter((chunk) => chunk.type === "chunk");
}

/** The entries and everything they import before they run; not what they load on demand. */
function loadedAtOnce(chunks: readonly Rollup.OutputChunk[]): Set<Rollup.OutputChunk> {
  const byName = new Map(chunks.map((chunk) => [chunk.fileName, chunk]));
  const loaded = new Set(chunks.filter((chunk) => chunk.isEntry));
  for (const chunk of loaded) for (const name of chunk.imports) loaded.add(byName.get(name)!);
  return loaded;
}

test(`the package and its element take at most ${LIMIT_KB} kB, gzipped, without the panel and the loaders`, {
  timeout: 60_000,
}, async () => {
  const chunks = await bundle();
  const atOnce = loadedAtOnce(chunks);
  const sizeOf = (chunk: Rollup.OutputChunk) => gzipSync(chunk.code).length / 1000;

  const lines = chunks.map((chunk) => {
    const when = atOnce.has(chunk) ? "" : " (on demand)";
    return `${sizeOf(chunk).toFixed(1).padStart(6)} kB gzip  ${chunk.name}${when}`;
  });
  const total = [...atOnce].reduce((sum, chunk) => sum + sizeOf(chunk), 0);
  console.log([...lines, `${total.toFixed(1).padStart(6)} kB gzip  index.js + element.js`].join("\n"));

  expect(total).toBeLessThanOrEqual(LIMIT_KB);
  for (const onDemand of [/tweakpane|src\/panel\//, /gltf-transform|src\/loaders\/gltf/, /meshoptimizer/, /draco/]) {
    const isSo = (id: string) => onDemand.test(id);
    expect([...atOnce].flatMap(({ moduleIds }) => moduleIds.filter(isSo))).toEqual([]);
    expect(chunks.flatMap(({ moduleIds }) => moduleIds).some(isSo)).toBe(true);
  }
});
