import { readFile } from "node:fs/promises";
import { defineConfig, type Plugin } from "vite";

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

/** The package: ES modules with the shaders inlined, so that users need no plugin. */
export default defineConfig({
  plugins: [leanShaders()],
  build: {
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
        /^(@gltf-transform\/(core|extensions)|meshoptimizer|tweakpane|valibot|wesl|wgpu-matrix)(\/|$)/,
        // Its decoder is external; the WebAssembly beside it comes with the package, so that no bundler has to find it.
        /^draco3dgltf\/.*\.js$/,
      ],
    },
    target: "es2022",
    sourcemap: true,
    minify: false,
  },
});
