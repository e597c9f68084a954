import { WebGpuError } from "../errors";
import type { PathTracer } from "../renderer/pathTracer";
import type { PixelSize } from "./canvasSize";

/** One tracer that draws into one canvas, and owns both the tracer and the canvas's connection to the GPU. */
export class CanvasView {
  readonly tracer: PathTracer;
  readonly #canvas: HTMLCanvasElement;
  readonly #context: GPUCanvasContext;
  #exposure = 0;
  /** The canvas does not show what it would show if the film were drawn now. */
  #isStale = true;

  /** @throws {WebGpuError} if the canvas has been given to another kind of context. */
  constructor(tracer: PathTracer, canvas: HTMLCanvasElement) {
    const context = canvas.getContext("webgpu") as GPUCanvasContext | null;
    if (context === null) throw new WebGpuError("The canvas gives no WebGPU context.");
    this.tracer = tracer;
    this.#canvas = canvas;
    this.#context = context;
    context.configure({
      device: tracer.device,
      format: navigator.gpu.getPreferredCanvasFormat(),
      alphaMode: "opaque",
    });
  }

  /** Brightness in stops. */
  set exposure(stops: number) {
    this.#isStale ||= stops !== this.#exposure;
    this.#exposure = stops;
  }

  /** In physical pixels. The canvas itself follows with the next picture, so that none is lost meanwhile. */
  resize({ width, height }: PixelSize): void {
    this.tracer.resize(width, height);
  }

  /** Shows the film again, though it may not have changed; after the canvas was moved, say. */
  refresh(): void {
    this.#isStale = true;
  }

  /**
   * Does the work of one frame.
   *
   * @returns whether the canvas shows something new.
   * @throws {WebGpuError} if earlier work on the GPU failed.
   */
  draw(): boolean {
    const { tracer } = this;
    if (tracer.frame()) this.#isStale = true;
    // Until its first sample is complete the film has nothing to show, and the canvas keeps its last picture.
    if (!this.#isStale || tracer.stats.samples === 0) return false;
    this.#fitCanvas();
    if (!tracer.present(this.#context, { exposure: this.#exposure })) return false;
    this.#isStale = false;
    return true;
  }

  dispose(): void {
    this.#context.unconfigure();
    this.tracer.dispose();
  }

  /** Setting a canvas's size clears it, so this is left until right before it is drawn to. */
  #fitCanvas(): void {
    const { width, height } = this.tracer;
    if (this.#canvas.width !== width) this.#canvas.width = width;
    if (this.#canvas.height !== height) this.#canvas.height = height;
  }
}
