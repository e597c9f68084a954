import type { FolderApi } from "tweakpane";
import type { Stats } from "../renderer/stats";
import { formatCount, formatFps, formatMilliseconds, formatPercent, formatRate } from "./format";
import { addGraph } from "./graph";
import { RecentHistory, WholeHistory } from "./history";

const GRAPH_POINTS = 96;
const ERROR_STEP_MS = 200;

type Line = {
  readonly label: string;
  /** Lines of text; 1 where it is left out. */
  readonly rows?: number;
  readonly read: (stats: Stats) => string;
};
type Refresh = () => void;

const FIGURES: readonly Line[] = [
  { label: "samples", read: ({ samples }) => formatCount(samples) },
  { label: "paths", read: ({ pathsPerSecond }) => formatRate(pathsPerSecond) },
  { label: "rays", read: ({ raysPerSecond }) => formatRate(raysPerSecond) },
  { label: "frame", read: ({ frameMs }) => formatMilliseconds(frameMs) },
  { label: "bad samples", read: ({ badSamples }) => formatCount(badSamples) },
];

/** Adds the graphs of speed and error and the figures that change all the time. */
export function addFigures(pane: FolderApi, stats: Stats): Refresh {
  return refreshAll([addFpsGraph(pane, stats), addErrorGraph(pane, stats), ...addLines(pane, FIGURES, stats)]);
}

const PROGRAM: readonly Line[] = [
  { label: "compiled in", read: ({ compileSeconds }) => formatMilliseconds(compileSeconds * 1000) },
  { label: "adapter", rows: 2, read: ({ adapter }) => adapter },
  { label: "contains", rows: 6, read: ({ features }) => features.join("\n") },
];

/** Adds the folder that tells what runs where: what the shader contains, and the adapter. */
export function addProgram(pane: FolderApi, stats: Stats): Refresh {
  const folder = pane.addFolder({ title: "Shader", expanded: false });
  return refreshAll(addLines(folder, PROGRAM, stats));
}

function addFpsGraph(pane: FolderApi, stats: Stats): Refresh {
  const history = new RecentHistory(GRAPH_POINTS);
  const graph = addGraph(pane, (fps) => `${formatFps(fps)} fps`);
  return () => {
    history.add(performance.now(), stats.fps);
    graph.label = `${formatFps(stats.fps)} fps`;
    graph.draw(history.values, { min: 0, max: Math.max(10, ...history.values) });
  };
}

/** The logarithm of the error, from the start of the sampling until now. */
function addErrorGraph(pane: FolderApi, stats: Stats): Refresh {
  const history = new WholeHistory(GRAPH_POINTS, ERROR_STEP_MS);
  const graph = addGraph(pane, (logError) => `${formatPercent(10 ** logError)} error`);
  let lastSamples = 0;
  return () => {
    if (stats.samples < lastSamples) history.clear();
    lastSamples = stats.samples;
    if (stats.error > 0 && stats.error < Number.POSITIVE_INFINITY) {
      history.add(performance.now(), Math.log10(stats.error));
    }
    graph.label = `${formatPercent(stats.error)} error`;
    // Whole decades, 100 % at the top: the slope of one picture can be compared with that of another.
    graph.draw(history.values, { min: Math.floor(Math.min(-2, ...history.values)), max: 0 });
  };
}

function addLines(folder: FolderApi, lines: readonly Line[], stats: Stats): Refresh[] {
  return lines.map(({ label, rows = 1, read }) => {
    const shown = { text: read(stats) };
    const binding = folder.addBinding(shown, "text", { readonly: true, label, rows, multiline: rows > 1, interval: 0 });
    return () => {
      const text = read(stats);
      if (text === shown.text) return;
      shown.text = text;
      binding.refresh();
    };
  });
}

function refreshAll(refreshers: readonly Refresh[]): Refresh {
  return () => {
    for (const refresh of refreshers) refresh();
  };
}
