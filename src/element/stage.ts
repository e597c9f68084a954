import { lossError } from "../gpu/device";
import { PathTracer } from "../renderer/pathTracer";
import { DEFAULT_SETTINGS, type Settings } from "../renderer/settings";
import type { ResolvedCamera, Scene } from "../scene/schema";
import type { PixelSize } from "./canvasSize";
import { CanvasView } from "./canvasView";
import type { ProgressDetail, ReadyDetail } from "./events";
import { LatestTask } from "./latestTask";
import { SceneEdits } from "./sceneEdits";

/** Whom the stage tells what happens on it. */
export type StageListener = {
  /** A scene is loaded and compiled; its first picture comes with one of the next frames. */
  readonly onScene: () => void;
  readonly onReady: (detail: ReadyDetail) => void;
  readonly onProgress: (detail: ProgressDetail) => void;
  readonly onConverged: (detail: ProgressDetail) => void;
  readonly onError: (error: Error) => void;
};

const PROGRESS_INTERVAL_MS = 100;

/** What lies between a request for a scene and the picture on a canvas. Knows the canvas and the tracer, not the page. */
export class Stage {
  readonly #canvas: HTMLCanvasElement;
  readonly #listener: StageListener;
  readonly #task = new LatestTask();
  #view: CanvasView | undefined;
  #edits: SceneEdits | undefined;
  /** Scenes that are being loaded; those that were overtaken too. */
  #loads = 0;
  #size: PixelSize = { width: 1, height: 1 };
  #settings: Settings = DEFAULT_SETTINGS;
  #exposure = 0;
  #isPaused = false;
  /** When the scene was asked for whose first picture is still to come. */
  #requestedAt: number | undefined;
  /** Whether anything was drawn since. */
  #hasDrawn = false;
  #reportedAt = Number.NEGATIVE_INFINITY;
  #reportedSamples = 0;
  #wasConverged = false;

  constructor(canvas: HTMLCanvasElement, listener: StageListener) {
    this.#canvas = canvas;
    this.#listener = listener;
  }

  get tracer(): PathTracer | undefined {
    return this.#view?.tracer;
  }

  /** Whether a scene is there that has not been seen yet. */
  get owesPicture(): boolean {
    return this.#view !== undefined && this.#requestedAt !== undefined;
  }

  get camera(): ResolvedCamera | undefined {
    return this.tracer?.camera;
  }

  /**
   * Moves the camera; what is left out stays as it is. Without a scene there is nothing to move.
   *
   * @throws {SceneError} if there is no such camera.
   */
  moveCamera(changes: Partial<ResolvedCamera>): void {
    const { tracer } = this;
    tracer?.setCamera({ ...tracer.camera, ...changes });
  }

  set size(size: PixelSize) {
    this.#size = size;
    this.#view?.resize(size);
  }

  set settings(settings: Settings) {
    this.#settings = settings;
    this.#applySettings();
  }

  /** Whether the picture rests as it is; a new view still gets its first sample. */
  set isPaused(isPaused: boolean) {
    this.#isPaused = isPaused;
    this.#applySettings();
  }

  /** In stops. */
  set exposure(stops: number) {
    this.#exposure = stops;
    if (this.#view !== undefined) this.#view.exposure = stops;
  }

  /** Shows a scene in place of what there is. Of several calls the last one wins. Never rejects: errors are reported. */
  async show(read: (signal: AbortSignal) => Promise<Scene>): Promise<void> {
    const requestedAt = performance.now();
    this.#loads += 1;
    this.#edits?.cancel();
    try {
      const isLast = await this.#task.run(read, (scene, signal) => this.#put(scene, signal));
      if (!isLast || this.#view === undefined) return;
      this.#requestedAt = requestedAt;
      this.#hasDrawn = false;
      this.#listener.onScene();
    } catch (error) {
      this.#listener.onError(toError(error));
    } finally {
      this.#loads -= 1;
    }
  }

  /**
   * Shows the scene with other values, seen from where the camera is. Errors are reported.
   *
   * @returns false, and nothing is done, without a scene and while another one is loaded.
   */
  edit(scene: Scene): boolean {
    if (this.#edits === undefined || this.#loads > 0) return false;
    this.#edits.show(scene).catch((error: unknown) => this.#listener.onError(toError(error)));
    return true;
  }

  /** Does the work of one frame. */
  tick(): void {
    if (this.#view === undefined) return;
    try {
      if (this.#view.draw()) this.#hasDrawn = true;
      this.#report(this.#view);
    } catch (error) {
      this.clear();
      this.#listener.onError(toError(error));
    }
  }

  /** Shows the picture again, after the canvas has been moved. */
  refresh(): void {
    this.#view?.refresh();
  }

  /** Ends what is under way and gives back the GPU. */
  clear(): void {
    this.#task.cancel();
    this.#view?.dispose();
    this.#view = undefined;
    this.#edits?.cancel();
    this.#edits = undefined;
    this.#requestedAt = undefined;
    this.#reportedSamples = 0;
    this.#wasConverged = false;
  }

  async #put(scene: Scene, signal: AbortSignal): Promise<void> {
    if (this.#view === undefined) {
      const tracer = await PathTracer.create({ scene, ...this.#size, settings: this.#effectiveSettings() });
      if (signal.aborted) {
        tracer.dispose();
        return;
      }
      this.#view = new CanvasView(tracer, this.#canvas);
      this.#edits = new SceneEdits(tracer);
      this.#watchDevice(this.#view);
    } else {
      await this.#view.tracer.setScene(scene);
      if (signal.aborted) return;
    }
    // What changed while the scene was compiled.
    this.#view.resize(this.#size);
    this.#applySettings();
    this.#view.exposure = this.#exposure;
  }

  #watchDevice(view: CanvasView): void {
    void view.tracer.device.lost.then((info) => {
      if (this.#view !== view) return;
      this.clear();
      this.#listener.onError(lossError(info));
    });
  }

  #report({ tracer, isFullSize }: CanvasView): void {
    const { samples, error, converged } = tracer.stats;
    const now = performance.now();
    if (this.#hasDrawn && samples > 0 && this.#requestedAt !== undefined) {
      const milliseconds = now - this.#requestedAt;
      this.#requestedAt = undefined;
      this.#reportedSamples = 0;
      this.#listener.onReady({ tracer, milliseconds });
    }
    if (this.owesPicture) return;
    const isDue = now - this.#reportedAt >= PROGRESS_INTERVAL_MS || converged;
    if (samples !== this.#reportedSamples && isDue) {
      this.#reportedAt = now;
      this.#reportedSamples = samples;
      if (samples > 0) this.#listener.onProgress({ samples, error });
    }
    const hasConverged = converged && isFullSize && !this.#isPaused;
    if (hasConverged && !this.#wasConverged) this.#listener.onConverged({ samples, error });
    this.#wasConverged = hasConverged;
  }

  #applySettings(): void {
    if (this.#view !== undefined) this.#view.settings = this.#effectiveSettings();
  }

  /** A pause is a limit of one sample: what has more of them stays, and a new view gets one. */
  #effectiveSettings(): Settings {
    return this.#isPaused ? { ...this.#settings, maxSamples: 1 } : this.#settings;
  }
}

function toError(error: unknown): Error {
  return error instanceof Error ? error : new Error(String(error));
}
