// What a GPU does, in Node: node src/cli/run.mjs tests/bench/gpu.ts [SCENE …]
//
// Prints Markdown. At 1920 × 1080: billions of paths a second by GPU time and by the clock, with either program, medians of three. At 256 × 256 with
// 64 samples: milliseconds of the first picture after compiling and the median of nine more, and the efficiency
// 1/(relMSE · seconds) at that median. In frames of 60 Hz at 1920 × 1080: samples per pixel after a second.
import { requestDawnDevice } from "../../src/cli/dawn";
import { PathTracer } from "../../src/renderer/pathTracer";
import type { Settings } from "../../src/renderer/settings";
import type { Scene } from "../../src/scene/schema";
import { loadReference, REFERENCE_NAMES } from "../support/reference";
import { efficiency, median, noise } from "./statistics";

const LARGE = [1920, 1080] as const;
const SMALL = [256, 256] as const;
const SAMPLES = 64;
const PICTURES = 9;
// The first after another film was freed may wait for the driver to do so.
const RUNS = 3;
const FRAMES = 60;
const FRAME_MS = 1000 / 60;
// Enough paths for half a second or so of a quick GPU.
const LARGE_SAMPLES = 1024;

export async function main(names: string[]): Promise<void> {
  const device = await requestDawnDevice();
  const scenes = REFERENCE_NAMES.filter((name) => names.length === 0 || names.includes(name));
  const rows = [];
  for (const name of scenes) rows.push([name, ...(await measure(device, loadReference(name).scene))]);
  const head =
    "scene | constants: GPU | clock | buffer: GPU | clock | quicker | first 64 | next 64 | efficiency | samples in 1 s";
  console.log(`| ${head} |\n|${"---|".repeat(10)}`);
  for (const row of rows) console.log(`| ${row.join(" | ")} |`);
  process.exit(0); // Dawn keeps the process alive
}

async function measure(device: GPUDevice, scene: Scene): Promise<string[]> {
  const open = async (size: readonly [number, number], settings: Partial<Settings>) => {
    const tracer = await PathTracer.create({ scene, width: size[0], height: size[1], settings, device });
    await tracer.compile();
    return tracer;
  };

  const rates = [];
  for (const constants of [true, false]) {
    const tracer = await open(LARGE, { constants });
    const paths = (LARGE[0] * LARGE[1] * LARGE_SAMPLES) / 1e9;
    const runs = [];
    for (let run = 0; run < RUNS; run++) {
      tracer.reset();
      const seconds = await time(() => tracer.sample(LARGE_SAMPLES));
      runs.push({ gpu: paths / tracer.stats.seconds, clock: paths / seconds });
    }
    rates.push(median(runs.map(({ gpu }) => gpu)), median(runs.map(({ clock }) => clock)));
    tracer.dispose();
  }

  const tracer = await open(SMALL, {});
  const isConstant = tracer.stats.features.includes("values as constants");
  const first = await time(() => tracer.sample(SAMPLES));
  const pictures = [];
  const times = [];
  for (let seed = 2; seed < 2 + PICTURES; seed++) {
    tracer.update({ seed });
    times.push(await time(() => tracer.sample(SAMPLES)));
    if (seed < 4) pictures.push(rgbOf(await tracer.readRadiance()));
  }
  tracer.dispose();
  const { relMse } = noise(pictures[0]!, pictures[1]!);

  const framed = await open(LARGE, {});
  for (let frame = 0; frame < FRAMES; frame++) {
    framed.frame();
    await new Promise((resolve) => setTimeout(resolve, FRAME_MS));
  }
  const { samples } = framed.stats;
  framed.dispose();

  return [
    ...rates.map((rate) => rate.toFixed(2)),
    isConstant ? "constants" : "buffer",
    `${(1000 * first).toFixed(1)} ms`,
    `${(1000 * median(times)).toFixed(1)} ms`,
    efficiency(relMse, median(times)).toPrecision(3),
    String(samples),
  ];
}

async function time(work: () => Promise<void>): Promise<number> {
  const start = performance.now();
  await work();
  return (performance.now() - start) / 1000;
}

function rgbOf(rgba: Float32Array): Float32Array {
  return rgba.filter((_, i) => i % 4 !== 3);
}
