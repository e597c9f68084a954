import { RtViewerError } from "../errors";
import type { PathTracer } from "../renderer/pathTracer";
import type { Stats } from "../renderer/stats";
import type { ResolvedCamera, Scene } from "../scene/schema";
import { applyAttribute, OBSERVED_ATTRIBUTES, type ViewerParts } from "./attributes";
import { BoundOnDemand } from "./boundOnDemand";
import { canvasSize } from "./canvasSize";
import { fire } from "./events";
import { Face } from "./face";
import { LazyPanel } from "./lazyPanel";
import type { LoadProgressDetail } from "./loadProgress";
import { ReflectedElement } from "./reflectedElement";
import { RenderLoop } from "./renderLoop";
import { SceneLoader } from "./sceneLoader";
import { Stage } from "./stage";
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

  readonly #parts: ViewerParts;
  readonly #loop = new RenderLoop(() => this.#tick());
  #isVisible = false;
  /** Ends the listeners and observers of the time the element is in a document. */
  #connection: AbortController | undefined;
  #disposal: ReturnType<typeof setTimeout> | undefined;

  constructor() {
    super();
    const onError = (error: Error) => fire(this, "error", { error });
    const face = new Face(this);
    const stage = this.#createStage(face);
    const scenes = new SceneLoader(this, face, stage, {
      isConnected: () => this.#connection !== undefined,
      onLoadProgress: (detail) => this.#onLoadProgress(detail),
      onError: (error) => this.#fail(error),
      onNothing: () => this.#dispose(),
    });
    const panel = new LazyPanel({
      viewer: this,
      face,
      connection: () => this.#connection?.signal,
      onEdit: (scene, createEdits) => {
        if (stage.edit(scene, createEdits)) scenes.noteEdit(scene);
      },
      onPick: (detail) => fire(this, "pick", detail),
      onError,
    });
    const controls = new BoundOnDemand(
      () => this.controls && this.#connection !== undefined,
      (signal) => this.#bindControls(signal),
      onError,
    );
    const drop = new BoundOnDemand(
      () => this.drop && this.#connection !== undefined,
      (signal) => this.#bindDrop(signal),
      onError,
    );
    this.#parts = { face, stage, scenes, panel, controls, drop };
  }

  /**
   * The scene shown: as it was set, or as it was changed in the panel, with every default filled in and the camera where its
   * author put it; `undefined` while what `src` names is shown unchanged. Setting one overrides `src`; `undefined` gives way to
   * `src` again.
   */
  get scene(): Scene | undefined {
    return this.#parts.scenes.scene;
  }
  set scene(scene: Scene | undefined) {
    this.#parts.scenes.scene = scene;
  }

  /**
   * Names for `variantName`, in the order of the file; empty before it is loaded, and where it has none. They are there when
   * `ready` comes.
   */
  get variants(): readonly string[] {
    return this.#parts.scenes.variants;
  }

  /**
   * Where the picture is seen from: the scene's camera, then wherever it was moved. `undefined` before there is a scene.
   * Setting it changes the fields it names; before there is a scene, they are kept for it.
   */
  get camera(): ResolvedCamera | undefined {
    return this.#parts.stage.camera;
  }
  set camera(changes: Partial<ResolvedCamera>) {
    this.#parts.stage.moveCamera(changes);
  }

  /**
   * What does the work; `undefined` until the scene is compiled, and after the element has left the document.
   *
   * The element sets its size: the canvas's, or a smaller one of the same proportions while the camera, the scene or the
   * canvas changes from frame to frame and the adapter can't do a sample of every pixel in a frame. It sets its
   * `samplesPerFrame` likewise.
   */
  get tracer(): PathTracer | undefined {
    return this.#parts.stage.tracer;
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
    return this.#parts.scenes.open(files);
  }

  /** Throws away what has been sampled and starts over. Where a message stands in place of the picture, loads the scene again. */
  reset(): void {
    const { face, scenes } = this.#parts;
    if (face.hasMessage) {
      this.#measure(); // a size that failed may have been mended a moment ago
      scenes.load();
    } else this.tracer?.reset();
  }

  #measure(): void {
    const { face, stage } = this.#parts;
    stage.size = canvasSize(currentBox(face.canvas));
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
      isLinear ? tracer.readRadiance() : tracer.readPicture({ exposure: this.exposure, toneMap: this.toneMap }),
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
    const { face, stage, scenes, controls, drop } = this.#parts;

    this.#measure();
    stage.refresh();
    watchBox(face.canvas, (box) => (stage.size = canvasSize(box)), signal);
    watchVisibility(this, (isVisible) => this.#onVisibility(isVisible), signal);
    watchReducedMotion((isReduced) => (stage.isCalm = isReduced), signal);
    if (!scenes.wasNear) watchNearness(this, () => scenes.noteNear(), signal);
    controls.rebind();
    drop.rebind();
    face.describe(this.alt, this.controls);
    if (scenes.isCurrent) this.#updateLoop();
    else scenes.load();
    scenes.noteVariant(); // it may have been set while the element was nowhere
  }

  disconnectedCallback(): void {
    this.#connection?.abort();
    this.#connection = undefined;
    this.#parts.controls.unbind();
    this.#parts.drop.unbind();
    this.#updateLoop();
    this.#disposal = setTimeout(() => this.#dispose(), DISPOSAL_GRACE_MS);
  }

  attributeChangedCallback(name: string): void {
    applyAttribute(name, this.#parts, this);
    this.#parts.panel.showKnobs();
  }

  protected override settingsChanged(): void {
    this.#parts.stage.settings = this.settings;
  }

  #createStage(face: Face): Stage {
    return new Stage(face.canvas, {
      onLoadProgress: (detail) => this.#onLoadProgress(detail),
      onScene: () => {
        face.clearMessage();
        this.#parts.panel.show();
        this.#updateLoop();
      },
      onReady: (detail) => {
        face.noteReady();
        fire(this, "ready", detail);
      },
      onProgress: (detail) => fire(this, "progress", detail),
      onConverged: (detail) => {
        face.noteConverged();
        fire(this, "converged", detail);
      },
      onDeviceLost: (detail) => {
        this.#parts.panel.show();
        fire(this, "devicelost", detail);
      },
      onError: (error) => this.#fail(error),
      onRefusal: (error) => fire(this, "error", { error }),
    });
  }

  async #bindControls(signal: AbortSignal): Promise<void> {
    const { bindOrbitControls } = await import("./orbitControls");
    if (signal.aborted) return;
    const { face, stage } = this.#parts;
    const target = {
      camera: () => this.camera,
      home: () => this.tracer?.scene.camera,
      onChange: (camera: ResolvedCamera) => stage.moveCamera(camera),
    };
    bindOrbitControls(face.canvas, target, signal);
  }

  async #bindDrop(signal: AbortSignal): Promise<void> {
    const { bindFileDrop } = await import("./fileDrop");
    if (signal.aborted) return;
    const onFiles = (files: readonly File[]) => this.open(...files);
    bindFileDrop(this, this.#parts.face.root, { onFiles }, signal);
  }

  #onLoadProgress(detail: LoadProgressDetail): void {
    this.#parts.face.showProgress(detail);
    fire(this, "loadprogress", detail);
  }

  #tick(): void {
    this.#parts.stage.tick();
    this.#parts.panel.refresh();
    this.#updateLoop();
  }

  #onVisibility(isVisible: boolean): void {
    this.#isVisible = isVisible;
    this.#updateLoop();
  }

  /** A scene that cannot be seen is left alone, except that its first picture is made, to be there when it can. */
  #updateLoop(): void {
    const isWanted = this.#isVisible || this.#parts.stage.owesPicture;
    this.#loop.isRunning =
      isWanted && this.#connection !== undefined && this.tracer !== undefined && !this.#parts.face.hasMessage;
  }

  #fail(error: Error): void {
    this.#parts.face.showError(error);
    this.#updateLoop();
    fire(this, "error", { error });
  }

  #dispose(): void {
    const { face, stage, scenes, panel } = this.#parts;
    scenes.forget();
    panel.hide();
    face.clear();
    stage.clear();
    this.#updateLoop();
  }

  #sampledTracer(): PathTracer {
    const { tracer } = this;
    if (tracer === undefined || tracer.stats.samples === 0) {
      throw new RtViewerError("there is no picture yet: wait for the event `ready`");
    }
    return tracer;
  }
}
