import { LoadError } from "../errors";

/** `nodes[3]: …` or `byte 16: …`; other messages go on from the name: `is cut off …`. */
const STARTS_WITH_PLACE = /^(\S+\[|\S+:|byte )/;

/** A file's own words, which may be in a message, can be as long as the file. In characters. */
const MAX_MESSAGE_LENGTH = 1000;

/**
 * Runs a loader so that whatever goes wrong in it is a `LoadError` that begins with the file's name. What the loader did not
 * foresee, in a library say, is the `cause`.
 *
 * @throws {LoadError} or the reason of the signal, if that was aborted.
 */
export async function reportingAs<T>(
  name: string,
  signal: AbortSignal | undefined,
  load: () => Promise<T>,
): Promise<T> {
  try {
    signal?.throwIfAborted();
    return await load();
  } catch (error) {
    signal?.throwIfAborted();
    const whole = error instanceof Error ? error.message : String(error);
    const message = whole.length > MAX_MESSAGE_LENGTH ? `${whole.slice(0, MAX_MESSAGE_LENGTH)}…` : whole;
    if (!(error instanceof LoadError)) throw new LoadError(`${name} could not be read: ${message}`, { cause: error });
    const separator = STARTS_WITH_PLACE.test(message) ? ": " : " ";
    throw new LoadError(`${name}${separator}${message}`, { cause: error.cause });
  }
}
