import { MAX_DISPATCHES } from "../gpu/tracePass";
import type { Schedule, Slice } from "./schedule";

/** How much work one submit may have. */
export type WorkLimits = {
  /** Camera paths; one strip's are taken in any case. */
  readonly paths: number;
  /** Samples per pixel. */
  readonly samples: number;
  /** Samples per pixel in one dispatch. */
  readonly dispatchSamples: number;
  /** Whether every pass should be seen as soon as possible: one that does not fit the submit then has one sample, and ends it. */
  readonly isWatched: boolean;
};

/** Takes the next slices of an accumulation for one submit, at least one. */
export function takeSlices(schedule: Schedule, limits: WorkLimits): Slice[] {
  const { paths, samples, dispatchSamples, isWatched } = limits;
  const { pixels, samples: before } = schedule;
  const slices: Slice[] = [];
  let [left, wanted] = [paths, samples];
  do {
    const affordable = isWatched ? Math.max(1, Math.floor(left / pixels)) : Number.POSITIVE_INFINITY;
    const slice = schedule.next(left, Math.min(affordable, dispatchSamples), Math.min(affordable, wanted));
    schedule.finish(slice);
    slices.push(slice);
    left -= slice.paths;
    wanted = samples - (schedule.samples - before);
  } while (schedule.isComplete && wanted > 0 && left >= (isWatched ? pixels : 1) && slices.length < MAX_DISPATCHES);
  return slices;
}
