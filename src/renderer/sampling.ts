import type { Film } from "../gpu/film";
import { Accumulation, type Portion, type Surroundings } from "./accumulation";
import type { DeviceGuard } from "./deviceGuard";
import { firstPathsFor } from "./firstPathsFor";
import { InFlight } from "./inFlight";
import type { Installation } from "./installation";
import type { Meter } from "./meter";
import { Pace } from "./pace";
import type { Program } from "./program";
import { ScenePasses } from "./scenePasses";
import { type Settings, sampleLimit } from "./settings";
import { type SharedUniforms, sharedUniforms } from "./sharedUniforms";

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

type SamplingOptions = {
  readonly guard: DeviceGuard;
  readonly installation: Installation;
  readonly meter: Meter;
  readonly errorPipeline: GPUComputePipeline;
  /** Asked whenever they matter. */
  readonly settings: () => Settings;
  /** Of the film, in pixels. */
  readonly width: number;
  readonly height: number;
};

/** Takes samples of what is installed: when, how many at a time, and by which pass. */
export class Sampling {
  readonly #guard: DeviceGuard;
  readonly #installation: Installation;
  readonly #settings: () => Settings;
  readonly #meter: Meter;
  readonly #inFlight: InFlight;
  readonly #surroundings: Surroundings;
  readonly #passes: ScenePasses;
  #accumulation: Accumulation;
  /** The film must be cleared before the next sample, because what it shows has changed. */
  #isStale = true;
  /** When the accumulation last started anew. */
  #restartedAt = 0;
  /** What the pace was learned from: while it stays, so does the pace. */
  #paced: readonly unknown[] = [];
  #isDisposed = false;

  /** Inside of an error scope. */
  constructor({ guard, installation, meter, errorPipeline, settings, width, height }: SamplingOptions) {
    const { device } = guard;
    this.#guard = guard;
    this.#installation = installation;
    this.#settings = settings;
    this.#meter = meter;
    this.#inFlight = new InFlight(device);
    this.#surroundings = { guard, errorPipeline, inFlight: this.#inFlight, meter };
    this.#accumulation = new Accumulation(this.#surroundings, this.#uniforms(width, height));
    this.#passes = new ScenePasses({ device, shown: () => installation.shown, settings }, this.film);
    meter.useProgram(this.program);
  }

  get film(): Film {
    return this.#accumulation.film;
  }

  /** Samples per pixel in it, complete ones only. */
  get samples(): number {
    return this.#accumulation.samples;
  }

  /** What runs now. */
  get program(): Program {
    return this.#passes.program;
  }

  /** Starts the accumulation anew, before the next sample. */
  reset(): void {
    this.#isStale = true;
  }

  /** The same at once, by other passes, for another program or geometry. */
  rebuild(): void {
    this.#guard.run(() => this.#passes.rebuild());
    this.#restart();
  }

  /** The same on another film. */
  resize(width: number, height: number): void {
    this.#accumulation.dispose();
    this.#guard.run(() => {
      this.#accumulation = new Accumulation(this.#surroundings, this.#uniforms(width, height));
      this.#passes.rebuild(this.film);
    });
    this.#restart();
  }

  /** See `PathTracer.sample`. */
  async sample(count: number): Promise<void> {
    await this.#settle();
    if (this.#isDisposed) return;
    if (this.#isStale) this.#restart();
    if (count >= BAKE_SAMPLES) await this.compile();
    const end = Math.min(this.samples + count, sampleLimit(this.#settings()));
    const isWanted = () => this.samples < end && !this.#meter.stats.converged;
    while (isWanted() && !this.#isDisposed && !this.#guard.hasFailed) {
      const samples = Math.min(end - this.samples, this.#accumulation.allowedSamples(this.#settings()));
      // The first work says how much is right for the next.
      const isBusy = this.#inFlight.isFull || !(this.#meter.pace.isKnown || this.#inFlight.isEmpty);
      if (samples > 0 && !isBusy) this.#work({ budgetMs: BATCH_BUDGET_MS, samples, end, isWatched: false });
      else if (!this.#inFlight.isEmpty) await this.#inFlight.any();
      else break; // maxSamples has come down
    }
    await this.#inFlight.all();
    this.#guard.throwFailure();
  }

  /** See `PathTracer.frame`. */
  frame(): boolean {
    const { installing, shown } = this.#installation;
    if (this.#inFlight.isFull || shown.geometry?.filling) return false;
    // Finish the first pass of what is shown before following a moving camera, or a slow adapter would never show any.
    if (this.#isStale && !this.#accumulation.isInFirstPass) this.#restart();
    const settings = this.#settings();
    const most = settings.samplesPerFrame === "auto" ? Number.POSITIVE_INFINITY : settings.samplesPerFrame;
    const samples = Math.min(most, this.#accumulation.allowedSamples(settings));
    if (this.#meter.stats.converged || samples <= 0) return false;
    if (!installing && performance.now() - this.#restartedAt > REST_MS) this.compile().catch(this.#guard.fail);
    this.#work({ budgetMs: FRAME_BUDGET_MS, samples, end: sampleLimit(settings), isWatched: true });
    return true;
  }

  /** See `PathTracer.compile`. */
  async compile(): Promise<void> {
    if (!this.#settings().constants || this.#isDisposed) return;
    if (this.#isStale) this.#restart();
    await this.#passes.bake(() => this.#meter.pace);
    if (!this.#isDisposed) this.#meter.useProgram(this.program);
  }

  dispose(): void {
    this.#isDisposed = true;
    this.#passes.dispose();
    this.#inFlight.dispose();
    this.#accumulation.dispose();
  }

  /** Waits until nothing is under way: no samples, no other scene. */
  async #settle(): Promise<void> {
    const [inFlight, installation] = [this.#inFlight, this.#installation];
    const filling = () => installation.shown.geometry?.filling;
    while (!inFlight.isEmpty || installation.installing || filling()) {
      await Promise.all([inFlight.all(), installation.installing, filling()]);
    }
  }

  #restart(): void {
    this.#isStale = false;
    this.#restartedAt = performance.now();
    const uniforms = this.#uniforms(this.film.width, this.film.height);
    this.#startPace(uniforms);
    this.#guard.run(() => this.#passes.update());
    this.#meter.useProgram(this.program);
    this.#accumulation.restart(uniforms, this.#settings());
  }

  /** Forgets what the pace was, unless what was measured still tells of what is shown now. */
  #startPace({ maxBounces, lightSamples }: SharedUniforms): void {
    const { compiled, program, geometry } = this.#installation.shown;
    const mayGrowLong = (maxBounces + 1) * (lightSamples + 1) > FEW_RAYS;
    const paced = [program, geometry, maxBounces, lightSamples, mayGrowLong && compiled];
    if (paced.every((part, i) => part === this.#paced[i])) return;
    this.#paced = paced;
    this.#meter.pace = new Pace(firstPathsFor(compiled, geometry?.source, maxBounces, lightSamples));
  }

  #work(portion: Portion): void {
    this.#accumulation.work(this.#passes.trace, portion, this.#settings).catch(this.#guard.fail);
  }

  #uniforms(width: number, height: number): SharedUniforms {
    return sharedUniforms(this.#installation.shown, this.#settings(), width, height);
  }
}
