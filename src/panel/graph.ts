import type { GraphLogMonitorBindingApi } from "@tweakpane/core";
import type { FolderApi } from "tweakpane";

export type Graph = {
  /** The text beside the graph. */
  label: string;
  /** Draws these values, oldest first, over the whole width. */
  draw(values: readonly number[], range: { readonly min: number; readonly max: number }): void;
};

/**
 * Adds a line graph to a panel.
 *
 * @param format - what the tooltip says of a value.
 */
export function addGraph(pane: FolderApi, format: (value: number) => string): Graph {
  const source = { value: 0 };
  const binding = pane.addBinding(source, "value", {
    readonly: true,
    view: "graph",
    label: "",
    rows: 2,
    min: 0,
    max: 1,
    interval: 0, // never polls
    bufferSize: 2,
    format,
  }) as unknown as GraphLogMonitorBindingApi;

  return {
    get label() {
      return binding.label ?? "";
    },
    set label(text) {
      binding.label = text;
    },
    draw(values, { min, max }) {
      binding.min = min;
      binding.max = max;
      // A polyline takes no point that is not a number, and one point is no line.
      const points = values.filter(Number.isFinite);
      binding.controller.value.rawValue = points.length === 1 ? [points[0], points[0]] : points;
    },
  };
}
