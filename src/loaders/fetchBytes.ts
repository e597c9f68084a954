import { LoadError, RtViewerError } from "../errors";
import { MAX_FILE_BYTES } from "./limits";

/** Of an address in a message: a `data:` URL can be a whole model. */
const MAX_NAME_LENGTH = 200;

/**
 * Downloads a file.
 *
 * @throws {LoadError} if it has more bytes than are read: half a GiB. It is not downloaded further then.
 * @throws {RtViewerError} that names the address and says why. An aborted download throws the signal's reason.
 */
export async function fetchBytes(url: string, signal?: AbortSignal): Promise<Uint8Array> {
  let response: Response;
  try {
    response = await fetch(url, signal === undefined ? {} : { signal });
    if (response.ok) return await read(response, url);
  } catch (cause) {
    signal?.throwIfAborted();
    if (cause instanceof LoadError) throw cause;
    const reason = cause instanceof Error ? cause.message : String(cause);
    throw new RtViewerError(`${nameOf(url)} could not be fetched: ${reason}`, { cause });
  }
  throw new RtViewerError(`${nameOf(url)} could not be fetched: ${response.status} ${response.statusText}`.trimEnd());
}

/** An address as it can stand in a message. */
export function nameOf(url: string): string {
  return url.length > MAX_NAME_LENGTH ? `${url.slice(0, MAX_NAME_LENGTH)}…` : url;
}

/** What the server says of the length may be wrong, and is of the packed bytes, if they are packed: they are counted too. */
async function read({ body, headers }: Response, url: string): Promise<Uint8Array> {
  const tooLarge = new LoadError(`${nameOf(url)} has more than ${MAX_FILE_BYTES} bytes`);
  if (Number(headers.get("content-length")) > MAX_FILE_BYTES) {
    await body?.cancel();
    throw tooLarge;
  }
  let byteCount = 0;
  const counter = new TransformStream<Uint8Array<ArrayBuffer>, Uint8Array<ArrayBuffer>>({
    transform(chunk, controller) {
      byteCount += chunk.length;
      if (byteCount > MAX_FILE_BYTES) controller.error(tooLarge);
      else controller.enqueue(chunk);
    },
  });
  const counted = new Response(body?.pipeThrough(counter));
  try {
    return new Uint8Array(await counted.arrayBuffer());
  } catch (cause) {
    throw byteCount > MAX_FILE_BYTES ? tooLarge : cause; // browsers say "network error" instead
  }
}
