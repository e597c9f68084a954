import { WebGpuError } from "../errors";
import type { PanelKnobs } from "../panel/panel";
import type { PathTracer } from "../renderer/pathTracer";
import type { Stats } from "../renderer/stats";
import type { ResolvedCamera, Scene } from "../scene/schema";
import { OBSERVED_ATTRIBUTES, settingOfAttribute } from "./attributes";
import { canvasSize } from "./canvasSize";
import { describeError, missingWebGpu } from "./describeError";
import type { RtViewerEventMap } from "./events";
import { fetchScene } from "./fetchScene";
import { MessageBox } from "./messageBox";
import { PanelHost } from "./panelHost";
import { ReflectedElement } from "./reflectedElement";
import { RenderLoop } from "./renderLoop";
import { Stage } from "./stage";
import { elementStyles } from "./styles";
import { currentBox, watchBox, watchVisibility } from "./watchers";

/** How long an element may be out of the document before it gives back the GPU: a move in the document costs nothing. */
const DISPOSAL_GRACE_MS = 10;

const DEFAULT_LABEL = "3D scene";

/** What a page may have set before the element was defined. */
const UPGRADED_PROPERTIES = [
  "src",
  "controls",
  "drop",
  "stats",
  "showStats",
  "paused",
  "alt",
  "exposure",
  "settings",
  "scene",
];

/**
 * `<rt-viewer src="scene.json" controls stats></rt-viewer>`: a path-traced scene in a page.
 *
 * Its attributes and properties are described at `ReflectedElement`, its events at `RtViewerEventMap`. Parts for styling:
 * `canvas`, `panel`, `message`.
 */
export class RtViewerElement extends ReflectedElement {
  static readonly observedAttributes = OBSERVED_ATTRIBUTES;

  readonly #canvas: HTMLCanvasElement;
  readonly #message: MessageBox;
  readonly #panel: PanelHost;
  readonly #stage: Stage;
  readonly #loop = new RenderLoop(() => this.#tick());
  #scene: Scene | undefined;
  /** The scene or URL that was asked for last; `undefined` when there is none, or the GPU has been given back. */
  #requested: Scene | string | undefined;
  #isVisible = false;
  /** Ends the listeners and observers of the time the element is in a document. */
  #connection: AbortController | undefined;
  #controls: AbortController | undefined;
  #drop: AbortController | undefined;
  /** The files that are being read. */
  #opening: AbortController | undefined;
  #disposal: ReturnType<typeof setTimeout> | undefined;

  constructor() {
    super();
    const root = this.attachShadow({ mode: "open", delegatesFocus: true });
    root.adoptedStyleSheets = [elementStyles()];
    this.#canvas = this.ownerDocument.createElement("canvas");
    this.#canvas.setAttribute("part", "canvas");
    this.#canvas.setAttribute("role", "img");
    this.#message = new MessageBox(this.ownerDocument);
    this.#panel = new PanelHost(this.ownerDocument);
    root.append(this.#canvas, this.#panel.element, this.#message.element);
    this.#stage = new Stage(this.#canvas, {
      onScene: () => this.#onScene(),
      onReady: (detail) => this.#emit("ready", detail),
      onProgress: (detail) => this.#emit("progress", detail),
      onConverged: (detail) => this.#emit("converged", detail),
      onError: (error) => this.#fail(error),
    });
  }

  /** The scene shown, as it was set. Setting one overrides `src`; `undefined` gives way to `src` again. */
  get scene(): Scene | undefined {
    return this.#scene;
  }
  set scene(scene: Scene | undefined) {
    this.#opening?.abort();
    this.#scene = scene;
    this.#load();
  }

  /** Where the picture is seen from: the scene's camera, then wherever it was moved. `undefined` before there is a scene. */
  get camera(): ResolvedCamera | undefined {
    return this.#stage.camera;
  }
  set camera(changes: Partial<ResolvedCamera>) {
    this.#stage.moveCamera(changes);
  }

  /**
   * What does the work; `undefined` until the scene is compiled, and after the element has left the document.
   *
   * The element sets its size: the canvas's, or a smaller one of the same proportions while the camera, the scene or the
   * canvas changes from frame to frame and the adapter can't do a sample of every pixel in a frame. It sets its
   * `samplesPerFrame` likewise.
   */
  get tracer(): PathTracer | undefined {
    return this.#stage.tracer;
  }

  /**
   * Figures of the tracer: a live object. Setting a boolean sets the attribute `stats` (see `showStats`), which is what
   * frameworks do that set properties rather than attributes.
   */
  get stats(): Stats | undefined {
    return this.tracer?.stats;
  }
  set stats(isShown: boolean) {
    this.showStats = isShown;
  }

  /**
   * Shows a file, as if its scene had been set: one that was picked or dropped.
   *
   * @param files - a scene, JSON or glTF, and the files it refers to, if any.
   * @throws {LoadError} if it cannot be read; what is shown then stays. An `AbortError` if another scene was set meanwhile.
   */
  async open(...files: readonly Blob[]): Promise<void> {
    this.#opening?.abort();
    const opening = new AbortController();
    this.#opening = opening;
    const { readFiles } = await import("../loaders/readFiles");
    const { scene, warnings } = await readFiles(files, opening.signal);
    opening.signal.throwIfAborted();
    this.scene = scene;
    this.#warn(warnings);
  }

  /** Throws away what has been sampled and starts over. */
  reset(): void {
    this.tracer?.reset();
  }

  connectedCallback(): void {
    this.upgradeProperties(UPGRADED_PROPERTIES);
    clearTimeout(this.#disposal);
    this.#connection = new AbortController();
    const { signal } = this.#connection;

    this.#stage.size = canvasSize(currentBox(this.#canvas));
    this.#stage.refresh();
    watchBox(this.#canvas, (box) => (this.#stage.size = canvasSize(box)), signal);
    watchVisibility(this, (isVisible) => this.#onVisibility(isVisible), signal);
    this.#bindControls();
    this.#bindDrop();
    this.#label();
    if (this.#source() !== this.#requested) this.#load();
    else this.#updateLoop();
  }

  disconnectedCallback(): void {
    this.#connection?.abort();
    this.#connection = undefined;
    this.#controls?.abort();
    this.#drop?.abort();
    this.#updateLoop();
    this.#disposal = setTimeout(() => this.#dispose(), DISPOSAL_GRACE_MS);
  }

  attributeChangedCallback(name: string): void {
    if (name === "src") this.#opening?.abort();
    if (name === "src" && this.#scene === undefined) this.#load();
    else if (name === "controls") this.#bindControls();
    else if (name === "drop") this.#bindDrop();
    else if (name === "stats") this.#showPanel();
    else if (name === "alt") this.#label();
    else if (name === "paused") this.#stage.isPaused = this.paused;
    else if (name === "exposure") this.#stage.exposure = this.exposure;
    else if (settingOfAttribute(name) !== undefined) this.settingsChanged();
    if (this.tracer !== undefined) this.#panel.setKnobs(this.#knobs(this.tracer));
  }

  protected override settingsChanged(): void {
    this.#stage.settings = this.settings;
  }

  #source(): Scene | string | undefined {
    return this.#scene ?? (this.src === "" ? undefined : this.src);
  }

  #load(): void {
    if (this.#connection === undefined) return;
    const source = this.#source();
    this.#requested = source;
    if (source === undefined) {
      this.#dispose();
      return;
    }
    const missing = missingWebGpu({ hasGpu: "gpu" in navigator, isSecure: globalThis.isSecureContext });
    if (missing !== undefined) {
      this.#fail(new WebGpuError(missing));
      return;
    }
    const { baseURI } = this.ownerDocument;
    void this.#stage.show(async (signal) =>
      typeof source === "string" ? this.#fetch(source, baseURI, signal) : source,
    );
  }

  async #fetch(src: string, base: string, signal: AbortSignal): Promise<Scene> {
    const { scene, warnings } = await fetchScene(src, base, signal);
    if (!signal.aborted) this.#warn(warnings);
    return scene;
  }

  #warn(warnings: readonly string[]): void {
    if (warnings.length > 0) this.#emit("loadwarnings", { warnings });
  }

  #onScene(): void {
    this.#message.clear();
    this.#showPanel();
    this.#updateLoop();
  }

  #tick(): void {
    this.#stage.tick();
    this.#panel.refresh();
    this.#updateLoop();
  }

  #onVisibility(isVisible: boolean): void {
    this.#isVisible = isVisible;
    this.#updateLoop();
  }

  /** A scene that cannot be seen is left alone, except that its first picture is made, to be there when it can. */
  #updateLoop(): void {
    const isWanted = this.#isVisible || this.#stage.owesPicture;
    this.#loop.isRunning =
      isWanted && this.#connection !== undefined && this.tracer !== undefined && !this.#message.isShown;
  }

  #fail(error: Error): void {
    this.#message.show(describeError(error));
    this.#updateLoop();
    this.#emit("error", { error });
  }

  #dispose(): void {
    this.#requested = undefined;
    this.#panel.hide();
    this.#message.clear();
    this.#stage.clear();
    this.#updateLoop();
  }

  #bindControls(): void {
    this.#controls?.abort();
    this.#controls = undefined;
    if (!this.controls) {
      this.#canvas.removeAttribute("tabindex");
      return;
    }
    this.#canvas.tabIndex = 0;
    if (this.#connection === undefined) return;
    this.#controls = new AbortController();
    this.#loadControls(this.#controls.signal).catch((error: Error) => this.#emit("error", { error }));
  }

  async #loadControls(signal: AbortSignal): Promise<void> {
    const { bindOrbitControls } = await import("./orbitControls");
    if (signal.aborted) return;
    const target = {
      camera: () => this.camera,
      home: () => this.tracer?.scene.camera,
      onChange: (camera: ResolvedCamera) => this.#stage.moveCamera(camera),
    };
    bindOrbitControls(this.#canvas, target, signal);
  }

  #bindDrop(): void {
    this.#drop?.abort();
    this.#drop = undefined;
    if (!this.drop || this.#connection === undefined) return;
    this.#drop = new AbortController();
    this.#loadDrop(this.#drop.signal).catch((error: Error) => this.#emit("error", { error }));
  }

  async #loadDrop(signal: AbortSignal): Promise<void> {
    const { bindFileDrop } = await import("./fileDrop");
    if (signal.aborted) return;
    const onFiles = (files: readonly File[]) => this.open(...files);
    bindFileDrop(this, this.shadowRoot!, { onFiles }, signal);
  }

  #showPanel(): void {
    if (!this.showStats || this.tracer === undefined) {
      this.#panel.hide();
      return;
    }
    const source = {
      stats: this.tracer.stats,
      knobs: this.#knobs(this.tracer),
      onChange: ({ exposure, ...settings }: Partial<PanelKnobs>) => {
        if (exposure !== undefined) this.exposure = exposure;
        this.settings = settings;
      },
      onReset: () => this.reset(),
      isPaused: () => this.paused,
    };
    const isFolded = this.getAttribute("stats") === "folded";
    // Without its panel the element still does its work, so this is told, not shown.
    this.#panel.show(source, isFolded).catch((error: Error) => this.#emit("error", { error }));
  }

  #knobs(tracer: PathTracer): PanelKnobs {
    const { samplesPerFrame, lightSamples, exposure } = this;
    return { samplesPerFrame, lightSamples, exposure, maxBounces: this.maxBounces ?? tracer.scene.maxBounces };
  }

  #label(): void {
    this.#canvas.setAttribute("aria-label", this.alt || DEFAULT_LABEL);
  }

  #emit<K extends keyof RtViewerEventMap>(type: K, detail: RtViewerEventMap[K]["detail"]): void {
    this.dispatchEvent(new CustomEvent(type, { detail }));
  }
}
