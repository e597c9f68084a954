import type { Stats } from "../renderer/stats";
import type { ScenePart } from "../scene/parts";
import type { ResolvedScene } from "../scene/schema";
import { copier } from "./clipboard";
import { formatFps, formatPercent } from "./format";
import { addErrorGraph, addFpsGraph } from "./graphs";
import { addKnobs, type PanelKnobs } from "./knobs";
import { addLines, FIGURES, PROGRAM } from "./monitors";
import { nameFields } from "./nameFields";
import { type SceneEditor, SceneKnobs } from "./sceneKnobs";
import { openShaderDialog } from "./shaderDialog";
import { StyledPane } from "./styles";

export type { PanelKnobs, SceneEditor, ScenePart };

/** What a panel needs. It knows figures, settings and scenes, not the GPU, so it serves a bare `PathTracer` as well. */
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
  /** Lets one choose among the scene's objects and lights and change them. Left out: there is no such folder. */
  readonly editor?: SceneEditor;
  /** The text of the shader that runs, to be shown on demand; `tracer.program.wgsl`. Left out: there is no such button. */
  readonly wgsl?: () => string;
  /** Whether sampling rests because somebody said so; then the title says it too. */
  readonly isPaused?: () => boolean;
  /** Whether it starts unfolded. Default true. */
  readonly isExpanded?: boolean;
};

/** A panel on a page. */
export type Panel = {
  /**
   * Shows the figures of now, one part of the panel in each call and all of it up to five times a second, and hands on changes
   * of the scene. To be called every frame.
   *
   * @param nowMs - as of `performance.now()`, which is the default.
   */
  refresh(nowMs?: number): void;
  /** Shows knobs that were turned elsewhere; does not call `onChange`. */
  setKnobs(knobs: Partial<PanelKnobs>): void;
  /** Shows another scene in the editor, with nothing chosen. */
  setScene(scene: ResolvedScene): void;
  /** Shows the knobs of an object or a light that was chosen elsewhere, or of none; does not call `onSelect`. */
  select(part: ScenePart | undefined): void;
  /** Removes the panel. Idempotent. */
  dispose(): void;
};

const REFRESH_INTERVAL_MS = 200;

/** Makes a panel with graphs of speed and error, the tracer's figures, and live knobs. The caller disposes it. */
export function createPanel(options: PanelOptions): Panel {
  const { container, stats, isPaused = () => false, isExpanded = true, editor, wgsl } = options;
  const pane = new StyledPane({ container, title: titleOf(stats, isPaused()), expanded: isExpanded });

  const fpsGraph = addFpsGraph(pane, stats);
  const errorGraph = addErrorGraph(pane, stats);
  const figures = addLines(pane, FIGURES, stats);
  const scene = editor && new SceneKnobs(pane, editor);
  const knobs = addKnobs(pane, options);
  const shader = pane.addFolder({ title: "Shader", expanded: false });
  const program = addLines(shader, PROGRAM, stats);
  let closeDialog = () => {};
  if (wgsl) {
    shader.addButton({ title: "Show WGSL" }).on("click", () => {
      closeDialog = openShaderDialog(container, wgsl());
    });
  }
  addCopyButton(pane, container, stats);
  nameFields(container);

  // One in each frame, so that none has much to do: to lay out one text takes a third of a millisecond.
  const parts = [
    () => {
      fpsGraph.observe();
      pane.title = titleOf(stats, isPaused());
    },
    fpsGraph.write,
    fpsGraph.draw,
    errorGraph.write,
    errorGraph.draw,
    ...figures,
    ...program,
  ];
  let nextPart = 0;
  let refreshedAt = Number.NEGATIVE_INFINITY;
  let isDisposed = false;

  return {
    refresh(nowMs = performance.now()) {
      if (isDisposed) return;
      scene?.flush();
      errorGraph.observe();
      if (nextPart === 0 && nowMs - refreshedAt < REFRESH_INTERVAL_MS) return;
      if (nextPart === 0) refreshedAt = nowMs;
      parts[nextPart]!();
      nextPart = pane.expanded ? (nextPart + 1) % parts.length : 0;
    },
    setKnobs(values) {
      if (!isDisposed) knobs.set(values);
    },
    setScene(shown) {
      if (!isDisposed) scene?.show(shown);
    },
    select(part) {
      if (!isDisposed) scene?.select(part);
    },
    dispose() {
      if (isDisposed) return;
      isDisposed = true;
      closeDialog();
      pane.dispose();
    },
  };
}

function addCopyButton(pane: StyledPane, container: HTMLElement, stats: Stats): void {
  const title = "Copy figures as JSON";
  const button = pane.addButton({ title });
  button.element.setAttribute("aria-live", "polite");
  const copy = copier(
    () => JSON.stringify(stats, undefined, 2), // an error that is not known yet, Infinity, is null
    container,
    title,
    (text) => {
      button.title = text;
    },
  );
  button.on("click", copy);
}

/** All that is seen of a folded panel. */
function titleOf({ fps, error, converged }: Stats, isPaused: boolean): string {
  const pace = isPaused ? "paused" : converged ? "converged" : `${formatFps(fps)} fps`;
  return `${pace} · ${formatPercent(error)} error`;
}
