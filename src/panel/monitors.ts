import type { FolderApi } from "tweakpane";
import type { Stats } from "../renderer/stats";
import { formatCount, formatMilliseconds, formatRate } from "./format";

type Line = {
  readonly label: string;
  /** Lines of text; 1 where it is left out. */
  readonly rows?: number;
  readonly read: (stats: Stats) => string;
};

/** The figures that change all the time. */
export const FIGURES: readonly Line[] = [
  { label: "samples", read: ({ samples }) => formatCount(samples) },
  { label: "paths", read: ({ pathsPerSecond }) => formatRate(pathsPerSecond) },
  { label: "rays", read: ({ raysPerSecond }) => formatRate(raysPerSecond) },
  { label: "GPU time", read: ({ gpuMs }) => formatMilliseconds(gpuMs) },
  { label: "bad samples", read: ({ badSamples }) => formatCount(badSamples) },
];

/** What runs where: what the shader contains, and the adapter. */
export const PROGRAM: readonly Line[] = [
  { label: "compiled in", read: ({ compileSeconds }) => formatMilliseconds(compileSeconds * 1000) },
  { label: "adapter", rows: 2, read: ({ adapter }) => adapter },
  { label: "contains", rows: 6, read: ({ features }) => features.join("\n") },
];

/** Adds lines of text. Returns what brings each up to date. */
export function addLines(folder: FolderApi, lines: readonly Line[], stats: Stats): (() => void)[] {
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
