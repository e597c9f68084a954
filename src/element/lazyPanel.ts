import type { PathTracer } from "../renderer/pathTracer";
import type { Scene } from "../scene/schema";
import type { PickDetail } from "./events";
import type { Face } from "./face";
import type { PanelWiring } from "./panelWiring";
import type { RtViewerElement } from "./rtViewerElement";
import type { EditedTracer, SceneEdits } from "./sceneEdits";

/** The element that a panel belongs to, with what of it a page does not see. */
export type PanelOwner = {
  readonly viewer: RtViewerElement;
  readonly face: Face;
  /** Aborted when the element leaves the document it is in; `undefined` while it is in none. */
  readonly connection: () => AbortSignal | undefined;
  /** Shows the scene changed to this one. */
  readonly onEdit: (scene: Scene, createEdits: (tracer: EditedTracer) => SceneEdits) => void;
  readonly onPick: (detail: PickDetail) => void;
  readonly onError: (error: Error) => void;
};

/** The panel of an element. Its code, and that of its wiring, is loaded when it is first shown. */
export class LazyPanel {
  readonly #owner: PanelOwner;
  #wiring: PanelWiring | undefined;

  constructor(owner: PanelOwner) {
    this.#owner = owner;
  }

  /** Shows the panel of the tracer there is, or none where none is wanted. */
  show(): void {
    const { viewer, onError } = this.#owner;
    if (!viewer.showStats || viewer.tracer === undefined) {
      this.hide();
      return;
    }
    // Without its panel the element still does its work, so this is told, not shown.
    this.#load(viewer.tracer).catch(onError);
  }

  hide(): void {
    this.#wiring?.hide();
  }

  /** Shows knobs that were turned elsewhere. */
  showKnobs(): void {
    this.#wiring?.showKnobs();
  }

  /** To be called every frame; cheap. */
  refresh(): void {
    this.#wiring?.refresh();
  }

  async #load(tracer: PathTracer): Promise<void> {
    const { PanelWiring } = await import("./panelWiring");
    const { viewer, connection } = this.#owner;
    const signal = connection();
    if (tracer !== viewer.tracer || !viewer.showStats || signal === undefined) return;
    this.#wiring ??= new PanelWiring(this.#owner);
    await this.#wiring.show(tracer, signal);
  }
}
