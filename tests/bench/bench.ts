import { join } from "node:path";
import { RtViewerError } from "../../src/errors";
import { openChromium } from "./chromiumHost";
import { openDawn } from "./dawnHost";
import { measureEstimates } from "./estimates";
import { describeMachine } from "./machine";
import { type Options, parseOptions, USAGE } from "./options";
import { measureOriginalTable } from "./originalTable";
import { writePlots } from "./plots";
import { findRenderers } from "./renderers";
import { reportOf } from "./report";
import { type Results, readResults, slugOf, writeFile } from "./results";
import { measureScenes } from "./scenes";

/** `npm run bench`: speed against error, ours and others'. Writes results, plots and `BENCHMARK.md`. */
export async function main(args: string[]): Promise<void> {
  try {
    const options = parseOptions(args);
    if (options.help) console.log(USAGE);
    else publish(options.from === undefined ? await bench(options) : readResults(options.from), options.out);
  } catch (error) {
    if (!(error instanceof RtViewerError)) throw error;
    console.error(error.message);
    process.exit(1);
  }
  process.exit(0); // Dawn keeps the process alive
}

/** Measures, and keeps what was measured. */
async function bench(options: Options): Promise<Results> {
  const results = await measure(options);
  const adapter = (results.frames[0] ?? results.rows[0])?.adapter ?? "nothing";
  const file = join(options.out, "results", `${slugOf(adapter)}.json`);
  writeFile(file, `${JSON.stringify(results, undefined, 1)}\n`);
  return results;
}

async function measure(options: Options): Promise<Results> {
  const chromium = options.hosts.includes("chromium") ? await openChromium(options.usesGpu) : undefined;
  try {
    const dawn = options.hosts.includes("dawn") ? await openDawn() : undefined;
    const hosts = [chromium, dawn].filter((host) => host !== undefined);
    const found = await findRenderers(options, hosts, chromium);
    for (const { id, reason } of found.notMeasured) console.log(`${id}: not measured: ${reason}`);
    const [host] = hosts;
    const isOurs = options.renderers.includes("ours") && host !== undefined;
    // First, while nobody has compiled anything yet.
    const { rows, notMeasured } = await measureScenes(found.renderers, options, console.log);
    if (isOurs) console.log("The viewer's estimates, and the original's table");
    const estimates = isOurs ? await measureEstimates(host, options) : [];
    const frames = isOurs ? await measureOriginalTable(host, options) : [];
    return {
      machine: describeMachine(chromium?.version),
      protocol: { size: options.size, samples: options.samples, runs: options.runs },
      rows,
      notMeasured: [...found.notMeasured, ...notMeasured],
      estimates,
      frames,
    };
  } finally {
    await chromium?.close();
  }
}

function publish(results: Results, out: string): void {
  const plots = writePlots(results, join(out, "plots"));
  const report = join(out, "BENCHMARK.md");
  writeFile(report, reportOf(results, plots));
  console.log(`${report} and ${plots.length} plots`);
}
