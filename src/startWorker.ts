/**
 * A worker that has started and said so: with its first message, whatever it is. `undefined` where there is none, in Node say, and
 * where a content security policy, a foreign origin or a missing script forbids it.
 *
 * @param create - makes it. Bundlers look for `new Worker(new URL(…, import.meta.url))`, so each caller has its own.
 * @throws the reason of the signal.
 */
export async function startWorker(create: () => Worker, signal?: AbortSignal): Promise<Worker | undefined> {
  if (typeof Worker === "undefined") return undefined;
  let worker: Worker;
  try {
    worker = create();
  } catch {
    return undefined; // of a foreign origin
  }
  let hasStarted = false;
  try {
    hasStarted = await untilAborted(signal, (resolve) => {
      worker.onmessage = () => resolve(true);
      worker.onerror = (event) => {
        event.preventDefault(); // no error of the page's
        resolve(false);
      };
    });
  } finally {
    if (!hasStarted) worker.terminate();
  }
  return hasStarted ? worker : undefined;
}

/** A promise that is also rejected by the signal, with its reason. */
export function untilAborted<T>(
  signal: AbortSignal | undefined,
  start: (resolve: (value: T) => void, reject: (reason: unknown) => void) => void,
): Promise<T> {
  return new Promise((resolve, reject) => {
    if (signal?.aborted) return reject(signal.reason);
    const abort = () => reject(signal?.reason);
    signal?.addEventListener("abort", abort, { once: true });
    const done = () => signal?.removeEventListener("abort", abort);
    start(
      (value) => {
        done();
        resolve(value);
      },
      (reason) => {
        done();
        reject(reason);
      },
    );
  });
}
