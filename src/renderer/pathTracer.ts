import { RtViewerError } from "../errors";
import { adapterName } from "../gpu/device";
import { scoped } from "../gpu/errorScope";
import { checkFilmSize, type Film } from "../gpu/film";
import { parseCamera, parseScene } from "../scene/parseScene";
import type { Camera, ResolvedCamera, ResolvedScene, Scene } from "../scene/schema";
import { checkSettings } from "./checkSettings";
import type { DeviceGuard } from "./deviceGuard";
import { Installation, type SceneOptions } from "./installation";
import { Meter } from "./meter";
import type { Picked, Picker, Sight } from "./picker";
import { Presenter } from "./presenter";
import type { Program } from "./program";
import { readPicture } from "./readPicture";
import { Sampling } from "./sampling";
import { effectOfChange, type Settings } from "./settings";
import type { Stats } from "./stats";
import { createParts, type PathTracerOptions, type TracerParts } from "./tracerParts";
import type { View } from "./view";

export type { PathTracerOptions, SceneOptions };

/**
 * Renders a scene progressively on a WebGPU device. It needs no canvas and no DOM.
 *
 * In a page, call `frame()` and `present()` once per animation frame. Elsewhere, `await sample(n)` and `readRadiance()`.
 */
export class PathTracer {
  /** Where it renders; the one that was given, or its own. */
  readonly device: GPUDevice;
  readonly #guard: DeviceGuard;
  readonly #installation: Installation;
  readonly #meter: Meter;
  readonly #sampling: Sampling;
  readonly #presenter: Presenter;
  #picker: Picker | undefined;
  #settings: Settings;
  #isDisposed = false;

  /**
   * @throws {SceneError} with every issue, if the scene breaks the format.
   * @throws {UnsupportedError} if it holds something that can't be rendered yet, or the device has a limit below what it needs.
   * @throws {RtViewerError} if a setting can't be used.
   * @throws {WebGpuError} if there is no WebGPU or no adapter, or the device is out of memory.
   */
  static async create(options: PathTracerOptions): Promise<PathTracer> {
    const parts = await createParts(options);
    const { guard } = parts;
    try {
      const { value: tracer, error } = scoped(guard.device, () => new PathTracer(parts));
      const failure = await error;
      if (failure === undefined) return tracer;
      tracer.dispose();
      throw failure;
    } catch (error) {
      guard.dispose();
      throw error;
    }
  }

  private constructor({ guard, settings: initial, first, ...film }: TracerParts) {
    this.device = guard.device;
    this.#guard = guard;
    this.#settings = initial;
    const settings = () => this.#settings;
    const onChange = (needsPasses: boolean) => (needsPasses ? this.#sampling.rebuild() : this.#sampling.reset());
    const installation = new Installation({ guard, first, settings, onChange });
    const meter = new Meter(adapterName(guard.device));
    this.#installation = installation;
    this.#meter = meter;
    this.#sampling = new Sampling({ guard, installation, meter, settings, ...film });
    this.#presenter = new Presenter(guard);
  }

  /** Speed, error and what is compiled; one object, kept up to date. */
  get stats(): Readonly<Stats> {
    return this.#meter.stats;
  }

  /** What is shown, with every default filled in. */
  get scene(): ResolvedScene {
    return this.#installation.shown.scene;
  }

  /** From where it is shown: the scene's camera until another was set. */
  get camera(): ResolvedCamera {
    return this.#installation.shown.camera;
  }

  /** How it is sampled. */
  get settings(): Settings {
    return this.#settings;
  }

  /** Of the film, in pixels. */
  get width(): number {
    return this.#sampling.film.width;
  }

  /** Of the film, in pixels. */
  get height(): number {
    return this.#sampling.film.height;
  }

  /** The linked shader that runs now, and what it contains. */
  get program(): Pick<Program, "wgsl" | "features" | "compileSeconds"> {
    return this.#sampling.program;
  }

  /**
   * Shows another scene, or the same with other values. Compiles only if the shader has to change, and renders the old
   * scene until that is done.
   *
   * @throws {SceneError | UnsupportedError} The old scene stays.
   * @throws {RtViewerError} if the settings can't be used with it.
   */
  async setScene(scene: Scene, options: SceneOptions = {}): Promise<void> {
    const resolved = parseScene(scene);
    checkSettings(this.#settings, resolved.maxBounces);
    await this.#installation.install(resolved, options);
  }

  /** @throws {SceneError} The old camera stays. */
  setCamera(camera: Camera): void {
    this.#installation.setCamera(parseCamera(camera));
  }

  /**
   * In pixels, at least 1 × 1.
   *
   * @throws {UnsupportedError} if the device has a limit below what that needs. The old size stays.
   */
  resize(width: number, height: number): void {
    if (this.#isDisposed || (width === this.width && height === this.height)) return;
    checkFilmSize(this.device, width, height);
    this.#sampling.resize(width, height);
  }

  /**
   * Changes settings. Accumulation restarts if the change matters to the image.
   *
   * @throws {RtViewerError} if one can't be used. All stay as they are.
   */
  update(settings: Partial<Settings>): void {
    const before = this.#settings;
    const next = { ...before, ...settings };
    checkSettings(next, this.#installation.nextScene.maxBounces);
    this.#settings = next;
    this.#meter.updateConverged(next);
    const effect = effectOfChange(before, next);
    if (effect !== "none") this.#sampling.reset();
    if (effect === "recompile") this.#installation.recompile().catch(this.#guard.fail);
  }

  /** Starts the accumulation anew. */
  reset(): void {
    this.#sampling.reset();
  }

  /**
   * Takes `count` more samples per pixel, fewer if `targetError` or `maxSamples` stops it. Resolves when the device is
   * done and `stats` are up to date.
   *
   * @throws {WebGpuError} if this or earlier work on the device failed.
   */
  async sample(count: number): Promise<void> {
    await this.#sampling.sample(count);
  }

  /**
   * Compiles the program of a scene at rest now, instead of when it has rested or many samples are asked for. Resolves
   * when it is in use, or was found to be no quicker; the accumulation goes on.
   *
   * @throws {WebGpuError} if the device fails.
   */
  async compile(): Promise<void> {
    await this.#sampling.compile();
  }

  /**
   * Mean radiance at the moment of the call: RGBA, linear Rec. 709, alpha 1, top row first, `width · height · 4` values.
   *
   * @throws {RtViewerError} after `dispose()`.
   * @throws {WebGpuError} if the device fails, or is lost meanwhile.
   */
  async readRadiance(): Promise<Float32Array> {
    return this.#filmToRead.read();
  }

  /**
   * The picture at the moment of the call as `present` would show it: sRGB bytes, RGBA, top row first.
   *
   * @throws {RtViewerError} as `readRadiance` does, and if it has more pixels on a side than a texture of the device.
   */
  async readPicture(view: View = {}): Promise<Uint8ClampedArray> {
    return readPicture(this.device, this.#filmToRead, view);
  }

  /**
   * Finds what is seen at a point of the picture, by one ray through it. The first call compiles what that takes.
   *
   * @param x - in pixels from the left edge; the middle of the first pixel is 0.5.
   * @param y - from the upper edge.
   * @returns `undefined` where there is nothing, outside of the picture, and after `dispose()`.
   * @throws {WebGpuError} if the device fails.
   */
  async pick(x: number, y: number): Promise<Picked | undefined> {
    const { Picker } = await import("./picker");
    if (this.#isDisposed) return undefined;
    this.#picker ??= new Picker(this.device);
    return this.#picker.pick(() => this.#sight, x, y);
  }

  /**
   * Submits about one animation frame's work, unless the device is still busy or nothing is left to do. Never waits.
   *
   * @returns whether work was submitted.
   * @throws {WebGpuError} if an earlier frame's work or a compilation failed.
   */
  frame(): boolean {
    this.#guard.throwFailure();
    return !this.#isDisposed && this.#sampling.frame();
  }

  /**
   * Draws the image on the context's current texture; nothing until there is a complete first sample, so that the canvas
   * keeps its last picture. The caller has configured the context with this tracer's `device`.
   *
   * @returns whether it drew.
   * @throws {UnsupportedError} if the canvas is larger than a texture of the device.
   */
  present(context: GPUCanvasContext, view: View = {}): boolean {
    if (this.#isDisposed || this.#sampling.samples === 0) return false;
    this.#meter.countFrame();
    return this.#presenter.present(this.#sampling.film, context, view);
  }

  /** Frees all GPU resources. Calling it again does nothing. */
  dispose(): void {
    if (this.#isDisposed) return;
    this.#isDisposed = true;
    this.#installation.dispose();
    this.#sampling.dispose();
    this.#picker?.dispose();
    this.#presenter.dispose();
    this.#guard.dispose();
  }

  get #filmToRead(): Film {
    if (this.#isDisposed) throw new RtViewerError("the path tracer has been disposed of: it has no picture any more");
    return this.#sampling.film;
  }

  get #sight(): Sight {
    return { ...this.#installation.shown, width: this.width, height: this.height };
  }
}
