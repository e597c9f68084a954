/**
 * Runs tasks of two steps so that the last one asked for is the one that holds in the end.
 *
 * `prepare` (a download, say) starts at once and is aborted by a newer task. `commit` (what changes shared state) never
 * overlaps another one, and is left out when a newer task has come by then.
 */
export class LatestTask {
  #controller: AbortController | undefined;
  #lastCommit: Promise<void> = Promise.resolve();

  /** Whether a task is under way that nobody has cancelled. */
  get isRunning(): boolean {
    return this.#controller !== undefined;
  }

  /**
   * @returns whether this task was carried out to its end and no newer one came meanwhile.
   * @throws what a step threw, unless the task was superseded: then nobody waits for it any more.
   */
  async run<T>(
    prepare: (signal: AbortSignal) => Promise<T>,
    commit: (prepared: T, signal: AbortSignal) => Promise<void>,
  ): Promise<boolean> {
    this.cancel();
    const controller = new AbortController();
    this.#controller = controller;
    const { signal } = controller;
    try {
      const prepared = await prepare(signal);
      const turn = this.#lastCommit.then(() => (signal.aborted ? undefined : commit(prepared, signal)));
      this.#lastCommit = turn.catch(() => undefined);
      await turn;
    } catch (error) {
      if (signal.aborted) return false;
      throw error;
    } finally {
      if (this.#controller === controller) this.#controller = undefined;
    }
    return !signal.aborted;
  }

  /** Aborts the task that is under way, if any. */
  cancel(): void {
    this.#controller?.abort();
    this.#controller = undefined;
  }
}
