import { readFile } from "node:fs/promises";
import { fileURLToPath, pathToFileURL } from "node:url";
import { RtViewerError } from "../errors";
import type { LoadedScene } from "../loaders/loadedScene";
import { loadScene } from "../loaders/loadScene";
import { decodeImage } from "./decodeImage";

/**
 * Reads a scene file of any kind, and the files that it refers to.
 *
 * @throws {RtViewerError} that names the file.
 */
export async function readScene(file: string): Promise<LoadedScene> {
  const bytes = await readBytes(file);
  const fetchResource = async (url: string) => {
    if (new URL(url).protocol !== "file:") throw new RtViewerError("only files on this machine are read");
    return readBytes(fileURLToPath(url));
  };
  return loadScene(bytes, { name: file, baseUrl: pathToFileURL(file).href, fetchResource, decodeImage });
}

async function readBytes(file: string): Promise<Uint8Array> {
  return readFile(file).catch((cause: Error) => {
    throw new RtViewerError(`could not read ${file}: ${cause.message}`, { cause });
  });
}
