import { readFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import packageJson from "../package.json" with { type: "json" };
import { SceneSchema } from "../src/scene/schema";
import { type JsonSchema, toJsonSchema } from "./jsonSchema";
import { readSchemaDocs, type SchemaDocs } from "./schemaDocs";

/** JSON Schema of scene files, made from the schema that `parseScene` uses and the docstrings in its source. */
export async function createSceneSchema(): Promise<JsonSchema> {
  const source = (name: string) => readFile(fileURLToPath(new URL(`../src/scene/${name}.ts`, import.meta.url)), "utf8");
  let docs: ReadonlyMap<string, SchemaDocs> = new Map();
  for (const name of ["numbers", "materialSchema", "schema"]) docs = readSchemaDocs(await source(name), docs);
  return {
    $schema: "http://json-schema.org/draft-07/schema#",
    $id: `https://unpkg.com/rt-viewer@${packageJson.version}/dist/scene.schema.json`,
    title: "rt-viewer scene",
    ...toJsonSchema(SceneSchema, docs.get("SceneSchema")),
  };
}
