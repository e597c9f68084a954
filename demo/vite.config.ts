import { readdirSync, readFileSync } from "node:fs";
import { basename } from "node:path";
import { fileURLToPath } from "node:url";
import { defineConfig, type Plugin } from "vite";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));
const SCENES = here("../tests/reference/scenes/");

/** The site. It uses the package by its public entries only. */
export default defineConfig({
  root: here("."),
  appType: "mpa", // a missing file is a 404, not the page again
  base: "./",
  resolve: {
    alias: [
      { find: /^rt-viewer$/, replacement: here("../src/index.ts") },
      { find: /^rt-viewer\/element$/, replacement: here("../src/element.ts") },
      { find: /^rt-viewer\/panel$/, replacement: here("../src/panel/panel.ts") },
    ],
  },
  plugins: [servedScenes()],
  build: {
    target: "es2022",
    outDir: "dist",
    emptyOutDir: true,
  },
});

/** Serves the reference scenes as `scenes/NAME.json` and puts them into the build, so that there is one copy of each. */
function servedScenes(): Plugin {
  const names = readdirSync(SCENES).filter((name) => name.endsWith(".json"));
  return {
    name: "served-scenes",
    configureServer(server) {
      server.middlewares.use("/scenes", (request, response, next) => {
        const name = basename(new URL(request.url ?? "", "http://localhost").pathname);
        if (!names.includes(name)) return next();
        response.setHeader("Content-Type", "application/json");
        response.end(readFileSync(SCENES + name));
      });
    },
    generateBundle() {
      for (const name of names) {
        this.emitFile({ type: "asset", fileName: `scenes/${name}`, source: readFileSync(SCENES + name) });
      }
    },
  };
}
