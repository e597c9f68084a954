import { LoadError } from "../errors";

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
    const message = error instanceof Error ? error.message : String(error);
    const text = error instanceof LoadError ? `${name}: ${message}` : `${name} could not be read: ${message}`;
    throw new LoadError(text, { cause: error instanceof LoadError && error.cause !== undefined ? error.cause : error });
  }
}
