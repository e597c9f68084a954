import { defineConfig } from "vite";

/** The package: ES modules with the shaders inlined, so that users need no plugin. */
export default defineConfig({
  build: {
    lib: {
      entry: { index: "src/index.ts", element: "src/element.ts", panel: "src/panel/panel.ts" },
      formats: ["es"],
    },
    rollupOptions: { external: [/^(tweakpane|valibot|wesl|wgpu-matrix)(\/|$)/] },
    target: "es2022",
    sourcemap: true,
    minify: false,
  },
});
