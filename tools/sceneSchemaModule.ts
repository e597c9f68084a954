import { fileURLToPath } from "node:url";
import { type Plugin, runnerImport } from "vite";

const MODULE = "rt-viewer/scene.schema.json";

/** Lets pages that are built from the package's source import the JSON Schema as those do that use the package. */
export function sceneSchemaModule(): Plugin {
  const id = `\0${MODULE}`;
  return {
    name: "scene-schema-module",
    enforce: "pre",
    resolveId: (source) => (source === MODULE ? id : undefined),
    async load(loaded) {
      if (loaded !== id) return;
      const generator = fileURLToPath(new URL("sceneSchema.ts", import.meta.url));
      const { module } = await runnerImport<typeof import("./sceneSchema")>(generator, { logLevel: "error" });
      return JSON.stringify(await module.createSceneSchema()); // by the name, Vite knows that it is JSON
    },
  };
}
