import { ORIGINAL_SETTINGS } from "../../demo/performance/originalSettings";
import type { SceneName } from "./options";
import { CAP_SECONDS } from "./plan";
import type { WrittenPlot } from "./plots";
import { type FrameRow, placeOf, type Results, type Row } from "./results";
import { type ExcessFigure, efficiency, geometricMean, median } from "./statistics";

/** The report, in Markdown. */
export function reportOf(results: Results, plots: readonly WrittenPlot[]): string {
  const { machine, rows, notMeasured, frames } = results;
  const main = rows.filter(({ isMain }) => isMain);
  const scenes = [...new Set(main.map(({ scene }) => scene))];
  const chromium = machine.chromium === undefined ? "" : `, Chromium ${machine.chromium}`;
  const parts = [
    "# Speed against error",
    "Written by `npm run bench`; don't edit.",
    `Measured on ${machine.date}: ${machine.cpu}, ${machine.cores} cores, ${machine.system}, Node ${machine.node}${chromium}. ` +
      "Every row names what it ran on; a software adapter's figures say nothing about a GPU's.",
    summary(main, scenes),
    ...scenes.map((scene) => sceneSection(main, scene, results.protocol.size, plots)),
    notMeasured.length === 0
      ? ""
      : `## Not measured\n\n${notMeasured.map(({ id, scene, reason }) => `- ${id}${scene ? `, ${scene}` : ""}: ${reason}`).join("\n")}`,
    protocolSection(results),
    frames.length === 0 ? "" : framesSection(frames),
    estimatesSection(plots),
  ];
  return `${parts.filter((part) => part !== "").join("\n\n")}\n`;
}

/** rt-viewer's efficiency over everybody's, scene by scene. */
function summary(rows: readonly Row[], scenes: readonly SceneName[]): string {
  const entrants = [...new Map(rows.map((row) => [`${row.id} ${row.host}`, row])).values()];
  const lines = entrants.flatMap((entrant) => {
    const ratios = scenes.map((scene) => {
      const row = rows.find((row) => row.scene === scene && row.id === entrant.id && row.host === entrant.host);
      return row && advantage(rows, row);
    });
    const known = ratios.filter((ratio) => ratio !== undefined);
    if (entrant.id === "ours" || known.length === 0) return [];
    const cells = ratios.map((ratio) => (ratio === undefined ? "–" : figure(ratio)));
    return [[entrant.renderer, placeOf(entrant), ...cells, figure(geometricMean(known))]];
  });
  if (lines.length === 0) return "";
  return (
    "How many times more efficient rt-viewer is: efficiency = 1/(relMSE · seconds), ours divided by theirs. Below 1, theirs is higher. " +
    "Error is noise only: what a renderer gets wrong is in *beyond noise*, not here.\n\n" +
    table(["against", "on", ...scenes, "geometric mean of these"], lines, 2)
  );
}

function sceneSection(rows: readonly Row[], scene: SceneName, size: number, plots: readonly WrittenPlot[]): string {
  const lines = rows
    .filter((row) => row.scene === scene)
    .map((row) => {
      const { renderer, samples, relMse, uncertainty, setupSeconds, bias } = row;
      const seconds = median(row.seconds);
      const ratio = advantage(rows, row);
      return [
        renderer,
        placeOf(row),
        `${samples}`,
        figure(pathsPerSecond(row, size)),
        `${relMse.toExponential(2)} ± ${percent(uncertainty)}`,
        `${Number(seconds.toPrecision(3))}`,
        `${Number(setupSeconds.toPrecision(2))}`,
        figure(efficiency(relMse, seconds)),
        ratio === undefined ? "–" : figure(ratio),
        bias ? beyondNoise(bias) : "–",
      ];
    });
  const columns = ["renderer", "on", "samples", "Mpaths/s", "relMSE", "seconds", "set-up s", "efficiency", "ours ÷ it"];
  const plot = plots.find(({ file }) => file === `${scene}.svg`);
  const image = plot ? `\n\n![${plot.caption}](plots/${plot.file})` : "";
  return `## ${scene}\n\n${table([...columns, "beyond noise"], lines, 2)}${image}`;
}

function protocolSection({ protocol: { size, samples, runs } }: Results): string {
  return `## How it is measured

- ${size} × ${size} pixels, ${samples} samples per pixel, the scene's own number of bounces. ${runs} runs; in each, the renderers take
  their turn at a scene one right after the other. Seconds are the median of the runs.
- **seconds** are sampling, after a warm-up: no start, no compilation. rt-viewer runs the program with its values as constants, which a
  page gets after half a second of rest. Those of the Python renderers include the call and the copy of the image: some milliseconds
  each, which show at the lowest counts. **set-up** is what comes before: reading, linking, compiling; for the others with one sample.
  Kernels may come from a cache on disk.
- three-gpu-pathtracer cannot sample spheres, so that the lamp of \`spheres\` is found by chance.
- A renderer that would take longer than ${CAP_SECONDS} s takes fewer samples, as its row says. Efficiency hardly depends on their
  number, though low-discrepancy points gain with it.
- **relMSE** = mean((a − b)²)/2 / mean((a + b)/2)² over all pixels and channels, a and b of different seeds. This is noise only. ± is
  its standard error, from the spread between pixels.
- **beyond noise** is what else is wrong: the relative RMS difference between the mean of both images, each 2 × 2 pixels averaged, and
  Mitsuba's image of 65,536 samples per pixel, the noise of both subtracted. Where what is left may be chance, "<" and what it is at
  most.
- **ours ÷ it** compares with rt-viewer's default settings on the same host; renderers in Python with Chromium, which is what
  users have.`;
}

/** Ours over theirs; undefined if ours was not measured. */
function advantage(rows: readonly Row[], row: Row): number | undefined {
  const ours = rows.filter(({ id, scene }) => id === "ours" && scene === row.scene);
  const host = row.host === "Python" ? "Chromium" : row.host;
  const rival = ours.find((candidate) => candidate.host === host) ?? ours[0];
  return rival && efficiencyOf(rival) / efficiencyOf(row);
}

function efficiencyOf({ relMse, seconds }: Row): number {
  return efficiency(relMse, median(seconds));
}

function framesSection(frames: readonly FrameRow[]): string {
  const [{ width, height, host, adapter }] = frames as [FrameRow, ...FrameRow[]];
  const lines = ORIGINAL_SETTINGS.map(({ rays, bounces, lightSamples, reported }) => {
    const cells = (["path", "uniform"] as const).flatMap((estimator) => {
      const row = frames.find(
        (row) =>
          row.estimator === estimator &&
          row.rays === rays &&
          row.bounces === bounces &&
          row.lightSamples === lightSamples,
      );
      return row ? [figure(1 / median(row.seconds)), percent(Math.sqrt(row.relMse))] : ["–", "–"];
    });
    return [`${rays} / ${bounces} / ${lightSamples}`, ...cells, reported];
  });
  const columns = ["rays / bounces / light samples", "fps", "error", "fps, uniform", "error, uniform", "fps, original"];
  return `## The original's table

The settings in which the project that rt-viewer comes from gave its speed. A frame takes that many rays per pixel from an empty
image; scene \`spheres\`, ${width} × ${height} pixels, on ${placeOf({ host, adapter })}. "uniform" samples as the original did; the error is the
relative RMSE of one frame. The last column is the original's report: another scene, a GTX 970, no error given.

${table(columns, lines, 1)}`;
}

function estimatesSection(plots: readonly WrittenPlot[]): string {
  const own = plots.filter(({ file }) => file.startsWith("estimate-"));
  if (own.length === 0) return "";
  return `## The viewer's own estimate\n\n${own.map(({ file, caption }) => `![${caption}](plots/${file})`).join("\n\n")}`;
}

/** Millions of camera paths per second. */
function pathsPerSecond({ samples, seconds }: Row, size: number): number {
  return (size ** 2 * samples) / median(seconds) / 1e6;
}

/** A figure only where chance does not explain it. */
function beyondNoise({ excess, sigmas, bound }: ExcessFigure): string {
  return sigmas > 3 ? percent(excess) : `< ${percent(bound)}`;
}

/** @param leftCount - how many columns are words. */
function table(columns: readonly string[], lines: readonly (readonly string[])[], leftCount: number): string {
  const rule = columns.map((_, i) => (i < leftCount ? "---" : "---:"));
  return [columns, rule, ...lines].map((cells) => `| ${cells.join(" | ")} |`).join("\n");
}

/** Three digits. */
function figure(value: number): string {
  return value >= 100 ? Math.round(value).toLocaleString("en-US") : `${Number(value.toPrecision(3))}`;
}

function percent(share: number): string {
  return `${Number((100 * share).toPrecision(2))} %`;
}
