import type { PanelKnobs, ScenePart } from "../panel/panel";
import type { PathTracer } from "../renderer/pathTracer";
import type { ResolvedScene } from "../scene/schema";
import type { PickDetail } from "./events";
import type { PanelOwner } from "./lazyPanel";
import { PanelHost, type PanelSource } from "./panelHost";
import { bindPicking, type PickingTarget } from "./picking";
import { createSceneEdits } from "./sceneEdits";

/** Connects the panel with its element: what it shows, what its knobs do, and that a click on the picture picks. */
export class PanelWiring {
  readonly #owner: PanelOwner;
  readonly #host: PanelHost;
  /** The connection whose clicks pick. */
  #picking: AbortSignal | undefined;

  constructor(owner: PanelOwner) {
    this.#owner = owner;
    this.#host = new PanelHost(owner.face.corner);
  }

  /**
   * Shows the panel of a tracer.
   *
   * @param signal - of the time the element is in a document.
   */
  async show(tracer: PathTracer, signal: AbortSignal): Promise<void> {
    const { viewer, face } = this.#owner;
    if (signal !== this.#picking) bindPicking(viewer, face.canvas, this.#pickingTarget(), signal);
    this.#picking = signal;
    await this.#host.show(this.#source(tracer), viewer.getAttribute("stats") === "folded");
  }

  hide(): void {
    this.#host.hide();
  }

  showKnobs(): void {
    const { tracer } = this.#owner.viewer;
    if (tracer !== undefined) this.#host.setKnobs(this.#knobs(tracer));
  }

  refresh(): void {
    this.#host.refresh();
  }

  /** Only while the panel is there, which shows what is picked. */
  #pickingTarget(): PickingTarget {
    const { viewer, onError } = this.#owner;
    return {
      tracer: () => (viewer.showStats ? viewer.tracer : undefined),
      onPick: (part) => {
        if (part === undefined && this.#host.selected === undefined) return;
        this.#host.select(part);
        this.#tellPick(part);
      },
      onError,
    };
  }

  #source(tracer: PathTracer): PanelSource {
    const { viewer, onEdit } = this.#owner;
    return {
      stats: tracer.stats,
      knobs: this.#knobs(tracer),
      onChange: ({ exposure, ...settings }) => {
        if (exposure !== undefined) viewer.exposure = exposure;
        viewer.settings = settings;
      },
      onReset: () => viewer.reset(),
      isPaused: () => viewer.paused,
      wgsl: () => tracer.program.wgsl,
      editor: {
        scene: tracer.scene,
        onEdit: (scene) => onEdit(scene, createSceneEdits),
        onSelect: (part) => this.#tellPick(part),
      },
    };
  }

  #knobs(tracer: PathTracer): PanelKnobs {
    const { exposure, settings } = this.#owner.viewer;
    return { ...settings, exposure, maxBounces: settings.maxBounces ?? tracer.scene.maxBounces };
  }

  #tellPick(part: ScenePart | undefined): void {
    const { viewer, onPick } = this.#owner;
    if (viewer.tracer !== undefined) onPick(pickDetail(viewer.tracer.scene, part));
  }
}

/** What the event `pick` tells of a part of the scene, or of none. */
function pickDetail({ objects, lights }: ResolvedScene, part: ScenePart | undefined): PickDetail {
  if (part === undefined) return { kind: "none" };
  const { kind, index } = part;
  return kind === "object" ? { kind, index, object: objects[index]! } : { kind, index, light: lights[index]! };
}
