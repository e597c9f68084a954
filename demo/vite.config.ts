import { readdirSync, readFileSync } from "node:fs";
import { basename, extname } from "node:path";
import { fileURLToPath } from "node:url";
import { defineConfig, type Plugin } from "vite";
import { sceneSchemaModule } from "../tools/sceneSchemaModule";
import { leanShaders } from "../vite.config";
import { site, sitePages } from "./site/plugin";

const TYPES: { readonly [extension: string]: string } = {
  ".glb": "model/gltf-binary",
  ".json": "application/json",
  ".webp": "image/webp",
};

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/** The site. It uses the package by its public entries only. */
export default defineConfig({
  root: here("."),
  appType: "mpa", // a missing file is a 404, not the page again
  base: "./",
  resolve: {
    alias: [
      { find: /^rt-viewer$/, replacement: here("../src/index.ts") },
      { find: /^rt-viewer\/element$/, replacement: here("../src/element.ts") },
      { find: /^rt-viewer\/gltf$/, replacement: here("../src/loaders/gltf.ts") },
      { find: /^rt-viewer\/panel$/, replacement: here("../src/panel/panel.ts") },
    ],
  },
  plugins: [
    { ...leanShaders(), apply: "build" }, // in development a changed shader reloads the page
    site(),
    sceneSchemaModule(),
    served("scenes", here("../tests/reference/scenes/"), /\.json$/),
    served("models", here("../tests/reference/"), /\.glb$/),
    served("posters", here("posters/"), /\.webp$/),
    served("references", here("../tests/reference/"), /\.(f32|meta\.json)$/),
  ],
  build: {
    target: "es2022",
    outDir: "dist",
    emptyOutDir: true,
    rollupOptions: { input: [...sitePages()] },
  },
});

/** Serves a folder's files as `PATH/NAME` and puts them into the build, so that there is one copy of each. */
function served(path: string, folder: string, pattern: RegExp): Plugin {
  const names = readdirSync(folder).filter((name) => pattern.test(name));
  return {
    name: `served-${path}`,
    configureServer(server) {
      server.middlewares.use(`/${path}`, (request, response, next) => {
        const name = basename(new URL(request.url ?? "", "http://localhost").pathname);
        if (!names.includes(name)) return next();
        response.setHeader("Content-Type", TYPES[extname(name)] ?? "application/octet-stream");
        response.end(readFileSync(folder + name));
      });
    },
    generateBundle() {
      for (const name of names) {
        this.emitFile({ type: "asset", fileName: `${path}/${name}`, source: readFileSync(folder + name) });
      }
    },
  };
}
