// Files of any supported kind, told apart by what is in them: names and media types are often wrong.

import { LoadError } from "../errors";
import type { Scene } from "../scene/schema";
import type { LoadedScene, LoadOptions } from "./loadedScene";
import { missingVariant } from "./missingVariant";
import { reportingAs } from "./reportingAs";

/**
 * Makes a scene of a file: our JSON, which passes as it is and is not validated here, or glTF 2.0, whose loader is fetched
 * when it is needed.
 *
 * @throws {LoadError} if it is neither, or cannot be read. Nothing else is thrown, but the signal's reason.
 */
export async function loadScene(bytes: Uint8Array, options: LoadOptions = {}): Promise<LoadedScene> {
  const { name = "the file", signal, variant } = options;
  const json = await reportingAs(name, signal, async () => (startsWith(bytes, "glTF") ? undefined : parseJson(bytes)));
  // Every glTF file has an asset, and no scene of ours.
  const isGltf = json === undefined || (typeof json === "object" && json !== null && "asset" in json);
  if (!isGltf) {
    const warnings = variant === undefined ? [] : [missingVariant("The file", variant, [])];
    return { scene: json as Scene, warnings, variants: [] };
  }
  const { loadGltf } = await reportingAs(name, signal, () => import("./gltf"));
  return loadGltf(bytes, options);
}

function parseJson(bytes: Uint8Array): unknown {
  const text = new TextDecoder().decode(bytes);
  const foreign = foreignFormat(text.slice(0, LONGEST_PREAMBLE));
  if (foreign !== undefined) throw new LoadError(`is ${foreign}, which cannot be read; convert it to .glb`);
  try {
    return JSON.parse(text);
  } catch (cause) {
    throw new LoadError(`is not JSON: ${cause instanceof Error ? cause.message : cause}`, { cause });
  }
}

/** Comments and blank lines before the first statement of an OBJ file, in characters. */
const LONGEST_PREAMBLE = 1000;

/** Formats that people try, by how their files begin. */
function foreignFormat(text: string): string | undefined {
  if (/^ply\r?\n/.test(text)) return "a PLY file";
  if (/^(#.*\n|\s)*(v|vn|vt|o|g|mtllib|usemtl) /.test(text)) return "a Wavefront OBJ file";
  if (/^solid /.test(text)) return "an STL file";
  if (/^Kaydara FBX/.test(text)) return "an FBX file";
  return undefined;
}

function startsWith(bytes: Uint8Array, text: string): boolean {
  return [...text].every((character, i) => bytes[i] === character.charCodeAt(0));
}
