import { relativeError } from "../gpu/errorPass";
import type { Report } from "../gpu/readback";
import { Pace } from "./pace";
import { Rate } from "./rate";
import { type Settings, sampleLimit } from "./settings";
import type { Stats } from "./stats";

// Presented this soon again, it is the same frame.
const SAME_FRAME_MS = 1;
// Share of a submit's time by which one may be early to ask whether it is done.
const EARLY = 0.1;

/** Work under way. Times as of `performance.now()`. */
export type Submit = {
  readonly paths: number;
  /** Whatever else comes meanwhile, this is what it tells about. */
  readonly pace: Pace;
  readonly at: number;
  /** How long it should take. */
  readonly ms: number;
  /** When to begin asking whether it is done. */
  readonly wakeAt: number;
};

/** Keeps the stats up to date, from what the device reports. */
export class Meter {
  readonly stats: Stats;
  /** How fast the adapter runs what is shown now, for sizing work; another one when something else is shown. */
  pace = new Pace(1);
  readonly #frameRate = new Rate();
  readonly #pathRate = new Rate();
  readonly #rayRate = new Rate();
  #presentedAt: number | undefined;
  /** When the device was last known to finish a submit, how long all others should take, and when it should be done. */
  #finishedAt = 0;
  #queuedMs = 0;
  #freeAt = 0;

  constructor(adapter: string) {
    this.stats = {
      fps: 0,
      frameMs: 0,
      gpuMs: 0,
      samples: 0,
      seconds: 0,
      pathsPerSecond: 0,
      raysPerSecond: 0,
      error: Number.POSITIVE_INFINITY,
      badSamples: 0,
      compileSeconds: 0,
      converged: false,
      adapter,
      features: [],
    };
  }

  /** What runs from now on. */
  useProgram({ compileSeconds, features }: Pick<Stats, "compileSeconds" | "features">): void {
    this.stats.compileSeconds = compileSeconds;
    this.stats.features = features;
  }

  /** The film is empty again. */
  restart(settings: Settings): void {
    this.stats.samples = 0;
    this.stats.seconds = 0;
    this.stats.error = Number.POSITIVE_INFINITY;
    this.stats.badSamples = 0;
    this.updateConverged(settings);
  }

  updateConverged(settings: Settings): void {
    const { error, samples } = this.stats;
    const { targetError } = settings;
    this.stats.converged = (targetError > 0 && error <= targetError) || samples >= sampleLimit(settings);
  }

  /** A frame is being presented. */
  countFrame(): void {
    const now = performance.now();
    if (this.#presentedAt !== undefined && now - this.#presentedAt < SAME_FRAME_MS) return;
    if (this.#presentedAt !== undefined) this.#frameRate.observe(1, (now - this.#presentedAt) / 1000);
    this.#presentedAt = now;
    this.stats.fps = this.#frameRate.perSecond;
    this.stats.frameMs = this.stats.fps > 0 ? 1000 / this.stats.fps : 0;
  }

  /** Work is submitted. The device does one submit at a time, in order. */
  submit(paths: number): Submit {
    const at = performance.now();
    const ms = this.pace.predictMs(paths);
    this.#queuedMs += ms;
    this.#freeAt = Math.max(at, this.#freeAt) + ms;
    return { paths, pace: this.pace, at, ms, wakeAt: this.#freeAt - EARLY * ms };
  }

  /** It is done: takes note of how fast the device did it, by GPU time where that is known, else by the clock. */
  finish({ paths, pace, at, ms: predictedMs }: Submit, { gpuMs, rays }: Report): void {
    const startedAt = Math.max(at, this.#finishedAt);
    this.#finishedAt = performance.now();
    this.#queuedMs -= predictedMs;
    this.#freeAt = this.#finishedAt + this.#queuedMs;
    const ms = gpuMs ?? this.#finishedAt - startedAt;
    pace.observe(paths, ms);
    this.#pathRate.observe(paths, ms / 1000);
    this.#rayRate.observe(rays, ms / 1000);
    const { stats } = this;
    stats.gpuMs = ms;
    stats.pathsPerSecond = this.#pathRate.perSecond;
    stats.raysPerSecond = this.#rayRate.perSecond;
  }

  /** Takes note of what the work last observed added to the film, after which every pixel held `samples`. */
  count(samples: number, { badSamples, errorSums }: Report): void {
    const { stats } = this;
    stats.samples = samples;
    stats.seconds += stats.gpuMs / 1000;
    stats.badSamples += badSamples;
    if (errorSums) stats.error = relativeError(errorSums);
  }
}
