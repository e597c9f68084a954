import { join } from "node:path";
import type { RendererId, SceneName } from "./options";
import { type Axis, drawPlot, type Series } from "./plot";
import { placeOf, type Results, type Row, writeFile } from "./results";
import { median } from "./statistics";

/** A plot's file name, and what it shows. */
export type WrittenPlot = { readonly file: string; readonly caption: string };

// Independent points lie close to ours and are in the tables. This order gives each its colour in every plot.
const PLOTTED: readonly (readonly [id: RendererId, label: string])[] = [
  ["ours", "rt-viewer"],
  ["uniform", "uniform baseline"],
  ["three-gpu-pathtracer", "three-gpu-pathtracer"],
  ["mitsuba", "Mitsuba"],
  ["cycles", "Cycles"],
];

const PERCENT: Axis["format"] = (value) => `${Number((100 * value).toPrecision(2))} %`;

/** Draws all plots of some results, into a folder. */
export function writePlots(results: Results, folder: string): WrittenPlot[] {
  const scenes = [...new Set(results.rows.map(({ scene }) => scene))];
  const plots = [
    ...scenes.map((scene) => ({ ...drawScene(results, scene), file: `${scene}.svg` })),
    ...(["sobol", "independent"] as const)
      .filter((sampler) => results.estimates.some((row) => row.sampler === sampler))
      .map((sampler) => ({ ...drawEstimates(results, sampler), file: `estimate-${sampler}.svg` })),
  ];
  for (const { file, svg } of plots) writeFile(join(folder, file), svg);
  return plots.map(({ file, caption }) => ({ file, caption }));
}

type Drawing = { readonly svg: string; readonly caption: string };

/** Seconds against error. rt-viewer appears as it runs in the browser where both hosts were measured. */
function drawScene({ rows, protocol, machine }: Results, scene: SceneName): Drawing {
  const ofScene = rows.filter((row) => row.scene === scene);
  const series = PLOTTED.map(([id, label]): Series => {
    const own = ofScene.filter((row) => row.id === id);
    const ofHost = own.filter(({ host }) => host === own[0]!.host);
    const points = ofHost.map(({ relMse, seconds }) => ({ x: median(seconds), y: Math.sqrt(relMse) }));
    return { name: ofHost[0]?.renderer ?? label, label, detail: describe(ofHost), points };
  }).filter(({ points }) => points.length > 0);
  const caption = `${scene}: time against error`;
  const svg = drawPlot({
    title: caption,
    notes: [
      `${protocol.size} × ${protocol.size} pixels, without compilation; lower left is better`,
      `${machine.cpu}, ${machine.cores} cores`,
    ],
    x: { title: "seconds", format: (value) => `${Number(value.toPrecision(2))}` },
    y: { title: "relative RMSE", format: PERCENT },
    series,
  });
  return { svg, caption };
}

function describe(rows: readonly Row[]): string {
  const counts = rows.map(({ samples }) => samples).join(", ");
  return rows[0] ? `${placeOf(rows[0])}; ${counts} samples` : "";
}

function drawEstimates({ estimates, frames }: Results, sampler: "sobol" | "independent"): Drawing {
  const rows = estimates.filter((row) => row.sampler === sampler);
  const scenes = [...new Set(rows.map(({ scene }) => scene))];
  const series = scenes.map((scene): Series => {
    const points = rows.filter((row) => row.scene === scene);
    return { name: scene, points: points.map(({ truth, estimate }) => ({ x: truth, y: estimate })) };
  });
  const counts = rows.map(({ samples }) => samples);
  const points = sampler === "sobol" ? "Sobol points" : "independent points";
  const caption = `the viewer's own estimate of its error, ${points}`;
  const place = frames[0] ? placeOf(frames[0]) : "";
  const svg = drawPlot({
    title: `stats.error against the truth, ${points}`,
    notes: [`128 × 128 pixels, ${Math.min(...counts)} to ${Math.max(...counts)} samples; the band is ±10 %`, place],
    x: { title: "true relative RMSE", format: PERCENT },
    y: { title: "estimated relative RMSE", format: PERCENT },
    series,
    isAgreement: true,
  });
  return { svg, caption };
}
