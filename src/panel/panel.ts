import type { Stats } from "../renderer/stats";
import { formatFps, formatPercent } from "./format";
import { addKnobs, type PanelKnobs } from "./knobs";
import { addFigures, addProgram } from "./monitors";
import { StyledPane } from "./styles";

export type { PanelKnobs };

/** What a panel needs. It knows figures and settings, not the GPU, so it serves a bare `PathTracer` as well. */
export type PanelOptions = {
  /** Where the panel goes; already in its document or shadow root, which is given the panel's styles. */
  readonly container: HTMLElement;
  /** A live object, read whenever the panel refreshes; `tracer.stats`. */
  readonly stats: Stats;
  /** Where the knobs stand at first. */
  readonly knobs: PanelKnobs;
  /** Called with the knobs that were turned. */
  readonly onChange: (changes: Partial<PanelKnobs>) => void;
  /** Called when the sampling is to start over. */
  readonly onReset: () => void;
  /** Whether sampling rests because somebody said so; then the title says it too. */
  readonly isPaused?: () => boolean;
  /** Whether it starts unfolded. Default true. */
  readonly isExpanded?: boolean;
};

/** A panel on a page. */
export type Panel = {
  /** Shows the figures of now, at most five times a second. To be called every frame. */
  refresh(): void;
  /** Shows knobs that were turned elsewhere; does not call `onChange`. */
  setKnobs(knobs: Partial<PanelKnobs>): void;
  /** Removes the panel. Idempotent. */
  dispose(): void;
};

const REFRESH_INTERVAL_MS = 200;

/** Makes a panel with graphs of speed and error, the tracer's figures, and its live knobs. The caller disposes it. */
export function createPanel(options: PanelOptions): Panel {
  const { container, stats, isPaused = () => false, isExpanded = true } = options;
  const pane = new StyledPane({ container, title: titleOf(stats, isPaused()), expanded: isExpanded });

  const refreshFigures = addFigures(pane, stats);
  const knobs = addKnobs(pane, options);
  const refreshProgram = addProgram(pane, stats);
  let refreshedAt = Number.NEGATIVE_INFINITY;
  let isDisposed = false;

  return {
    refresh() {
      const now = performance.now();
      if (isDisposed || now - refreshedAt < REFRESH_INTERVAL_MS) return;
      refreshedAt = now;
      pane.title = titleOf(stats, isPaused());
      if (!pane.expanded) return;
      refreshFigures();
      refreshProgram();
    },
    setKnobs(values) {
      if (!isDisposed) knobs.set(values);
    },
    dispose() {
      if (isDisposed) return;
      isDisposed = true;
      pane.dispose();
    },
  };
}

/** All that is seen of a folded panel. */
function titleOf({ fps, error, converged }: Stats, isPaused: boolean): string {
  const pace = isPaused ? "paused" : converged ? "converged" : `${formatFps(fps)} fps`;
  return `${pace} · ${formatPercent(error)} error`;
}
