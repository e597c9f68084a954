import { writeFile } from "node:fs/promises";
import { createCustomElementsManifest } from "./customElements";
import { addExtensions } from "./declarations";
import { createSceneSchema } from "./sceneSchema";

/** Adds to `dist` what describes the package to editors and other tools, and completes its types. */
export async function main(): Promise<void> {
  await addExtensions("dist");
  await writeJson("dist/scene.schema.json", await createSceneSchema());
  await writeJson("dist/custom-elements.json", await createCustomElementsManifest());
}

async function writeJson(path: string, value: unknown): Promise<void> {
  await writeFile(path, `${JSON.stringify(value, undefined, 2)}\n`);
}
