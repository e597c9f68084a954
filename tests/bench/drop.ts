import { writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { type ChromiumHost, openChromium } from "./chromiumHost";
import { describeMachine } from "./machine";
import type { MeasuredDrop } from "./page/drop";

// From a dropped .glb file to its first picture, by phase: node src/cli/run.mjs tests/bench/drop.ts [TRIANGLES …]
//
// A bumpy sphere on an empty <rt-viewer> of 256 × 256, each time in a fresh page of one Chromium.

const RESULTS = fileURLToPath(new URL("results/drop.json", import.meta.url));
const TRIANGLES = [1e6];
const RUNS = 3;

/**
 * Prints and writes the phases of each size, of the run that took the median time.
 *
 * @param args - sizes, a million by default. They have to be more than 20,000.
 */
export async function main(args: string[]): Promise<void> {
  const chromium = await openChromium(false);
  const drops: MeasuredDrop[] = [];
  try {
    for (const triangles of args.length > 0 ? args.map(Number) : TRIANGLES)
      drops.push(await measure(chromium, triangles));
  } finally {
    await chromium.close();
  }
  const results = { machine: describeMachine(chromium.version), runs: RUNS, drops };
  const tenths = (_: string, value: unknown) => (typeof value === "number" ? Math.round(10 * value) / 10 : value);
  writeFileSync(RESULTS, `${JSON.stringify(results, tenths, 2)}\n`);
  process.exit(0); // the preview server keeps the process alive
}

async function measure(chromium: ChromiumHost, triangles: number): Promise<MeasuredDrop> {
  const runs: MeasuredDrop[] = [];
  for (let run = 0; run < RUNS; run++) runs.push(await chromium.drop(triangles));
  const drop = runs.toSorted((a, b) => a.milliseconds - b.milliseconds)[Math.floor(RUNS / 2)]!;
  print(drop);
  console.log(`all runs: ${runs.map(({ milliseconds }) => seconds(milliseconds)).join(", ")}`);
  return drop;
}

function print({ triangles, bytes, milliseconds, phases, longTasks, longestFrame, events, bar }: MeasuredDrop): void {
  console.log(`${triangles} triangles, ${(bytes / 1e6).toFixed(1)} MB: ${seconds(milliseconds)}`);
  console.table(Object.entries(phases).map(([phase, ms]) => ({ phase, milliseconds: Math.round(ms) })));
  const [longest] = longTasks;
  const block = longest ? `${Math.round(longest.milliseconds)} ms, ${longest.phase}` : "none of 50 ms";
  console.log(`longest task of the page's thread: ${block}; longest frame: ${Math.round(longestFrame)} ms`);
  console.log(`progress: ${JSON.stringify(events)}; the bar showed ${bar.join(" ")}`);
}

function seconds(milliseconds: number): string {
  return `${(milliseconds / 1000).toFixed(2)} s`;
}
