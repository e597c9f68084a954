import { RtViewerError } from "../errors";
import type { Scene } from "../scene/schema";

/**
 * Reads a scene file. What is in it is not validated here: the tracer does that, and lists every issue.
 *
 * @param src - relative to `base`.
 * @throws {RtViewerError} if the file cannot be fetched or is not JSON. An aborted fetch throws the signal's reason.
 */
export async function fetchScene(src: string, base: string, signal: AbortSignal): Promise<Scene> {
  if (!URL.canParse(src, base)) throw new RtViewerError(`${src} is not a URL`);
  const url = new URL(src, base).href;
  const text = await fetchText(url, signal);
  try {
    return JSON.parse(text) as Scene;
  } catch (cause) {
    throw new RtViewerError(`${url} is not JSON: ${messageOf(cause)}`, { cause });
  }
}

async function fetchText(url: string, signal: AbortSignal): Promise<string> {
  let response: Response;
  try {
    response = await fetch(url, { signal });
    if (response.ok) return await response.text();
  } catch (cause) {
    signal.throwIfAborted();
    throw new RtViewerError(`${url} could not be fetched: ${messageOf(cause)}`, { cause });
  }
  throw new RtViewerError(`${url} could not be fetched: ${response.status} ${response.statusText}`.trimEnd());
}

function messageOf(cause: unknown): string {
  return cause instanceof Error ? cause.message : String(cause);
}
