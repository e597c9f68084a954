import { RtViewerError } from "../errors";

/**
 * Downloads a file.
 *
 * @throws {RtViewerError} that names the address and says why. An aborted download throws the signal's reason.
 */
export async function fetchBytes(url: string, signal?: AbortSignal): Promise<Uint8Array> {
  let response: Response;
  try {
    response = await fetch(url, signal === undefined ? {} : { signal });
    if (response.ok) return new Uint8Array(await response.arrayBuffer());
  } catch (cause) {
    signal?.throwIfAborted();
    const reason = cause instanceof Error ? cause.message : String(cause);
    throw new RtViewerError(`${url} could not be fetched: ${reason}`, { cause });
  }
  throw new RtViewerError(`${url} could not be fetched: ${response.status} ${response.statusText}`.trimEnd());
}
