import { readFile } from "node:fs/promises";
import { fileURLToPath, pathToFileURL } from "node:url";
import { RtViewerError } from "../errors";
import type { LoadedScene } from "../loaders/loadedScene";
import { loadScene } from "../loaders/loadScene";
import { texelBytesWithin } from "../loaders/texelBudget";
import { decodeImage } from "./decodeImage";

/**
 * Reads a scene file of any kind, and the files that it refers to.
 *
 * @param limits - of the device that is to show it: pictures are halved until it can hold them.
 * @param variant - the look of it to show, by name.
 * @throws {RtViewerError} that names the file.
 */
export async function readScene(
  file: string,
  limits: GPUSupportedLimits,
  variant: string | undefined,
): Promise<LoadedScene> {
  const bytes = await readBytes(file);
  const fetchResource = async (url: string) => {
    if (new URL(url).protocol !== "file:") throw new RtViewerError("only files on this machine are read");
    return readBytes(fileURLToPath(url));
  };
  const baseUrl = pathToFileURL(file).href;
  const maxTexelBytes = texelBytesWithin(limits);
  const options = { name: file, baseUrl, fetchResource, decodeImage, maxTexelBytes };
  return loadScene(bytes, { ...options, ...(variant !== undefined && { variant }) });
}

async function readBytes(file: string): Promise<Uint8Array> {
  return readFile(file).catch((cause: Error) => {
    throw new RtViewerError(`could not read ${file}: ${cause.message}`, { cause });
  });
}
