import { relativeError } from "../gpu/errorPass";
import type { Report } from "../gpu/readback";
import { Pace, pathsOf } from "./pace";
import type { Slice } from "./progress";
import { Rate } from "./rates";
import { type Settings, sampleLimit } from "./settings";
import type { Stats } from "./stats";

// Presented this soon again, it is the same frame.
const SAME_FRAME_MS = 1;
// Share of a slice's time by which one may be early to ask whether it is done.
const EARLY = 0.1;

/** A slice under way. Times as of `performance.now()`. */
export type Submit = {
  readonly at: number;
  /** How long it should take. */
  readonly ms: number;
  /** When to begin asking whether it is done. */
  readonly wakeAt: number;
};

/** Keeps the stats up to date, from what the device reports. */
export class Meter {
  readonly stats: Stats;
  /** How fast the adapter is, for sizing work. */
  readonly pace = new Pace();
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

  /** A slice is submitted. The device does one at a time, in order. */
  submit(slice: Slice, width: number): Submit {
    const at = performance.now();
    const ms = this.pace.predictMs(slice, width);
    this.#queuedMs += ms;
    this.#freeAt = Math.max(at, this.#freeAt) + ms;
    return { at, ms, wakeAt: this.#freeAt - EARLY * ms };
  }

  /** It is done. Returns the milliseconds since the device could begin with it. */
  finish({ at, ms }: Submit): number {
    const startedAt = Math.max(at, this.#finishedAt);
    this.#finishedAt = performance.now();
    this.#queuedMs -= ms;
    this.#freeAt = this.#finishedAt + this.#queuedMs;
    return this.#finishedAt - startedAt;
  }

  /** Takes note of how fast the device did a slice of a film of this width. */
  observe(slice: Slice, width: number, { gpuMs, rays }: Report, wallMs: number): void {
    const { stats } = this;
    const ms = gpuMs ?? wallMs;
    this.pace.observe(slice, width, ms);
    this.#pathRate.observe(pathsOf(slice, width), ms / 1000);
    this.#rayRate.observe(rays, ms / 1000);
    stats.gpuMs = ms;
    stats.pathsPerSecond = this.#pathRate.perSecond;
    stats.raysPerSecond = this.#rayRate.perSecond;
  }

  /** Takes note of what the slice last observed added to the film, after which every pixel held `samples`. */
  count(samples: number, { badSamples, errorSums }: Report): void {
    const { stats } = this;
    stats.samples = samples;
    stats.seconds += stats.gpuMs / 1000;
    stats.badSamples += badSamples;
    if (errorSums) stats.error = relativeError(errorSums);
  }
}
