import { relativeError } from "../gpu/errorPass";
import type { Report } from "../gpu/readback";
import { Pace, pathsOf } from "./pace";
import type { Slice } from "./progress";
import { Rate } from "./rates";
import type { Settings } from "./settings";
import type { Stats } from "./stats";

/** Keeps the stats up to date, from what the device reports. */
export class Meter {
  readonly stats: Stats;
  /** How fast the adapter is, for sizing work. */
  readonly pace = new Pace();
  readonly #frameRate = new Rate();
  readonly #pathRate = new Rate();
  readonly #rayRate = new Rate();
  #presentedAt: number | undefined;
  /** When the device was last known to finish a submit. */
  #finishedAt = 0;

  constructor(adapter: string) {
    this.stats = {
      fps: 0,
      frameMs: 0,
      gpuMs: 0,
      samples: 0,
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
    this.stats.error = Number.POSITIVE_INFINITY;
    this.stats.badSamples = 0;
    this.updateConverged(settings);
  }

  updateConverged({ targetError, maxSamples }: Settings): void {
    const { error, samples } = this.stats;
    this.stats.converged = (targetError > 0 && error <= targetError) || samples >= maxSamples;
  }

  /** A frame is being presented. */
  countFrame(): void {
    const now = performance.now();
    if (this.#presentedAt !== undefined) this.#frameRate.observe(1, (now - this.#presentedAt) / 1000);
    this.#presentedAt = now;
    this.stats.fps = this.#frameRate.perSecond;
    this.stats.frameMs = this.stats.fps > 0 ? 1000 / this.stats.fps : 0;
  }

  /** Milliseconds since the device could begin a submit of `submittedAt`: it does one at a time, in order. */
  finishSubmit(submittedAt: number): number {
    const startedAt = Math.max(submittedAt, this.#finishedAt);
    this.#finishedAt = performance.now();
    return this.#finishedAt - startedAt;
  }

  /** Takes note of a finished slice, after which every pixel held `samples`. */
  observe(slice: Slice, width: number, samples: number, report: Report, wallMs: number): void {
    const { stats } = this;
    const ms = report.gpuMs ?? wallMs;
    this.pace.observe(slice, width, ms);
    this.#pathRate.observe(pathsOf(slice, width), ms / 1000);
    this.#rayRate.observe(report.rays, ms / 1000);
    stats.gpuMs = ms;
    stats.pathsPerSecond = this.#pathRate.perSecond;
    stats.raysPerSecond = this.#rayRate.perSecond;
    stats.samples = samples;
    stats.badSamples += report.badSamples;
    if (report.errorSums) stats.error = relativeError(report.errorSums);
  }
}
