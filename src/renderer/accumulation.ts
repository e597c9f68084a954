import { ErrorPass } from "../gpu/errorPass";
import { Film } from "../gpu/film";
import type { TracePass } from "../gpu/tracePass";
import type { DeviceGuard } from "./deviceGuard";
import { ErrorChecks } from "./errorChecks";
import type { InFlight } from "./inFlight";
import type { Meter } from "./meter";
import { Schedule } from "./schedule";
import { type Settings, sampleLimit } from "./settings";
import type { SharedUniforms } from "./sharedUniforms";
import { takeSlices } from "./takeSlices";

/** How much one submit may do. */
export type Portion = {
  /** Milliseconds of the device's work. */
  readonly budgetMs: number;
  /** Samples per pixel, at most. */
  readonly samples: number;
  /** Samples per pixel of the whole picture after which its error is wanted in any case. */
  readonly end: number;
  /** See `WorkLimits`. */
  readonly isWatched: boolean;
};

/** What an accumulation works with; all of it outlives it. */
export type Surroundings = {
  readonly guard: DeviceGuard;
  readonly errorPipeline: GPUComputePipeline;
  readonly inFlight: InFlight;
  readonly meter: Meter;
};

/** The samples of one picture: the film, what it holds, what comes next, and how wrong it is. */
export class Accumulation {
  readonly film: Film;
  readonly #guard: DeviceGuard;
  readonly #errorPass: ErrorPass;
  readonly #inFlight: InFlight;
  readonly #meter: Meter;
  /** Taken when it starts, so that a pass is of one piece whatever changes meanwhile. */
  #shared: SharedUniforms;
  #schedule: Schedule;
  #checks = new ErrorChecks();
  #isDisposed = false;

  /**
   * Inside of an error scope: whoever needs it is told if it can't be made.
   *
   * @param shared - of the film's size.
   */
  constructor({ guard, errorPipeline, inFlight, meter }: Surroundings, shared: SharedUniforms) {
    const [width, height] = [shared.size[0]!, shared.size[1]!];
    this.film = new Film(guard.device, width, height);
    this.#errorPass = new ErrorPass(guard.device, errorPipeline, this.film);
    this.#guard = guard;
    this.#inFlight = inFlight;
    this.#meter = meter;
    this.#shared = shared;
    this.#schedule = new Schedule(width, height);
  }

  /** Samples per pixel that have been submitted, complete passes only. */
  get samples(): number {
    return this.#schedule.samples;
  }

  /** Whether the first pass is under way. */
  get isInFirstPass(): boolean {
    return this.samples === 0 && !this.#schedule.isComplete;
  }

  /** Empties the film, for another picture of the same size. */
  restart(shared: SharedUniforms, settings: Settings): void {
    this.#shared = shared;
    this.#schedule = new Schedule(this.film.width, this.film.height);
    this.#checks = new ErrorChecks();
    this.#meter.restart(settings);
    this.#guard.run(() => {
      const encoder = this.#guard.device.createCommandEncoder({ label: "restart" });
      this.film.clear(encoder);
      this.#guard.device.queue.submit([encoder.finish()]);
    });
  }

  /** Samples per pixel that may be taken now. */
  allowedSamples(settings: Settings): number {
    const allowed = this.#checks.allowedSamples(this.samples, settings.targetError);
    return Math.min(sampleLimit(settings), allowed) - this.samples;
  }

  /**
   * Submits work. There must be a free readback.
   *
   * @param settings - asked again when the work is done.
   * @returns resolves when the device is done with it and the stats are up to date.
   */
  work(trace: TracePass, { budgetMs, samples, end, isWatched }: Portion, settings: () => Settings): Promise<void> {
    const readback = this.#inFlight.freeReadback;
    const schedule = this.#schedule;
    const checks = this.#checks;
    const { pace } = this.#meter;
    const limits = { paths: pace.pathsFor(budgetMs), samples, dispatchSamples: pace.dispatchSamples, isWatched };
    const slices = takeSlices(schedule, limits);
    const taken = schedule.samples;
    const wantsError = checks.ask(taken, settings().targetError, taken >= end, performance.now());

    this.#guard.run(() => {
      const encoder = this.#guard.device.createCommandEncoder({ label: "sample" });
      const frames = slices.map((slice) => ({ ...this.#shared, ...slice }));
      trace.encode(encoder, frames, readback.timestampWrites);
      if (wantsError) this.#errorPass.encode(encoder);
      readback.encode(encoder, this.film, wantsError ? this.#errorPass : undefined);
      this.#guard.device.queue.submit([encoder.finish()]);
    });

    const submit = this.#meter.submit(slices.reduce((sum, { paths }) => sum + paths, 0));
    return this.#inFlight.add(readback, submit.wakeAt - submit.at, wantsError, (report) => {
      this.#meter.finish(submit, report);
      if (schedule !== this.#schedule || this.#isDisposed) return; // what it added is gone
      if (wantsError) checks.report(taken);
      this.#meter.count(taken, report);
      this.#meter.updateConverged(settings());
    });
  }

  dispose(): void {
    this.#isDisposed = true;
    this.#errorPass.dispose();
    this.film.dispose();
  }
}
