import { readFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import { deflateSync } from "node:zlib";
import { type BuildEnvironmentOptions, defineConfig, type Plugin } from "vite";

/**
 * Ships shader modules, and the templates of files that say `@lean wgsl` or `@lean css`, without comments and indentation: a twelfth
 * of what a page downloads. WGSL has no strings to mistake for a comment.
 */
export function leanShaders(): Plugin {
  const lean = {
    wgsl: (text: string) =>
      text
        .replaceAll(/\s*\/\/.*$/gm, "")
        .replaceAll(/\n\s+/g, "\n")
        .replaceAll(/([,:]) +/g, "$1"),
    css: (text: string) =>
      text
        .replaceAll(/\s*\/\*.*?\*\//gs, "")
        .replaceAll(/\n\s+/g, "\n")
        .replaceAll(/([:;,{]) +/g, "$1"),
  };
  return {
    name: "lean-shaders",
    enforce: "pre",
    async load(id) {
      const [file, query] = id.split("?");
      if (!file?.endsWith(".wgsl") || query !== "raw") return;
      return `export default ${JSON.stringify(lean.wgsl(await readFile(file, "utf8")).trimStart())}`;
    },
    transform(code) {
      const language = /^\/\/ @lean (wgsl|css)$/m.exec(code)?.[1];
      return language && lean[language as keyof typeof lean](code);
    },
  };
}

/** Deflates WebAssembly that is inlined; `inlinedBytes` inflates it. As it is, a page would download a third more. */
export function deflatedWasm(): Plugin {
  const suffix = "?url&inline";
  return {
    name: "deflated-wasm",
    enforce: "pre",
    async load(id) {
      if (!id.endsWith(`.wasm${suffix}`)) return;
      const bytes = deflateSync(await readFile(id.slice(0, -suffix.length)), { level: 9 });
      return `export default "data:application/zlib;base64,${bytes.toString("base64")}"`;
    },
  };
}

/** ES modules with the shaders inlined, so that users need no plugin. */
const modules: BuildEnvironmentOptions = {
  lib: {
    entry: {
      index: "src/index.ts",
      element: "src/element.ts",
      panel: "src/panel/panel.ts",
      gltf: "src/loaders/gltf.ts",
    },
    formats: ["es"],
  },
  rollupOptions: {
    external: [
      /^(@gltf-transform\/(core|extensions)|meshoptimizer|tweakpane|valibot|wgpu-matrix)(\/|$)/,
      // Its decoder is external; the WebAssembly beside it comes with the package, so that no bundler has to find it.
      /^draco3dgltf\/.*\.js$/,
    ],
  },
  sourcemap: true,
  minify: false,
};

/** One file, dependencies too, for `<script type="module">`. */
const minified = (entry: string, fileName: string): BuildEnvironmentOptions => ({
  emptyOutDir: false,
  lib: { entry, formats: ["es"] },
  rollupOptions: { output: { entryFileNames: fileName, codeSplitting: false, minify: true } },
});

/** Leaves modules of ours to a file beside the one that is built. */
function inFileBeside(files: Readonly<Record<string, string>>): Plugin {
  const source = (path: string) => fileURLToPath(new URL(path, import.meta.url));
  const byId = new Map(Object.entries(files).map(([path, file]) => [source(path), file]));
  return {
    name: "in-file-beside",
    enforce: "pre",
    async resolveId(name, importer, options) {
      const file = byId.get((await this.resolve(name, importer, { ...options, skipSelf: true }))?.id ?? "");
      return file === undefined ? undefined : { id: file, external: true };
    },
  };
}

/**
 * What each `--mode` builds: the package's modules; all of it in a single file; the glTF loader, which that one loads; and the
 * transcoder of KTX2 pictures, which that one loads.
 */
const builds: Readonly<Record<string, { build: BuildEnvironmentOptions; beside?: Readonly<Record<string, string>> }>> =
  {
    production: { build: modules },
    single: {
      build: minified("src/bundle.ts", "rt-viewer.min.js"),
      beside: { "src/loaders/gltf.ts": "./rt-viewer.gltf.min.js" },
    },
    "single-gltf": {
      build: minified("src/loaders/gltf.ts", "rt-viewer.gltf.min.js"),
      beside: {
        "src/errors.ts": "./rt-viewer.min.js", // one class of errors, for `instanceof`
        "src/loaders/ktx2/transcoderModule.ts": "./rt-viewer.ktx2.min.js",
      },
    },
    "single-ktx2": { build: minified("src/loaders/ktx2/transcoderModule.ts", "rt-viewer.ktx2.min.js") },
  };

export default defineConfig(({ mode }) => {
  const { build, beside = {} } = builds[mode] ?? builds.production!;
  return {
    // Addresses within the package are relative: the worker is found wherever a page or a bundler puts it.
    base: "./",
    plugins: [leanShaders(), deflatedWasm(), inFileBeside(beside)],
    build: { target: "es2022", ...build },
  };
});
