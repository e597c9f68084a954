import { RtViewerError, WebGpuError } from "../errors";
import type { PanelKnobs, ScenePart } from "../panel/panel";
import type { PathTracer } from "../renderer/pathTracer";
import type { Stats } from "../renderer/stats";
import type { View } from "../renderer/view";
import type { ResolvedCamera, Scene } from "../scene/schema";
import { OBSERVED_ATTRIBUTES, settingOfAttribute } from "./attributes";
import { parseCameraOrbit } from "./cameraOrbit";
import { createKeyHelp, labelCanvas } from "./canvasLabel";
import { canvasSize } from "./canvasSize";
import { Curtain } from "./curtain";
import { describeError, missingWebGpu } from "./describeError";
import { pickDetail, type RtViewerEventMap } from "./events";
import { fetchScene } from "./fetchScene";
import { LiveRegion } from "./liveRegion";
import type { LoadProgressDetail } from "./loadProgress";
import { MessageBox } from "./messageBox";
import type { PanelHost, PanelSource } from "./panelHost";
import type { PickingTarget } from "./picking";
import { ReflectedElement } from "./reflectedElement";
import { RenderLoop } from "./renderLoop";
import type { EditedTracer, SceneEdits } from "./sceneEdits";
import { Stage } from "./stage";
import { elementStyles } from "./styles";
import { currentBox, watchBox, watchNearness, watchReducedMotion, watchVisibility } from "./watchers";

/** How long an element may be out of the document before it gives back the GPU: a move in the document costs nothing. */
const DISPOSAL_GRACE_MS = 10;

/**
 * `<rt-viewer src="scene.json" controls stats></rt-viewer>`: a path-traced scene in a page.
 *
 * Its attributes and properties are described at `ReflectedElement`, its events at `RtViewerEventMap`.
 *
 * @slot poster - Shown until there is a picture, in place of the attribute `poster`.
 * @slot fallback - Shown where there can be no picture, in place of the message; not where the scene has a mistake.
 * @csspart canvas - The picture.
 * @csspart poster - The image of the attribute `poster`.
 * @csspart progress - The bar that shows how far a scene is that takes long.
 * @csspart panel - The corner with figures and knobs.
 * @csspart drop - The frame while files are dragged over the element, with `drop`.
 * @csspart message - What is said in place of a picture that cannot be shown.
 * @cssprop --rt-viewer-background - Behind messages, and where there is no picture yet.
 * @cssprop --rt-viewer-color - Text of messages.
 * @cssprop --rt-viewer-error-color - Titles of messages.
 * @cssprop --rt-viewer-accent-color - The progress bar.
 * @cssprop --rt-viewer-focus-color - Outline while the keyboard moves the camera.
 * @cssprop --rt-viewer-touch-action - With controls; `pan-y` by default: a finger that sets out upright scrolls the page, one
 * that sets out sideways turns the view, two pan and zoom. `none` takes every touch.
 */
export class RtViewerElement extends ReflectedElement {
  static readonly observedAttributes = OBSERVED_ATTRIBUTES;

  readonly #canvas: HTMLCanvasElement;
  readonly #curtain: Curtain;
  readonly #liveRegion: LiveRegion;
  readonly #message: MessageBox;
  readonly #corner: HTMLElement;
  /** Of the corner; its code is loaded when the panel is asked for. */
  #panel: PanelHost | undefined;
  /** The connection whose clicks pick. */
  #picking: AbortSignal | undefined;
  readonly #stage: Stage;
  readonly #loop = new RenderLoop(() => this.#tick());
  #scene: Scene | undefined;
  /** What the panel made of the scene in the file. */
  #edited: Scene | undefined;
  /** The scene or URL that was asked for last; `undefined` when there is none, or the GPU has been given back. */
  #requested: Scene | string | undefined;
  #isVisible = false;
  /** It has been close enough to what is seen of the page for a lazy element to load. */
  #wasNear = false;
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
    this.#curtain = new Curtain(this.ownerDocument);
    this.#liveRegion = new LiveRegion(this.ownerDocument);
    this.#message = new MessageBox(this.ownerDocument);
    this.#corner = this.ownerDocument.createElement("div");
    this.#corner.className = "panel";
    this.#corner.setAttribute("part", "panel");
    root.append(
      this.#canvas,
      this.#curtain.element,
      this.#corner,
      this.#message.element,
      this.#liveRegion.element,
      createKeyHelp(this.ownerDocument),
    );
    this.#stage = new Stage(this.#canvas, {
      onLoadProgress: (detail) => this.#onLoadProgress(detail),
      onScene: () => this.#onScene(),
      onReady: (detail) => {
        this.#curtain.open();
        this.#liveRegion.noteReady();
        this.#emit("ready", detail);
      },
      onProgress: (detail) => this.#emit("progress", detail),
      onConverged: (detail) => {
        this.#liveRegion.noteConverged();
        this.#emit("converged", detail);
      },
      onDeviceLost: (detail) => {
        this.#showPanel();
        this.#emit("devicelost", detail);
      },
      onError: (error) => this.#fail(error),
      onRefusal: (error) => this.#emit("error", { error }),
    });
  }

  /**
   * The scene shown: as it was set, or as it was changed in the panel, with every default filled in and the camera where its
   * author put it; `undefined` while what `src` names is shown unchanged. Setting one overrides `src`; `undefined` gives way to
   * `src` again.
   */
  get scene(): Scene | undefined {
    return this.#scene ?? this.#edited;
  }
  set scene(scene: Scene | undefined) {
    this.#opening?.abort();
    this.#scene = scene;
    this.#load();
  }

  /**
   * Where the picture is seen from: the scene's camera, then wherever it was moved. `undefined` before there is a scene.
   * Setting it changes the fields it names; before there is a scene, they are kept for it.
   */
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
   * Figures of the tracer: a live object. Setting it sets the attribute `stats`, a text as it is and a boolean as `showStats`
   * does, because frameworks set a property of that name rather than the attribute.
   */
  get stats(): Stats | undefined {
    return this.tracer?.stats;
  }
  set stats(isShown: boolean | "" | "folded") {
    if (typeof isShown === "string") this.setAttribute("stats", isShown);
    else this.showStats = isShown;
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
    this.#onLoadProgress({ phase: "fetching", fraction: undefined });
    try {
      const { readFiles } = await import("../loaders/readFiles");
      const { scene, warnings } = await readFiles(files, opening.signal);
      opening.signal.throwIfAborted();
      this.scene = scene;
      this.#warn(warnings);
    } catch (error) {
      if (!opening.signal.aborted) this.#curtain.hideProgress();
      throw error;
    }
  }

  /** Throws away what has been sampled and starts over. Where a message stands in place of the picture, loads the scene again. */
  reset(): void {
    if (this.#message.isShown) this.#load();
    else this.tracer?.reset();
  }

  /**
   * What has been sampled, as the tracer gives it: RGBA, linear Rec. 709, top row first, `tracer.width · tracer.height`
   * pixels.
   *
   * @throws {RtViewerError} before `ready`, and if the device fails or is lost meanwhile.
   */
  async readRadiance(): Promise<Float32Array> {
    return this.#sampledTracer().readRadiance();
  }

  /**
   * What has been sampled at the moment of the call, as an image file.
   *
   * @param type - `"image/png"` by default, or another type that the browser's canvas encodes: tone-mapped. Of
   * `"image/x-portable-floatmap"` it is linear float, without exposure or tone mapping.
   * @param quality - 0…1, for types that have one.
   * @throws {RtViewerError} before `ready`, if the device fails or is lost meanwhile, and if the browser cannot encode it.
   */
  async toBlob(type = "image/png", quality?: number): Promise<Blob> {
    const tracer = this.#sampledTracer();
    const { width, height } = tracer;
    const isLinear = type === "image/x-portable-floatmap";
    const [pixels, { encodePicture }] = await Promise.all([
      isLinear ? tracer.readRadiance() : tracer.readPicture(this.#look()),
      import("./snapshot"),
    ]);
    return encodePicture(pixels, width, height, type, quality);
  }

  /** The picture as a PNG, or as a Portable FloatMap with the radiance as it was sampled. Like `toBlob`. */
  screenshot(format: "png" | "pfm" = "png"): Promise<Blob> {
    return this.toBlob(format === "pfm" ? "image/x-portable-floatmap" : "image/png");
  }

  connectedCallback(): void {
    this.upgradeProperties();
    clearTimeout(this.#disposal);
    this.#connection = new AbortController();
    const { signal } = this.#connection;

    this.#stage.size = canvasSize(currentBox(this.#canvas));
    this.#stage.refresh();
    watchBox(this.#canvas, (box) => (this.#stage.size = canvasSize(box)), signal);
    watchVisibility(this, (isVisible) => this.#onVisibility(isVisible), signal);
    watchReducedMotion((isReduced) => (this.#stage.isCalm = isReduced), signal);
    if (!this.#wasNear) watchNearness(this, () => this.#onNear(), signal);
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
    else if (name === "loading" && this.#requested === undefined) this.#load();
    else if (name === "controls") this.#bindControls();
    else if (name === "drop") this.#bindDrop();
    else if (name === "stats") this.#showPanel();
    else if (name === "alt") this.#label();
    else if (name === "paused") this.#stage.isPaused = this.paused;
    else if (name === "exposure" || name === "tone-map") this.#stage.look = this.#look();
    else if (name === "camera-orbit") this.#stage.orbit = parseCameraOrbit(this.cameraOrbit);
    else if (settingOfAttribute(name) !== undefined) this.settingsChanged();
    if (name === "controls") this.#label();
    if (name === "poster" || name === "loading") this.#curtain.setPoster(this.poster, this.loading);
    if (this.tracer !== undefined) this.#panel?.setKnobs(this.#knobs(this.tracer));
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
    if (source === undefined && this.#requested !== undefined) this.#dispose();
    if (source === undefined || (this.loading === "lazy" && !this.#wasNear)) return;
    this.#requested = source;
    this.#edited = undefined;
    const missing = missingWebGpu({ hasGpu: "gpu" in navigator, isSecure: globalThis.isSecureContext });
    if (missing !== undefined) {
      this.#fail(new WebGpuError(missing));
      return;
    }
    const { baseURI } = this.ownerDocument;
    this.#liveRegion.noteLoading();
    void this.#stage.show(async (signal, report) => {
      if (typeof source !== "string") return source;
      report("fetching");
      return this.#fetch(source, baseURI, signal);
    });
  }

  #onNear(): void {
    this.#wasNear = true;
    if (this.#requested === undefined) this.#load();
  }

  async #fetch(src: string, base: string, signal: AbortSignal): Promise<Scene> {
    const { scene, warnings } = await fetchScene(src, base, signal);
    if (!signal.aborted) this.#warn(warnings);
    return scene;
  }

  #warn(warnings: readonly string[]): void {
    if (warnings.length > 0) this.#emit("loadwarnings", { warnings });
  }

  #onLoadProgress(detail: LoadProgressDetail): void {
    this.#curtain.showProgress(detail);
    this.#emit("loadprogress", detail);
  }

  #onScene(): void {
    this.#clearMessage();
    this.#showPanel();
    this.#updateLoop();
  }

  #tick(): void {
    this.#stage.tick();
    this.#panel?.refresh();
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
    this.#canvas.inert = true;
    this.#curtain.hideProgress();
    this.#liveRegion.clear();
    this.#updateLoop();
    this.#emit("error", { error });
  }

  #dispose(): void {
    this.#requested = undefined;
    this.#panel?.hide();
    this.#clearMessage();
    this.#curtain.close();
    this.#liveRegion.clear();
    this.#stage.clear();
    this.#updateLoop();
  }

  #clearMessage(): void {
    this.#message.clear();
    this.#canvas.inert = false;
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
      this.#panel?.hide();
      return;
    }
    // Without its panel the element still does its work, so this is told, not shown.
    this.#loadPanel(this.tracer).catch((error: Error) => this.#emit("error", { error }));
  }

  async #loadPanel(tracer: PathTracer): Promise<void> {
    const { PanelHost, bindPicking, createSceneEdits } = await import("./panelHost");
    if (tracer !== this.tracer || !this.showStats || this.#connection === undefined) return;
    this.#panel ??= new PanelHost(this.#corner);
    const { signal } = this.#connection;
    if (signal !== this.#picking) bindPicking(this, this.#canvas, this.#pickingTarget(this.#panel), signal);
    this.#picking = signal;
    await this.#panel.show(this.#panelSource(tracer, createSceneEdits), this.getAttribute("stats") === "folded");
  }

  /** Only while the panel is there, which shows what is picked. */
  #pickingTarget(panel: PanelHost): PickingTarget {
    return {
      tracer: () => (this.showStats ? this.tracer : undefined),
      onPick: (part) => {
        if (part === undefined && panel.selected === undefined) return;
        panel.select(part);
        this.#tellPick(part);
      },
      onError: (error) => this.#emit("error", { error }),
    };
  }

  #panelSource(tracer: PathTracer, createSceneEdits: (tracer: EditedTracer) => SceneEdits): PanelSource {
    return {
      stats: tracer.stats,
      knobs: this.#knobs(tracer),
      onChange: ({ exposure, ...settings }) => {
        if (exposure !== undefined) this.exposure = exposure;
        this.settings = settings;
      },
      onReset: () => this.reset(),
      isPaused: () => this.paused,
      wgsl: () => tracer.program.wgsl,
      editor: {
        scene: tracer.scene,
        onEdit: (scene) => this.#edit(scene, createSceneEdits),
        onSelect: (part) => this.#tellPick(part),
      },
    };
  }

  #knobs(tracer: PathTracer): PanelKnobs {
    const { exposure, settings } = this;
    return { ...settings, exposure, maxBounces: settings.maxBounces ?? tracer.scene.maxBounces };
  }

  #edit(scene: Scene, createEdits: (tracer: EditedTracer) => SceneEdits): void {
    if (!this.#stage.edit(scene, createEdits)) return;
    if (this.#scene === undefined) this.#edited = scene;
    else this.#scene = this.#requested = scene;
  }

  #tellPick(part: ScenePart | undefined): void {
    if (this.tracer !== undefined) this.#emit("pick", pickDetail(this.tracer.scene, part));
  }

  #label(): void {
    labelCanvas(this.#canvas, this.alt, this.controls);
  }

  #look(): View {
    return { exposure: this.exposure, toneMap: this.toneMap };
  }

  #sampledTracer(): PathTracer {
    const { tracer } = this;
    if (tracer === undefined || tracer.stats.samples === 0) {
      throw new RtViewerError("there is no picture yet: wait for the event `ready`");
    }
    return tracer;
  }

  #emit<K extends keyof RtViewerEventMap>(type: K, detail: RtViewerEventMap[K]["detail"]): void {
    this.dispatchEvent(new CustomEvent(type, { detail }));
  }
}
