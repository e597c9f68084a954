/**
 * Resolves in a task of its own, so that a page can draw and answer meanwhile. Timers would do too, but wait, and for a second in
 * a page that is not seen.
 */
export function nextTask(): Promise<void> {
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(undefined);
  });
}
