import { writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import type { Scene } from "../../src/scene/schema";
import { bumpySphere, meshObject, placed } from "../support/meshes";
import { loadReference } from "../support/reference";
import { type ChromiumHost, openChromium } from "./chromiumHost";
import { describeMachine } from "./machine";

// Milliseconds per sample of one picture, of ever more triangles: node src/cli/run.mjs tests/bench/meshes.ts
//
// Cornell's walls and lamp around a bumpy sphere, 256 × 256, 8 bounces, ours beside three-gpu-pathtracer in one Chromium.

const RESULTS = fileURLToPath(new URL("results/meshes.json", import.meta.url));
const SIZE = 256;
const OURS = [1e3, 1e4, 1e5, 1e6];
const THEIRS = [1e3, 1e5, 1e6];
const SAMPLES = 8;

type Row = {
  readonly renderer: string;
  readonly triangles: number;
  readonly millisecondsPerSample: number;
  /** Reading, sorting and compiling, until the first sample can be taken. */
  readonly setupSeconds: number;
};

/** Prints and writes a row for each. */
export async function main(): Promise<void> {
  const chromium = await openChromium(false);
  const rows: Row[] = [];
  try {
    for (const triangles of OURS) rows.push(await measure(chromium, "ours", triangles));
    for (const triangles of THEIRS) rows.push(await measure(chromium, "three-gpu-pathtracer", triangles));
  } finally {
    await chromium.close();
  }
  console.table(rows);
  writeFileSync(RESULTS, `${JSON.stringify({ machine: describeMachine(chromium.version), rows }, undefined, 2)}\n`);
  process.exit(0); // the preview server keeps the process alive
}

async function measure(chromium: ChromiumHost, renderer: "ours" | "three-gpu-pathtracer", count: number): Promise<Row> {
  const scene = bumpyScene(count);
  const options = { width: SIZE, height: SIZE, samples: [SAMPLES], seed: 1 };
  const { images, setupSeconds } =
    renderer === "ours"
      ? await chromium.measure("ours", scene, options)
      : await chromium.threeGpuPathTracer(scene, options);
  const [image] = images;
  const mesh = scene.objects.at(-1) as { readonly indices: ArrayLike<number> };
  const row = {
    renderer,
    triangles: mesh.indices.length / 3,
    millisecondsPerSample: (1000 * image!.seconds) / image!.samples,
    setupSeconds,
  };
  console.log(JSON.stringify(row));
  return row;
}

/** Without the boxes, and the sphere in their place. */
function bumpyScene(triangles: number): Scene {
  const { scene } = loadReference("cornell");
  const walls = scene.objects.filter(({ type }) => type !== "box");
  return { ...scene, objects: [...walls, meshObject(placed(bumpySphere(triangles), 1, [0, -0.4, 0]), "white")] };
}
