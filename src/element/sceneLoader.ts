import { WebGpuError } from "../errors";
import type { Scene } from "../scene/schema";
import { missingWebGpu } from "./describeError";
import { fire } from "./events";
import type { Face } from "./face";
import { fetchScene } from "./fetchScene";
import type { LoadProgressDetail } from "./loadProgress";
import type { ReflectedElement } from "./reflectedElement";
import type { Stage } from "./stage";

/** Whom the loader asks and tells. */
export type SceneLoaderOwner = {
  /** Whether the element is in a document; nothing is loaded elsewhere. */
  readonly isConnected: () => boolean;
  readonly onLoadProgress: (detail: LoadProgressDetail) => void;
  readonly onError: (error: Error) => void;
  /** There was a scene, and is none to be any more. */
  readonly onNothing: () => void;
};

/** Which scene the element shows, the one that was set or what `src` names; and when it is loaded. */
export class SceneLoader {
  readonly #viewer: ReflectedElement;
  readonly #face: Face;
  readonly #stage: Stage;
  readonly #owner: SceneLoaderOwner;
  #scene: Scene | undefined;
  /** What the panel made of the scene in the file. */
  #edited: Scene | undefined;
  /** The scene or URL that was asked for last; `undefined` when there is none, or the GPU has been given back. */
  #requested: Scene | string | undefined;
  /** It has been close enough to what is seen of the page for a lazy element to load. */
  #wasNear = false;
  /** The files that are being read. */
  #opening: AbortController | undefined;

  constructor(viewer: ReflectedElement, face: Face, stage: Stage, owner: SceneLoaderOwner) {
    this.#viewer = viewer;
    this.#face = face;
    this.#stage = stage;
    this.#owner = owner;
  }

  /** The one that was set, or that the panel made of the one in the file. */
  get scene(): Scene | undefined {
    return this.#scene ?? this.#edited;
  }
  set scene(scene: Scene | undefined) {
    this.#opening?.abort();
    this.#scene = scene;
    this.load();
  }

  /** Whether the element is near enough to be loaded, and stays so. */
  get wasNear(): boolean {
    return this.#wasNear;
  }

  /** Whether what is to be shown is what was asked for last. */
  get isCurrent(): boolean {
    return this.#source() === this.#requested;
  }

  /** The attribute `src` has changed. */
  noteSrc(): void {
    this.#opening?.abort();
    if (this.#scene === undefined) this.load();
  }

  /** The attribute `loading` has changed. */
  noteLoading(): void {
    if (this.#requested === undefined) this.load();
  }

  /** The element is less than a screen away from what is seen of the page. */
  noteNear(): void {
    this.#wasNear = true;
    if (this.#requested === undefined) this.load();
  }

  /** The panel shows the scene changed to this. */
  noteEdit(scene: Scene): void {
    if (this.#scene === undefined) this.#edited = scene;
    else this.#scene = this.#requested = scene;
  }

  /** The GPU has been given back: whatever is to be shown has to be asked for anew. */
  forget(): void {
    this.#requested = undefined;
  }

  /** Loads what is to be shown, though it may be shown already. */
  load(): void {
    if (!this.#owner.isConnected()) return;
    const source = this.#source();
    if (source === undefined && this.#requested !== undefined) this.#owner.onNothing();
    if (source === undefined || (this.#viewer.loading === "lazy" && !this.#wasNear)) return;
    this.#requested = source;
    this.#edited = undefined;
    const missing = missingWebGpu({ hasGpu: "gpu" in navigator, isSecure: globalThis.isSecureContext });
    if (missing !== undefined) {
      this.#owner.onError(new WebGpuError(missing));
      return;
    }
    const { baseURI } = this.#viewer.ownerDocument;
    this.#face.noteLoading();
    void this.#stage.show(async (signal, report) => {
      if (typeof source !== "string") return source;
      report("fetching");
      return this.#fetch(source, baseURI, signal);
    });
  }

  /**
   * Shows a file as if its scene had been set.
   *
   * @throws {LoadError} if it cannot be read. An `AbortError` if another scene was set meanwhile.
   */
  async open(files: readonly Blob[]): Promise<void> {
    this.#opening?.abort();
    const opening = new AbortController();
    this.#opening = opening;
    this.#owner.onLoadProgress({ phase: "fetching", fraction: undefined });
    try {
      const { readFiles } = await import("../loaders/readFiles");
      const { scene, warnings } = await readFiles(files, opening.signal);
      opening.signal.throwIfAborted();
      this.scene = scene;
      this.#warn(warnings);
    } catch (error) {
      if (!opening.signal.aborted) this.#face.hideProgress();
      throw error;
    }
  }

  #source(): Scene | string | undefined {
    return this.#scene ?? (this.#viewer.src === "" ? undefined : this.#viewer.src);
  }

  async #fetch(src: string, base: string, signal: AbortSignal): Promise<Scene> {
    const { scene, warnings } = await fetchScene(src, base, signal);
    if (!signal.aborted) this.#warn(warnings);
    return scene;
  }

  #warn(warnings: readonly string[]): void {
    if (warnings.length > 0) fire(this.#viewer, "loadwarnings", { warnings });
  }
}
