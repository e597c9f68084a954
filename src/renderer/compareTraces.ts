import type { CompiledScene } from "../compile/compileScene";
import { sleep, spinsInNode } from "../gpu/device";
import { checked, scoped } from "../gpu/errorScope";
import { Film } from "../gpu/film";
import { Readback } from "../gpu/readback";
import type { SceneGeometry } from "../gpu/sceneGeometry";
import { TracePass } from "../gpu/tracePass";
import type { Pace } from "./pace";
import type { Program } from "./program";
import { Schedule } from "./schedule";
import type { SharedUniforms } from "./sharedUniforms";
import { takeSlices } from "./takeSlices";

/** A program and the values it reads. */
export type Contender = { readonly program: Program; readonly compiled: CompiledScene };

/** What two programs are compared on. */
export type Comparison = {
  readonly contenders: readonly [Contender, Contender];
  readonly geometry: SceneGeometry | undefined;
  /** For a film of their own, of the size that it says. */
  readonly shared: SharedUniforms;
  /** Learns from it. */
  readonly pace: Pace;
  /** Whether what is compared is still there; asked before each submit. */
  readonly isWanted: () => boolean;
};

// Milliseconds of each measurement: less than a frame, long against what starting it takes.
const MEASURED_MS = 4;
// Until so much work is found: each step multiplies it.
const MOST_STEPS = 6;
// In turns, so that what else the adapter does meanwhile is shared.
const TURNS = [0, 1, 1, 0] as const;
const MOST_SAMPLES = 4096;

/**
 * Times two programs that trace the same picture.
 * @returns how many times as long as the first the second one takes; undefined if that is not wanted any more.
 */
export async function compareTraces(
  device: GPUDevice,
  { contenders, geometry, shared, pace, isWanted }: Comparison,
): Promise<number | undefined> {
  const [width, height] = [shared.size[0]!, shared.size[1]!];
  const { film, readback, traces } = await checked(device, () => {
    const film = new Film(device, width, height);
    const traces = contenders.map(
      ({ program: { pipelines }, compiled: { uniform: scene } }) =>
        new TracePass(device, { pipelines, scene, geometry, film }),
    );
    return { film, readback: new Readback(device), traces };
  });
  const measure = async (trace: TracePass): Promise<number> => {
    const { dispatchSamples } = pace;
    const limits = { paths: pace.pathsFor(MEASURED_MS), samples: MOST_SAMPLES, dispatchSamples, isWatched: false };
    const slices = takeSlices(new Schedule(width, height), limits);
    const paths = slices.reduce((sum, slice) => sum + slice.paths, 0);
    const submittedAt = performance.now();
    const { error } = scoped(device, () => {
      const encoder = device.createCommandEncoder({ label: "compare" });
      const frames = slices.map((slice) => ({ ...shared, ...slice }));
      trace.encode(encoder, frames, readback.timestampWrites);
      readback.encode(encoder, film, undefined);
      device.queue.submit([encoder.finish()]);
    });
    if (spinsInNode(device)) await sleep(pace.predictMs(paths));
    const { gpuMs } = await readback.read(false);
    const ms = gpuMs ?? performance.now() - submittedAt;
    const failure = await error;
    if (failure) throw failure;
    pace.observe(paths, ms);
    return ms / paths;
  };

  try {
    for (let step = 0; step < MOST_STEPS && pace.predictMs(pace.pathsFor(MEASURED_MS)) < MEASURED_MS / 2; step++) {
      if (!isWanted()) return undefined;
      await measure(traces[0]!);
    }
    const times: [number, number] = [0, 0];
    for (const turn of TURNS) {
      if (!isWanted()) return undefined;
      times[turn] += await measure(traces[turn]!);
    }
    return times[1] / times[0];
  } finally {
    for (const resource of [...traces, readback, film]) resource.dispose();
  }
}
