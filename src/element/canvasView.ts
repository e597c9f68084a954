import { WebGpuError } from "../errors";
import type { PathTracer } from "../renderer/pathTracer";
import type { Settings } from "../renderer/settings";
import type { View } from "../renderer/view";
import type { PixelSize } from "./canvasSize";
import { FrameBudget } from "./frameBudget";

/**
 * One tracer that draws into one canvas, and owns both the tracer and the canvas's connection to the GPU.
 *
 * The canvas always has every pixel. The film has fewer while the camera, the scene or the canvas changes from frame to frame
 * and the adapter could not keep up otherwise.
 */
export class CanvasView {
  readonly tracer: PathTracer;
  readonly #canvas: HTMLCanvasElement;
  readonly #context: GPUCanvasContext;
  readonly #budget = new FrameBudget();
  /** The canvas's, from the next picture on. */
  #size: PixelSize;
  /** What the last frame was to show, compared by identity: the tracer keeps its objects until they change. */
  #shown: readonly object[];
  #look: View = {};
  /** The canvas does not show what it would show if the film were drawn now. */
  #isStale = true;
  #isCalm = false;
  /** Samples in the film at the last frame, and in the picture on the canvas; 0 where that is to be drawn in any case. */
  #samples = 0;
  #drawnSamples = 0;

  /** @throws {WebGpuError} if the canvas has been given to another kind of context. */
  constructor(tracer: PathTracer, canvas: HTMLCanvasElement) {
    const context = canvas.getContext("webgpu") as GPUCanvasContext | null;
    if (context === null) throw new WebGpuError("The canvas gives no WebGPU context.");
    this.tracer = tracer;
    this.#canvas = canvas;
    this.#context = context;
    this.#size = { width: tracer.width, height: tracer.height };
    this.#shown = this.#toShow();
    context.configure({
      device: tracer.device,
      format: navigator.gpu.getPreferredCanvasFormat(),
      alphaMode: "opaque",
    });
  }

  /** How radiance becomes a picture. */
  set look(look: View) {
    this.#look = look;
    this.refresh();
  }

  /** Whether the noise should not flicker: the picture then changes when it has twice the samples, and half the variance. */
  set isCalm(isCalm: boolean) {
    this.#isCalm = isCalm;
  }

  /** Of the picture at rest. */
  set settings(settings: Settings) {
    this.tracer.update(settings);
  }

  /** In physical pixels. The film follows with the next frame, and the canvas with its picture, so that none is lost. */
  resize({ width, height }: PixelSize): void {
    if (width !== this.#size.width || height !== this.#size.height) this.#size = { width, height };
  }

  /** Whether the film has a sample, or will have, of every pixel of the canvas: not while the picture moves too fast. */
  get isFullSize(): boolean {
    return this.tracer.width === this.#size.width && this.tracer.height === this.#size.height;
  }

  /** Shows the film again, though it may not have changed; after the canvas was moved, say. */
  refresh(): void {
    this.#isStale = true;
    this.#drawnSamples = 0;
  }

  /**
   * Does the work of one frame.
   *
   * @returns whether the canvas shows something new.
   * @throws {WebGpuError} if earlier work on the GPU failed.
   */
  draw(): boolean {
    const { tracer } = this;
    this.#fitFilm(performance.now());
    if (tracer.frame()) this.#isStale = true;
    if (!this.#isStale || !this.#isDue()) return false;
    // Until its first sample is complete the film has nothing to show, and the canvas keeps its last picture.
    if (!this.#present()) return false;
    this.#isStale = false;
    this.#drawnSamples = this.#samples;
    const { width, height } = this.#size;
    if (this.#canvas.width === width && this.#canvas.height === height) return true;
    // Setting a canvas's size clears it, so this is left until there is something to draw, which then is drawn again.
    this.#canvas.width = width;
    this.#canvas.height = height;
    this.#present();
    return true;
  }

  dispose(): void {
    this.#context.unconfigure();
    this.tracer.dispose();
  }

  #isDue(): boolean {
    const { samples, converged } = this.tracer.stats;
    if (samples < this.#samples) this.#drawnSamples = 0;
    this.#samples = samples;
    return !this.#isCalm || converged || samples >= 2 * this.#drawnSamples;
  }

  #present(): boolean {
    return this.tracer.present(this.#context, this.#look);
  }

  #toShow(): readonly object[] {
    return [this.tracer.camera, this.tracer.scene, this.#size];
  }

  #fitFilm(nowMs: number): void {
    const { tracer } = this;
    const before = this.#shown;
    this.#shown = this.#toShow();
    if (this.#shown.some((part, index) => part !== before[index])) this.#budget.noteChange(nowMs);
    const { width, height } = this.#budget.sizeFor(this.#size, tracer, tracer.stats.pathsPerSecond, nowMs);
    tracer.resize(width, height);
  }
}
