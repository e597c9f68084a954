import type { FolderApi } from "tweakpane";
import type { Stats } from "../renderer/stats";
import { type CoursePoint, ErrorCourse } from "./course";
import { formatFps, formatMilliseconds, formatPercent, formatSeconds } from "./format";
import { type Axis, decades, Graph, type Plot } from "./graph";
import { RecentHistory } from "./history";

const FPS_POINTS = 96;
// What most displays show; a graph of less is drawn to this height, so that a low line is a low rate.
const COMMON_FPS = 60;

/** A graph that takes note of figures, and brings up to date what is written above it and the drawing. */
export type LiveGraph = { readonly observe: () => void; readonly write: () => void; readonly draw: () => void };

/** Adds a graph of the latest frame rates. */
export function addFpsGraph(pane: FolderApi, stats: Stats): LiveGraph {
  const graph = new Graph(pane);
  const history = new RecentHistory(FPS_POINTS);
  return {
    observe: () => history.add(stats.fps),
    write: () => graph.setHeading(`${formatFps(stats.fps)} fps`, formatMilliseconds(stats.frameMs)),
    draw: () => graph.draw(plotFps(history.values)),
  };
}

function plotFps(values: readonly number[]): Plot {
  const max = 1.2 * Math.max(COMMON_FPS, ...values);
  return {
    x: { min: FPS_POINTS - 1, max: 0, marks: [] },
    y: { min: 0, max, marks: [{ at: COMMON_FPS, text: String(COMMON_FPS) }] },
    // A rate that is not known yet is no point.
    line: values.map((fps, i) => [values.length - 1 - i, fps > 0 ? fps : Number.NaN]),
  };
}

// Decades by which the time axis grows. In between the grid stays as it is.
const TIME_STEP = 0.1;

/** Adds a graph of the error against the time of sampling, both as logarithms: its slope is the rate of convergence. */
export function addErrorGraph(pane: FolderApi, stats: Stats): LiveGraph {
  const graph = new Graph(pane);
  const course = new ErrorCourse();
  return {
    observe: () => course.observe(stats),
    write: () => graph.setHeading(`${formatPercent(stats.error)} error`, formatSeconds(stats.seconds)),
    draw: () => graph.draw(plotError(course.points)),
  };
}

/** Whole decades of error from 100 % down, and at least one of time: slopes of two pictures can be compared. */
function plotError(points: readonly CoursePoint[]): Plot {
  const first = points[0] ?? { seconds: 0.1, error: 1 };
  const line = points.map(({ seconds, error }) => [Math.log10(seconds), Math.log10(error)] as const);
  const start = Math.log10(first.seconds);
  const now = line.at(-1)?.[0] ?? start;
  const end = start + Math.max(1, Math.ceil((now - start) / TIME_STEP) * TIME_STEP);
  const highest = Math.max(0, ...line.map(([, error]) => Math.ceil(error)));
  const lowest = Math.floor(Math.min(-2, ...line.map(([, error]) => error)));
  const x: Axis = { min: start, max: end, marks: decades(start + 0.1, end - 0.1, formatSeconds) };
  const y: Axis = { min: lowest, max: highest, marks: decades(lowest + 0.5, highest - 0.5, roundPercent) };
  // Independent samples: the error falls with the square root of their number.
  const level = Math.log10(first.error);
  const guide: Plot["guide"] = [
    [start, level],
    [end, level - (end - start) / 2],
  ];
  return points.length === 0 ? { x, y, line } : { x, y, line, guide };
}

function roundPercent(ratio: number): string {
  return `${Number((100 * ratio).toPrecision(1))} %`;
}
