import { WebGpuError } from "../errors";
import type { Scene } from "../scene/schema";
import { missingWebGpu } from "./describeError";
import { fire } from "./events";
import type { Face } from "./face";
import type { LoadProgressDetail } from "./loadProgress";
import type { ReflectedElement } from "./reflectedElement";
import { fetchedFile, openedFile, SceneFile } from "./sceneFile";
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

/** Which scene the element shows, the one that was set or what `src` names, and in which variant; and when it is loaded. */
export class SceneLoader {
  readonly #viewer: ReflectedElement;
  readonly #face: Face;
  readonly #stage: Stage;
  readonly #owner: SceneLoaderOwner;
  #scene: Scene | undefined;
  /** What the panel made of the scene in the file. */
  #edited: Scene | undefined;
  /** What the scene is from, if it is from a file: the one that `src` names, or one that was opened. */
  #file: SceneFile | undefined;
  /** The scene or URL that was asked for last; `undefined` when there is none, or the GPU has been given back. */
  #requested: Scene | string | undefined;
  /** The variant of the file that was asked for last. */
  #variant: string | undefined;
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
    this.#setFile(undefined);
    this.#scene = scene;
    this.load();
  }

  /** Names of the file's variants; empty until it has been read. */
  get variants(): readonly string[] {
    return this.#file?.variants ?? [];
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

  /** The attribute `variant-name` may have changed: shows that variant, seen from where the camera is. */
  noteVariant(): void {
    const [file, before, wanted] = [this.#file, this.#variant, this.#wantedVariant];
    if (file === undefined || wanted === before || this.#requested === undefined || !this.#owner.isConnected()) return;
    this.#variant = wanted;
    const warning = file.warningFor(wanted);
    if (warning !== undefined) this.#warn([warning], warning);
    if (file.shownFor(wanted) !== file.shownFor(before)) this.#show(file);
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
    if (this.#scene === undefined) this.#setFile(undefined);
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
    if (typeof source === "string") this.#setFile(fetchedFile(source, this.#viewer.ownerDocument.baseURI));
    const isRead = typeof source !== "string" && (this.#file === undefined || this.#variant === this.#wantedVariant);
    this.#variant = this.#wantedVariant;
    this.#show(isRead ? source : this.#file!);
  }

  /**
   * Shows a file as if its scene had been set.
   *
   * @throws {LoadError} if it cannot be read. An `AbortError` if another scene was set meanwhile.
   */
  async open(files: readonly Blob[]): Promise<void> {
    this.#opening?.abort();
    const opening = new AbortController();
    const { signal } = opening;
    this.#opening = opening;
    this.#owner.onLoadProgress({ phase: "fetching", fraction: undefined });
    try {
      const file = openedFile(files);
      const variant = this.#wantedVariant;
      const { scene, warnings } = await file.read(variant, signal);
      signal.throwIfAborted();
      this.#setFile(file);
      this.#variant = variant;
      this.#scene = scene;
      this.load();
      this.#warn(warnings, file.warningFor(variant));
    } catch (error) {
      if (!opening.signal.aborted) this.#face.hideProgress();
      throw error;
    }
  }

  #source(): Scene | string | undefined {
    return this.#scene ?? (this.#viewer.src === "" ? undefined : this.#viewer.src);
  }

  get #wantedVariant(): string | undefined {
    return this.#viewer.variantName || undefined;
  }

  #setFile(file: SceneFile | undefined): void {
    if (this.#file !== undefined) {
      this.#stage.stopLoading(); // or the end of the download would be told as an error
      this.#file.close();
    }
    this.#file = file;
  }

  /** Shows a scene, or the variant that was asked for last. */
  #show(source: Scene | SceneFile): void {
    const variant = this.#variant;
    this.#face.noteLoading();
    void this.#stage.show(async (signal, report) => {
      if (!(source instanceof SceneFile)) return source;
      report("fetching");
      return this.#read(source, variant, signal);
    }, this.#file);
  }

  async #read(file: SceneFile, variant: string | undefined, signal: AbortSignal): Promise<Scene> {
    const { scene, warnings } = await file.read(file.shownFor(variant), signal);
    if (signal.aborted) return scene;
    this.#edited = undefined;
    if (this.#scene !== undefined) this.#scene = this.#requested = scene; // of files that were opened
    this.#warn(warnings, file.warningFor(variant));
    return scene;
  }

  /** @param ofVariant - the one about the variant's name, if that is wrong. */
  #warn(warnings: readonly string[], ofVariant: string | undefined): void {
    // biome-ignore lint/suspicious/noConsole: the others are about the file; this one is a mistake of the page's author.
    if (ofVariant !== undefined && warnings.includes(ofVariant)) console.warn(`<rt-viewer>: ${ofVariant}`);
    if (warnings.length > 0) fire(this.#viewer, "loadwarnings", { warnings });
  }
}
