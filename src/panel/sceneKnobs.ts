import type { FolderApi, ListBladeApi } from "tweakpane";
import type { ScenePart } from "../scene/parts";
import type { ResolvedScene } from "../scene/schema";
import { nameOf, objectsOf, partsOf, withLight, withMaterial } from "./editScene";
import { addLightKnobs } from "./lightKnobs";
import { addMaterialKnobs } from "./materialKnobs";
import { nameFields } from "./nameFields";

/** A scene whose materials and lights the panel lets one change. */
export type SceneEditor = {
  readonly scene: ResolvedScene;
  /** Called with the changed scene, at most once per frame. */
  readonly onEdit: (scene: ResolvedScene) => void;
  /** Called when an object or a light is chosen in the panel; with `undefined` when none is any more. */
  readonly onSelect: (part: ScenePart | undefined) => void;
};

const NOTHING = -1;

/** The folder with the scene: a list of its objects and lights, and the knobs of the one that is chosen. */
export class SceneKnobs {
  readonly #folder: FolderApi;
  readonly #list: ListBladeApi<number>;
  readonly #editor: SceneEditor;
  #scene: ResolvedScene;
  #parts: readonly ScenePart[] = [];
  #selected: ScenePart | undefined;
  #details: FolderApi | undefined;
  #isEdited = false;
  #isBeingSet = false;

  constructor(pane: FolderApi, editor: SceneEditor) {
    this.#editor = editor;
    this.#scene = editor.scene;
    this.#folder = pane.addFolder({ title: "Scene" });
    this.#list = this.#folder.addBlade({ view: "list", options: [], value: NOTHING }) as ListBladeApi<number>;
    this.#list.element.querySelector("select")?.setAttribute("aria-label", "object or light");
    this.#list.on("change", ({ value }) => {
      if (this.#isBeingSet) return;
      this.#choose(this.#parts[value]);
      editor.onSelect(this.#selected);
    });
    this.show(editor.scene);
  }

  /** Shows another scene, with nothing chosen. */
  show(scene: ResolvedScene): void {
    this.#scene = scene;
    this.#isEdited = false;
    this.#parts = partsOf(scene);
    this.#list.options = [
      { text: "click an object, or choose here", value: NOTHING },
      ...this.#parts.map((part, value) => ({ text: nameOf(scene, part), value })),
    ];
    this.select(undefined);
  }

  /** Shows what was chosen elsewhere; one that is not there counts as none. */
  select(part: ScenePart | undefined): void {
    const index = part
      ? this.#parts.findIndex(({ kind, index }) => kind === part.kind && index === part.index)
      : NOTHING;
    this.#isBeingSet = true;
    this.#list.value = index;
    this.#isBeingSet = false;
    this.#choose(this.#parts[index]);
  }

  /** Hands on what was changed since the last call. To be called every frame. */
  flush(): void {
    if (!this.#isEdited) return;
    this.#isEdited = false;
    this.#editor.onEdit(this.#scene);
  }

  #choose(part: ScenePart | undefined): void {
    this.#selected = part;
    this.#details?.dispose();
    this.#details = part && (part.kind === "object" ? this.#addMaterial(part.index) : this.#addLight(part.index));
    if (this.#details) nameFields(this.#details.element);
  }

  #addMaterial(index: number): FolderApi {
    const { material: name } = this.#scene.objects[index]!;
    const folder = this.#folder.addFolder({ title: `material · ${name}` });
    const others = objectsOf(this.#scene, name).length - 1;
    if (others > 0) {
      const text = others === 1 ? "another object" : `${others} other objects`;
      folder.addBinding({ text }, "text", { readonly: true, label: "also on", interval: 0 });
    }
    addMaterialKnobs(folder, this.#scene.materials[name]!, (material) => {
      this.#edit(withMaterial(this.#scene, name, material));
    });
    return folder;
  }

  #addLight(index: number): FolderApi {
    const light = this.#scene.lights[index]!;
    const folder = this.#folder.addFolder({ title: `${light.type} light` });
    addLightKnobs(folder, light, (changed) => this.#edit(withLight(this.#scene, index, changed)));
    return folder;
  }

  #edit(scene: ResolvedScene): void {
    this.#scene = scene;
    this.#isEdited = true;
  }
}
