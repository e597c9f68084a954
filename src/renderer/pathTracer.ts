import { needsGeometry } from "../compile/boundedShapes";
import { type CompiledScene, compileScene } from "../compile/compileScene";
import { linkModule } from "../compile/linkProgram";
import { RtViewerError } from "../errors";
import { adapterName, explainFailure, requestDevice } from "../gpu/device";
import { scoped } from "../gpu/errorScope";
import { checkFilmSize, type Film } from "../gpu/film";
import { createComputePipeline } from "../gpu/pipelines";
import type { SceneGeometry } from "../gpu/sceneGeometry";
import { TracePass } from "../gpu/tracePass";
import { parseCamera, parseScene } from "../scene/parseScene";
import type { Camera, ResolvedCamera, ResolvedScene, Scene } from "../scene/schema";
import { Accumulation, type Guard, type Portion, type SharedUniforms, type Surroundings } from "./accumulation";
import { type Bakeable, Baked, type IsQuicker } from "./baked";
import { type BuiltGeometry, buildGeometry } from "./buildGeometry";
import { cameraBasis, lampPixels, rayStart } from "./cameraBasis";
import { checkSettings } from "./checkSettings";
import { Display } from "./display";
import { firstPathsFor } from "./firstPathsFor";
import { InFlight } from "./inFlight";
import { Meter } from "./meter";
import { Pace } from "./pace";
import type { Picked, Picker, Sight } from "./picker";
import { createProgram, type Program, programKey } from "./program";
import { readPicture } from "./readPicture";
import { DEFAULT_SETTINGS, effectOfChange, type Settings, sampleLimit } from "./settings";
import type { Stats } from "./stats";
import type { View } from "./view";

/** What a tracer is made from. */
export type PathTracerOptions = {
  readonly scene: Scene;
  /** In pixels. */
  readonly width: number;
  readonly height: number;
  /** Used, never destroyed. Without one the tracer requests its own and destroys it with itself. */
  readonly device?: GPUDevice;
  readonly settings?: Partial<Settings>;
} & SceneOptions;

/** What somebody who shows a scene may want to know meanwhile. */
export type SceneOptions = {
  /** Told which share of a scene's geometry is sorted, from 0 to 1, where there is much of it. */
  readonly onProgress?: (fraction: number) => void;
  /** Ends the sorting, in a worker too; the promise is then rejected with its reason. A scene that was shown stays. */
  readonly signal?: AbortSignal;
};

/** A scene and where it is seen from. */
type Shown = { readonly scene: ResolvedScene; readonly camera: ResolvedCamera };

// Milliseconds of work in one submit: while a page renders, and while nobody watches.
const FRAME_BUDGET_MS = 12;
const BATCH_BUDGET_MS = 100;
// A scene that has not changed for this long, in milliseconds, or is to take this many samples at once, is worth compiling
// with its values as constants.
const REST_MS = 500;
const BAKE_SAMPLES = 16;
// Where a path has no more rays than this, a change of the scene's values alone can't make it so much longer that what is known
// of the pace would be dangerous.
const FEW_RAYS = 32;
// Pixels of the longer side where two programs are compared: enough to fill a GPU.
const COMPARED_SIDE = 512;

/**
 * Renders a scene progressively on a WebGPU device. It needs no canvas and no DOM.
 *
 * In a page, call `frame()` and `present()` once per animation frame. Elsewhere, `await sample(n)` and `readRadiance()`.
 */
export class PathTracer {
  /** Where it renders; the one that was given, or its own. */
  readonly device: GPUDevice;
  readonly #ownsDevice: boolean;
  readonly #inFlight: InFlight;
  readonly #meter: Meter;
  readonly #surroundings: Surroundings;
  #picker: Picker | undefined;

  #scene: ResolvedScene;
  #camera: ResolvedCamera;
  #settings: Settings;
  #compiled: CompiledScene;
  #program: Program;
  #geometry: SceneGeometry | undefined;
  #trace: TracePass;
  /** Stands in for program and trace while the scene rests. */
  readonly #baked: Baked;
  #accumulation: Accumulation;
  #display: Display | Promise<void> | undefined;

  /** The film must be cleared before the next sample, because what it shows has changed. */
  #stale = true;
  /** What will be shown once it is prepared and compiled, and that work; the newest only. */
  #pending: Shown | undefined;
  #installing: Promise<void> | undefined;
  /** Ends that work, for something newer. */
  #overtake = new AbortController();
  /** When the accumulation last started anew. */
  #restartedAt = 0;
  #failure: unknown;
  readonly #fail = (error: unknown): void => {
    this.#failure ??= error;
  };
  /**
   * Does GPU work. What the device says against it ends this tracer alone: a bug of ours, or a device out of memory. Calls are
   * not nested, so that errors come in the order of their causes.
   */
  readonly #guarded: Guard = (work) => {
    const { value, error } = scoped(this.device, work);
    void error.then((failure) => failure && this.#fail(failure));
    return value;
  };
  #disposed = false;
  /** What the pace was learned from: while it stays, so does the pace. */
  #paced: readonly unknown[] = [];
  /** The program whose values, as constants, made it no quicker. */
  #unbakeable: Program | undefined;

  /**
   * @throws {SceneError} with every issue, if the scene breaks the format.
   * @throws {UnsupportedError} if it holds something that can't be rendered yet, or the device has a limit below what it needs.
   * @throws {RtViewerError} if a setting can't be used.
   * @throws {WebGpuError} if there is no WebGPU or no adapter, or the device is out of memory.
   */
  static async create(options: PathTracerOptions): Promise<PathTracer> {
    const settings = { ...DEFAULT_SETTINGS, ...options.settings };
    const scene = parseScene(options.scene);
    checkSettings(settings, scene.maxBounces);
    const geometry = needsGeometry(scene) ? await buildGeometry(scene, options) : undefined;
    const compiled = compileScene(scene, settings, undefined, geometry?.source);
    const device = options.device ?? (await requestDevice());
    try {
      checkFilmSize(device, options.width, options.height);
      const [program, errorPipeline] = await Promise.all([
        createProgram(device, compiled),
        linkModule("error").then((code) => createComputePipeline(device, "error", code, "sumErrors")),
      ]);
      const { value: tracer, error } = scoped(
        device,
        () => new PathTracer(options, device, settings, scene, geometry, compiled, program, errorPipeline),
      );
      const failure = await error;
      if (failure === undefined) return tracer;
      tracer.dispose();
      throw failure;
    } catch (error) {
      if (!options.device) device.destroy();
      throw error;
    }
  }

  private constructor(
    { device: givenDevice, width, height }: PathTracerOptions,
    device: GPUDevice,
    settings: Settings,
    scene: ResolvedScene,
    geometry: BuiltGeometry | undefined,
    compiled: CompiledScene,
    program: Program,
    errorPipeline: GPUComputePipeline,
  ) {
    this.device = device;
    this.#ownsDevice = givenDevice === undefined;
    this.#settings = settings;
    this.#scene = scene;
    this.#camera = scene.camera;
    this.#compiled = compiled;
    this.#program = program;
    this.#geometry = geometry?.upload(device); // first: it throws where there is no room for it
    this.#inFlight = new InFlight(device);
    this.#meter = new Meter(adapterName(device));
    this.#meter.useProgram(program);
    const [inFlight, meter] = [this.#inFlight, this.#meter];
    this.#surroundings = { device, guard: this.#guarded, errorPipeline, inFlight, meter };
    this.#accumulation = new Accumulation(this.#surroundings, this.#sharedUniforms(width, height));
    this.#trace = this.#createTrace();
    this.#baked = new Baked(device);
  }

  /** Speed, error and what is compiled; one object, kept up to date. */
  get stats(): Readonly<Stats> {
    return this.#meter.stats;
  }

  /** What is shown, with every default filled in. */
  get scene(): ResolvedScene {
    return this.#scene;
  }

  /** From where it is shown: the scene's camera until another was set. */
  get camera(): ResolvedCamera {
    return this.#camera;
  }

  /** How it is sampled. */
  get settings(): Settings {
    return this.#settings;
  }

  /** Of the film, in pixels. */
  get width(): number {
    return this.#accumulation.film.width;
  }

  /** Of the film, in pixels. */
  get height(): number {
    return this.#accumulation.film.height;
  }

  /** The linked shader that runs now, and what it contains. */
  get program(): Pick<Program, "wgsl" | "features" | "compileSeconds"> {
    return this.#baked.program ?? this.#program;
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
    await this.#install({ scene: resolved, camera: resolved.camera }, options);
  }

  /** @throws {SceneError} The old camera stays. */
  setCamera(camera: Camera): void {
    const resolved = parseCamera(camera);
    if (this.#pending) this.#pending = { ...this.#pending, camera: resolved };
    if (JSON.stringify(resolved) === JSON.stringify(this.#camera)) return;
    this.#camera = resolved;
    this.#stale = true;
  }

  /**
   * In pixels, at least 1 × 1.
   *
   * @throws {UnsupportedError} if the device has a limit below what that needs. The old size stays.
   */
  resize(width: number, height: number): void {
    if (this.#disposed || (width === this.width && height === this.height)) return;
    checkFilmSize(this.device, width, height);
    this.#accumulation.dispose();
    this.#trace.dispose();
    this.#guarded(() => {
      this.#accumulation = new Accumulation(this.#surroundings, this.#sharedUniforms(width, height));
      this.#trace = this.#createTrace();
    });
    this.#restart();
  }

  /**
   * Changes settings. Accumulation restarts if the change matters to the image.
   *
   * @throws {RtViewerError} if one can't be used. All stay as they are.
   */
  update(settings: Partial<Settings>): void {
    const before = this.#settings;
    const next = { ...before, ...settings };
    checkSettings(next, (this.#pending ?? this).scene.maxBounces);
    this.#settings = next;
    this.#meter.updateConverged(this.#settings);
    const effect = effectOfChange(before, next);
    if (effect !== "none") this.#stale = true;
    // What is pending is compiled for the newest settings as it is.
    if (effect === "recompile" && !this.#pending)
      this.#install({ scene: this.#scene, camera: this.#camera }).catch(this.#fail);
  }

  /** Starts the accumulation anew. */
  reset(): void {
    this.#stale = true;
  }

  /**
   * Takes `count` more samples per pixel, fewer if `targetError` or `maxSamples` stops it. Resolves when the device is
   * done and `stats` are up to date.
   *
   * @throws {WebGpuError} if this or earlier work on the device failed.
   */
  async sample(count: number): Promise<void> {
    while (!this.#inFlight.isEmpty || this.#installing || this.#geometry?.filling) {
      await Promise.all([this.#inFlight.all(), this.#installing, this.#geometry?.filling]);
    }
    if (this.#disposed) return;
    if (this.#stale) this.#restart();
    if (count >= BAKE_SAMPLES) await this.compile();
    const end = Math.min(this.#accumulation.samples + count, sampleLimit(this.#settings));
    const isWanted = () => this.#accumulation.samples < end && !this.stats.converged;
    while (isWanted() && !this.#disposed && this.#failure === undefined) {
      const samples = Math.min(end - this.#accumulation.samples, this.#accumulation.allowedSamples(this.#settings));
      // The first work says how much is right for the next.
      const isBusy = this.#inFlight.isFull || !(this.#meter.pace.isKnown || this.#inFlight.isEmpty);
      if (samples > 0 && !isBusy) this.#work({ budgetMs: BATCH_BUDGET_MS, samples, end, isWatched: false });
      else if (!this.#inFlight.isEmpty) await this.#inFlight.any();
      else break; // maxSamples has come down
    }
    await this.#inFlight.all();
    if (this.#failure !== undefined) throw this.#failure;
  }

  /**
   * Compiles the program of a scene at rest now, instead of when it has rested or many samples are asked for. Resolves
   * when it is in use, or was found to be no quicker; the accumulation goes on.
   *
   * @throws {WebGpuError} if the device fails.
   */
  async compile(): Promise<void> {
    if (!this.#settings.constants || this.#disposed) return;
    if (this.#stale) this.#restart();
    if (this.#settings.constants === "auto" && this.#unbakeable === this.#program) return;
    try {
      await this.#baked.compile(this.#bakeable, this.#isQuicker);
    } catch (error) {
      throw await explainFailure(this.device, error);
    }
    if (this.#disposed) this.#baked.drop();
    else this.#meter.useProgram(this.program);
  }

  /**
   * Mean radiance at the moment of the call: RGBA, linear Rec. 709, alpha 1, top row first, `width · height · 4` values.
   *
   * @throws {RtViewerError} after `dispose()`.
   * @throws {WebGpuError} if the device fails, or is lost meanwhile.
   */
  async readRadiance(): Promise<Float32Array> {
    return this.#filmToRead().read();
  }

  /**
   * The picture at the moment of the call as `present` would show it: sRGB bytes, RGBA, top row first.
   *
   * @throws {RtViewerError} as `readRadiance` does, and if it has more pixels on a side than a texture of the device.
   */
  async readPicture(view: View = {}): Promise<Uint8ClampedArray> {
    return readPicture(this.device, this.#filmToRead(), view);
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
    if (this.#disposed) return undefined;
    this.#picker ??= new Picker(this.device);
    return this.#picker.pick(this.#sight, x, y);
  }

  /**
   * Submits about one animation frame's work, unless the device is still busy or nothing is left to do. Never waits.
   *
   * @returns whether work was submitted.
   * @throws {WebGpuError} if an earlier frame's work or a compilation failed.
   */
  frame(): boolean {
    if (this.#failure !== undefined) throw this.#failure;
    if (this.#disposed || this.#inFlight.isFull || this.#geometry?.filling) return false;
    // Finish the first pass of what is shown before following a moving camera, or a slow adapter would never show any.
    if (this.#stale && !this.#accumulation.isInFirstPass) this.#restart();
    const { samplesPerFrame } = this.#settings;
    const most = samplesPerFrame === "auto" ? Number.POSITIVE_INFINITY : samplesPerFrame;
    const samples = Math.min(most, this.#accumulation.allowedSamples(this.#settings));
    if (this.stats.converged || samples <= 0) return false;
    if (!this.#installing && performance.now() - this.#restartedAt > REST_MS) this.compile().catch(this.#fail);
    this.#work({ budgetMs: FRAME_BUDGET_MS, samples, end: sampleLimit(this.#settings), isWatched: true });
    return true;
  }

  /**
   * Draws the image on the context's current texture; nothing until there is a complete first sample, so that the canvas
   * keeps its last picture. The caller has configured the context with this tracer's `device`.
   *
   * @returns whether it drew.
   * @throws {UnsupportedError} if the canvas is larger than a texture of the device.
   */
  present(context: GPUCanvasContext, view: View = {}): boolean {
    if (this.#disposed || this.#accumulation.samples === 0) return false;
    this.#meter.countFrame();
    if (!(this.#display instanceof Display)) {
      this.#display ??= this.#createDisplay(context.getConfiguration()!.format).catch(this.#fail);
      return false;
    }
    const display = this.#display;
    this.#guarded(() => display.draw(this.#accumulation.film, context.getCurrentTexture(), view));
    return true;
  }

  /** Frees all GPU resources. Calling it again does nothing. */
  dispose(): void {
    if (this.#disposed) return;
    this.#disposed = true;
    this.#overtake.abort();
    this.#installing = this.#pending = undefined; // or sample() would wait for ever
    this.#trace.dispose();
    this.#geometry?.dispose();
    this.#baked.drop();
    this.#picker?.dispose();
    this.#inFlight.dispose();
    this.#accumulation.dispose();
    if (this.#display instanceof Display) this.#display.dispose();
    if (this.#ownsDevice) this.device.destroy();
  }

  async #createDisplay(format: GPUTextureFormat): Promise<void> {
    const display = await Display.create(this.device, format);
    if (this.#disposed) display.dispose();
    else this.#display = display;
  }

  #filmToRead(): Film {
    if (this.#disposed) throw new RtViewerError("the path tracer has been disposed of: it has no picture any more");
    return this.#accumulation.film;
  }

  /** Shows something else, once its geometry is sorted and a program that fits it is compiled. A newer call overtakes an older one. */
  async #install(next: Shown, options: SceneOptions = {}): Promise<void> {
    if (this.#disposed) return;
    this.#overtake.abort();
    this.#overtake = new AbortController();
    const { signal } = this.#overtake;
    this.#pending = next;
    const either = AbortSignal.any([signal, options.signal ?? signal]);
    const installing = this.#prepare(next.scene, { ...options, signal: either });
    this.#installing = installing.catch(() => undefined); // for those who only wait
    try {
      await installing;
    } catch (error) {
      if (!signal.aborted) throw error;
    } finally {
      if (!signal.aborted) this.#installing = this.#pending = undefined;
    }
  }

  /** In one go where nothing has to be sorted or compiled. */
  async #prepare(scene: ResolvedScene, options: SceneOptions & { readonly signal: AbortSignal }): Promise<void> {
    const previous = this.#geometry?.source;
    // Not even a turn of the event loop for scenes that have none.
    const geometry = needsGeometry(scene) ? await buildGeometry(scene, { previous, ...options }) : undefined;
    options.signal.throwIfAborted();
    let program = this.#program;
    for (;;) {
      const compiled = compileScene(scene, this.#settings, undefined, geometry?.source);
      if (program.key === programKey(compiled)) return this.#show(this.#pending!, geometry, compiled, program);
      program = await createProgram(this.device, compiled); // settings may change meanwhile
      options.signal.throwIfAborted();
    }
  }

  #show(
    { scene, camera }: Shown,
    geometry: BuiltGeometry | undefined,
    compiled: CompiledScene,
    program: Program,
  ): void {
    const previous = this.#geometry;
    const hasSameGeometry = geometry?.source === previous?.source;
    // First, because the device may have no room for it: then the old scene stays.
    const uploaded = hasSameGeometry ? previous : this.#guarded(() => geometry?.upload(this.device));
    this.#pending = undefined;
    this.#scene = scene;
    this.#camera = camera;
    this.#compiled = compiled;
    this.#stale = true;
    if (program === this.#program && hasSameGeometry) return;
    if (!hasSameGeometry) previous?.dispose();
    this.#geometry = uploaded;
    this.#program = program;
    this.#trace.dispose();
    this.#trace = this.#guarded(() => this.#createTrace());
    this.#restart();
  }

  readonly #sight = (): Sight => {
    const { scene, camera, width, height } = this;
    return { scene, camera, width, height, compiled: this.#compiled, geometry: this.#geometry };
  };

  get #bakeable(): Bakeable {
    return { geometry: this.#geometry, film: this.#accumulation.film, bake: () => this.#compiled.atRest(this.#camera) };
  }

  #createTrace(): TracePass {
    const { pipelines } = this.#program;
    const [scene, geometry, { film }] = [this.#compiled.uniform, this.#geometry, this.#accumulation];
    return new TracePass(this.device, { pipelines, scene, geometry, film });
  }

  /** Whether a program with the scene's values as constants is to take the place of the one that runs. */
  readonly #isQuicker: IsQuicker = async (program, compiled, isWanted) => {
    if (this.#settings.constants !== "auto") return true;
    const { compareTraces } = await import("./compareTraces");
    if (!isWanted()) return false;
    const general = this.#program;
    const contenders = [
      { program: general, compiled: this.#compiled },
      { program, compiled },
    ] as const;
    const scale = Math.min(1, COMPARED_SIDE / Math.max(this.width, this.height));
    const shared = this.#sharedUniforms(Math.ceil(scale * this.width), Math.ceil(scale * this.height));
    const { pace } = this.#meter;
    const ratio = await compareTraces(this.device, { contenders, geometry: this.#geometry, shared, pace, isWanted });
    if (ratio !== undefined && ratio > 1) this.#unbakeable = general;
    return ratio !== undefined && ratio <= 1;
  };

  #restart(): void {
    this.#stale = false;
    this.#restartedAt = performance.now();
    const shared = this.#sharedUniforms(this.width, this.height);
    this.#startPace(shared);
    this.#guarded(() => {
      this.#trace.writeScene(this.#compiled.uniform);
      if (this.#settings.constants) this.#baked.change(this.#bakeable);
      else this.#baked.drop();
    });
    this.#meter.useProgram(this.program);
    this.#accumulation.restart(shared, this.#settings);
  }

  /** Forgets what the pace was, unless what was measured still tells of what is shown now. */
  #startPace({ maxBounces, lightSamples }: SharedUniforms): void {
    const [compiled, program, geometry] = [this.#compiled, this.#program, this.#geometry];
    const mayGrowLong = (maxBounces + 1) * (lightSamples + 1) > FEW_RAYS;
    const paced = [program, geometry, maxBounces, lightSamples, mayGrowLong && compiled];
    if (paced.every((part, i) => part === this.#paced[i])) return;
    this.#paced = paced;
    this.#meter.pace = new Pace(firstPathsFor(compiled, geometry?.source, maxBounces, lightSamples));
  }

  #work(portion: Portion): void {
    const trace = this.#baked.trace ?? this.#trace;
    this.#accumulation.work(trace, portion, () => this.#settings).catch(this.#fail);
  }

  /** What the dispatches of one accumulation have in common, on a film of this size. */
  #sharedUniforms(width: number, height: number): SharedUniforms {
    const { seed, lightSamples, maxBounces = this.#scene.maxBounces } = this.#settings;
    const { origin, unit, shapes, lamps: emissive } = this.#compiled;
    const basis = cameraBasis(this.#camera, origin, width / height, unit);
    const view = rayStart(basis, shapes);
    const lamps = lampPixels(emissive, basis, width, height);
    return { ...view, ...lamps, size: [width, height], seed, maxBounces, lightSamples };
  }
}
