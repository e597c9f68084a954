// What the harness calls in the page, as `globalThis.bench`.
import type { Measure } from "../measurement";
import { measureEstimates, measureFrames, measureOurs } from "../ours";
import { measureBumpy } from "./bumpy";
import type { MeasuredDrop } from "./drop";

const functions = {
  measureOurs,
  measureEstimates,
  measureFrames,
  measureBumpy,
  /** Loaded when it is called: rt-viewer's own figures are taken in a page that holds nothing else. */
  async measureThreeGpuPathTracer(...args: Parameters<Measure>) {
    const { measure } = await import("../rivals/threeGpuPathTracer/measure");
    return measure(...args);
  },
  async measureDrop(triangles: number): Promise<MeasuredDrop> {
    const { measureDrop } = await import("./drop");
    return measureDrop(triangles);
  },
};

declare global {
  var bench: PageBench;
}

export type PageBench = typeof functions;

globalThis.bench = functions;
