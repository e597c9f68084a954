/** Calls a function before every repaint, while it is running. */
export class RenderLoop {
  readonly #onFrame: () => void;
  #request: number | undefined;

  constructor(onFrame: () => void) {
    this.#onFrame = onFrame;
  }

  get isRunning(): boolean {
    return this.#request !== undefined;
  }

  set isRunning(shouldRun: boolean) {
    if (shouldRun === this.isRunning) return;
    if (shouldRun) this.#schedule();
    else this.#stop();
  }

  #schedule(): void {
    this.#request = requestAnimationFrame(() => {
      this.#schedule();
      this.#onFrame();
    });
  }

  #stop(): void {
    if (this.#request !== undefined) cancelAnimationFrame(this.#request);
    this.#request = undefined;
  }
}
