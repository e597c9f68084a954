import { LoadError } from "../errors";
import { show } from "../scene/describe";
import { MAX_FILE_BYTES } from "./limits";
import type { LoadedScene } from "./loadedScene";
import { loadScene } from "./loadScene";
import { reportingAs } from "./reportingAs";

/**
 * Makes a scene of files that were dropped or picked together.
 *
 * @param files - at least one: a scene, and what it refers to. With more than one, the scene is the first whose name says
 *   so; the others are found by name, whatever folder the scene expects them in.
 * @param variant - the look of it to show, by name.
 * @throws {LoadError} if it is no scene, or refers to a file that is not there.
 */
export async function readFiles(files: readonly Blob[], signal: AbortSignal, variant?: string): Promise<LoadedScene> {
  const main = [/\.gl(b|tf)$/i, /\.json$/i, /^/]
    .map((kind) => files.find((file) => kind.test(nameOf(file))))
    .find(Boolean);
  if (main === undefined) throw new LoadError("There is no file to read");
  const others = new Map(files.map((file) => [nameOf(file).toLowerCase(), file]));
  const fetchResource = async (uri: string) => {
    const file = others.get(baseName(uri).toLowerCase());
    if (file === undefined) throw new LoadError(`${show(uri)} is missing: open it together with the scene`);
    return bytesOf(file);
  };
  const name = nameOf(main) || "the file";
  const bytes = await reportingAs(name, signal, () => bytesOf(main));
  return loadScene(bytes, { name, signal, fetchResource, ...(variant !== undefined && { variant }) });
}

function nameOf(file: Blob): string {
  return "name" in file ? String(file.name) : "";
}

/** What a file refers to is a URI, so its name may have escapes. */
function baseName(uri: string): string {
  const last = uri.split(/[?#]/)[0]!.split(/[\\/]/).at(-1)!;
  try {
    return decodeURIComponent(last);
  } catch {
    return last;
  }
}

async function bytesOf(file: Blob): Promise<Uint8Array> {
  if (file.size > MAX_FILE_BYTES) {
    throw new LoadError(`${show(nameOf(file))} has more than ${MAX_FILE_BYTES} bytes`);
  }
  return new Uint8Array(await file.arrayBuffer());
}
