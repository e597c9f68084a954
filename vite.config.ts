import { readFile } from "node:fs/promises";
import { type BuildEnvironmentOptions, defineConfig, type Plugin } from "vite";

/** Ships shader modules without their comments: a twelfth of what a page downloads. WGSL has no strings to mistake for one. */
export function leanShaders(): Plugin {
  return {
    name: "lean-shaders",
    enforce: "pre",
    async load(id) {
      const [file, query] = id.split("?");
      if (!file?.endsWith(".wgsl") || query !== "raw") return;
      const text = await readFile(file, "utf8");
      return `export default ${JSON.stringify(text.replaceAll(/\s*\/\/.*$/gm, "").trimStart())}`;
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
    },
    formats: ["es"],
  },
  rollupOptions: { external: [/^(tweakpane|valibot|wesl|wgpu-matrix)(\/|$)/] },
  sourcemap: true,
  minify: false,
};

/** The same in one file, dependencies too, for `<script type="module">`. */
const singleFile: BuildEnvironmentOptions = {
  emptyOutDir: false,
  lib: { entry: "src/bundle.ts", formats: ["es"] },
  rollupOptions: { output: { entryFileNames: "rt-viewer.min.js", codeSplitting: false, minify: true } },
};

/** The package; with `--mode single`, its single file. */
export default defineConfig(({ mode }) => ({
  // Addresses within the package are relative: the worker is found wherever a page or a bundler puts it.
  base: "./",
  plugins: [leanShaders()],
  build: { target: "es2022", ...(mode === "single" ? singleFile : modules) },
}));
