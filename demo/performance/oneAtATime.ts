/** Lets one task use the device at a time. */
export class OneAtATime {
  #controller = new AbortController();
  #running: Promise<void> = Promise.resolve();

  /** Stops what runs, waits until it has stopped, and begins `task` unless something else was begun meanwhile. */
  begin(task: (signal: AbortSignal) => Promise<void>): void {
    this.stop();
    const { signal } = this.#controller;
    this.#running = this.#running.then(() => (signal.aborted ? undefined : task(signal)));
  }

  stop(): void {
    this.#controller.abort();
    this.#controller = new AbortController();
  }
}
