import type { Panel, PanelKnobs, PanelOptions, SceneEditor, ScenePart } from "../panel/panel";

/** What the panel shows and whom it tells. */
export type PanelSource = Pick<PanelOptions, "stats" | "knobs" | "onChange" | "onReset" | "isPaused" | "wgsl"> & {
  readonly editor: SceneEditor;
};

/** Below this the panel would hide the picture, so it starts folded. CSS pixels. */
const ROOMY = { width: 400, height: 260 };

/** What goes on in the corner of the element where the panel sits. */
export class PanelHost {
  readonly #corner: HTMLElement;
  #panel: Panel | undefined;
  #source: PanelSource | undefined;
  #selected: ScenePart | undefined;
  /** Counts calls of `show` and `hide`: what was asked for last, holds. */
  #turn = 0;

  constructor(corner: HTMLElement) {
    this.#corner = corner;
  }

  /** Shows a panel for this source, in place of one for other stats. Fails if the panel's code cannot be loaded. */
  async show(source: PanelSource, isFolded: boolean): Promise<void> {
    const isShown = this.#source?.stats === source.stats;
    if (!isShown) this.hide();
    this.#source = source;
    if (isShown) {
      this.#selected = undefined;
      this.#panel?.setKnobs(source.knobs);
      this.#panel?.setScene(source.editor.scene);
      return;
    }
    const turn = this.#turn;
    const { createPanel } = await import("../panel/panel");
    if (turn === this.#turn) this.#create(createPanel, this.#source, isFolded); // the source may be a newer one
  }

  #create(createPanel: (options: PanelOptions) => Panel, source: PanelSource, isFolded: boolean): void {
    const room = this.#corner.parentNode instanceof ShadowRoot ? this.#corner.parentNode.host : this.#corner;
    const isExpanded = !isFolded && room.clientWidth >= ROOMY.width && room.clientHeight >= ROOMY.height;
    const onSelect = (part: ScenePart | undefined) => {
      this.#selected = part;
      source.editor.onSelect(part);
    };
    const editor = { ...source.editor, onSelect };
    this.#panel = createPanel({ container: this.#corner, isExpanded, ...source, editor });
    this.#panel.select(this.#selected);
  }

  /** What the panel has the knobs of. */
  get selected(): ScenePart | undefined {
    return this.#selected;
  }

  select(part: ScenePart | undefined): void {
    this.#selected = part;
    this.#panel?.select(part);
  }

  hide(): void {
    this.#turn += 1;
    this.#panel?.dispose();
    this.#panel = undefined;
    this.#source = undefined;
    this.#selected = undefined;
  }

  /** Shows knobs that were turned elsewhere. */
  setKnobs(knobs: PanelKnobs): void {
    this.#panel?.setKnobs(knobs);
  }

  /** To be called every frame; cheap. */
  refresh(): void {
    this.#panel?.refresh();
  }
}
