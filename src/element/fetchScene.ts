import { RtViewerError } from "../errors";
import { fetchBytes, nameOf } from "../loaders/fetchBytes";
import type { LoadedScene } from "../loaders/loadedScene";

/**
 * Reads a scene file of any kind that `loadScene` knows. What is in a JSON scene is not validated here: the tracer does
 * that, and lists the issues.
 *
 * @param src - relative to `base`. What the file refers to is relative to the file.
 * @throws {RtViewerError} if the file cannot be fetched or read. An aborted fetch throws the signal's reason.
 */
export async function fetchScene(src: string, base: string, signal: AbortSignal): Promise<LoadedScene> {
  if (!URL.canParse(src, base)) throw new RtViewerError(`${nameOf(src)} is not a URL`);
  const url = new URL(src, base).href;
  // The code that tells files apart arrives while the file does.
  const [bytes, { loadScene }] = await Promise.all([fetchBytes(url, signal), import("../loaders/loadScene")]);
  return loadScene(bytes, { name: nameOf(url), baseUrl: url, signal });
}
