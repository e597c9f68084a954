import { writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import type { Scene } from "../../src/scene/schema";
import { loadReference } from "../support/reference";
import { type ChromiumHost, openChromium } from "./chromiumHost";
import { describeMachine } from "./machine";
import type { MeshRenderer } from "./page/bumpy";

// Milliseconds per sample of one picture, of ever more triangles: node src/cli/run.mjs tests/bench/meshes.ts
// Ours alone, of some sizes, without writing the results:         node src/cli/run.mjs tests/bench/meshes.ts 1000 10000
//
// Cornell's walls and lamp around a bumpy sphere, 256 × 256, 8 bounces, ours beside three-gpu-pathtracer in one Chromium.

const RESULTS = fileURLToPath(new URL("results/meshes.json", import.meta.url));
const SIZE = 256;
const OURS = [1e3, 1e4, 1e5, 1e6, 4e6];
const THEIRS = [1e3, 1e5, 1e6];
const SAMPLES = 8;

type Row = {
  readonly renderer: MeshRenderer;
  readonly triangles: number;
  readonly millisecondsPerSample: number;
  /** Reading, sorting and compiling, until the first sample can be taken. */
  readonly setupSeconds: number;
};

/**
 * Prints a row for each, and writes them.
 *
 * @param args - triangles, to try ours with those only.
 */
export async function main(args: string[]): Promise<void> {
  const [ours, theirs] = args.length > 0 ? [args.map(Number), []] : [OURS, THEIRS];
  const chromium = await openChromium(false);
  const rows: Row[] = [];
  try {
    for (const triangles of ours) rows.push(await measure(chromium, "ours", triangles));
    for (const triangles of theirs) rows.push(await measure(chromium, "three-gpu-pathtracer", triangles));
  } finally {
    await chromium.close();
  }
  console.table(rows);
  const results = { machine: describeMachine(chromium.version), rows };
  if (args.length === 0) writeFileSync(RESULTS, `${JSON.stringify(results, undefined, 2)}\n`);
  process.exit(0); // the preview server keeps the process alive
}

async function measure(chromium: ChromiumHost, renderer: MeshRenderer, count: number): Promise<Row> {
  const options = { width: SIZE, height: SIZE, samples: [SAMPLES], seed: 1 };
  const { triangles, measurement } = await chromium.bumpy(renderer, emptyRoom(), count, options);
  const [image] = measurement.images;
  const row = {
    renderer,
    triangles,
    millisecondsPerSample: (1000 * image!.seconds) / image!.samples,
    setupSeconds: measurement.setupSeconds,
  };
  console.log(JSON.stringify(row));
  return row;
}

/** The Cornell box without its boxes: the sphere comes in their place. */
function emptyRoom(): Scene {
  const { scene } = loadReference("cornell");
  return { ...scene, objects: scene.objects.filter(({ type }) => type !== "box") };
}
