import type { PathTracer } from "../renderer/pathTracer";
import type { Scene } from "../scene/schema";

/** What a change of the scene needs of a tracer. */
export type EditedTracer = Pick<PathTracer, "camera" | "setScene">;

/** Shows changed scenes, one at a time: of those that come while one is compiled, the last one is next. */
export class SceneEdits {
  readonly #tracer: EditedTracer;
  #next: Scene | undefined;
  #isBusy = false;

  constructor(tracer: EditedTracer) {
    this.#tracer = tracer;
  }

  /**
   * Shows the scene, seen from where the camera is. Resolves when there is nothing more to show, or something is at it already.
   *
   * @throws what the tracer throws. The scene that was there before stays.
   */
  async show(scene: Scene): Promise<void> {
    this.#next = scene;
    if (this.#isBusy) return;
    this.#isBusy = true;
    try {
      while (this.#next !== undefined) await this.#showNext(this.#next);
    } finally {
      this.#isBusy = false;
      this.#next = undefined;
    }
  }

  /** Drops what is still to be shown. */
  cancel(): void {
    this.#next = undefined;
  }

  async #showNext(scene: Scene): Promise<void> {
    this.#next = undefined;
    await this.#tracer.setScene(scene, { camera: this.#tracer.camera });
  }
}

export const createSceneEdits = (tracer: EditedTracer): SceneEdits => new SceneEdits(tracer);
