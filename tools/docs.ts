import { mkdir, rm, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import packageJson from "../package.json" with { type: "json" };
import { describeEntry, readExports } from "./apiDocs";
import { createCustomElementsManifest } from "./customElements";
import { describeElement } from "./elementDocs";
import { describeScene } from "./sceneDocs";
import { createSceneSchema } from "./sceneSchema";

const FOLDER = "docs/api";

/** `npm run docs`: writes the API documentation from the docstrings, by way of the built type declarations. */
export async function main(): Promise<void> {
  await rm(FOLDER, { recursive: true, force: true });
  await mkdir(FOLDER, { recursive: true });
  for (const [name, text] of await createDocs(".")) await writeFile(join(FOLDER, name), text);
}

/**
 * The pages of the API documentation, by the names of their files.
 *
 * @param packageFolder - where the built package is: the folder that holds `dist`.
 */
export async function createDocs(packageFolder: string): Promise<ReadonlyMap<string, string>> {
  const pages = new Map<string, string>();
  const contents: string[] = [];
  for (const [entry, target] of Object.entries(packageJson.exports)) {
    if (typeof target === "string") continue;
    const name = entry.replace(/^\./, packageJson.name);
    const file = `${entry === "." ? "index" : entry.slice(2)}.md`;
    const exports = await readExports(pathToFileURL(join(packageFolder, target.types)));
    const sections = entry === "./element" ? [describeElement(await createCustomElementsManifest())] : [];
    pages.set(file, `${describeEntry(name, exports, sections)}\n`);
    contents.push(`- [\`${name}\`](${file}): ${exports.map((each) => each.name).join(", ")}`);
  }
  pages.set("scene.md", `${describeScene(await createSceneSchema())}\n`);
  contents.push("- [The scene format](scene.md)");
  pages.set("README.md", `# API\n\nMade from the docstrings by \`npm run docs\`.\n\n${contents.join("\n")}\n`);
  return pages;
}
