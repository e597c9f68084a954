import { writeFile } from "node:fs/promises";
import { createCustomElementsManifest } from "./customElements";
import { createSceneSchema } from "./sceneSchema";

/** Adds to `dist` what describes the package to editors and other tools. */
export async function main(): Promise<void> {
  await writeJson("dist/scene.schema.json", await createSceneSchema());
  await writeJson("dist/custom-elements.json", await createCustomElementsManifest());
}

async function writeJson(path: string, value: unknown): Promise<void> {
  await writeFile(path, `${JSON.stringify(value, undefined, 2)}\n`);
}
