import { SceneError, UnsupportedError, WebGpuError } from "../errors";
import { lossOf } from "../gpu/device";
import { PathTracer, type SceneOptions } from "../renderer/pathTracer";
import { DEFAULT_SETTINGS, type Settings } from "../renderer/settings";
import type { View } from "../renderer/view";
import type { ResolvedCamera, Scene } from "../scene/schema";
import { type CameraOrbit, placeOnOrbit } from "./cameraOrbit";
import type { PixelSize } from "./canvasSize";
import { CanvasView } from "./canvasView";
import type { DeviceLostDetail, ReadyDetail } from "./events";
import { LatestTask } from "./latestTask";
import type { LoadProgressDetail, ReportProgress } from "./loadProgress";
import { type MilestoneListener, Milestones } from "./milestones";
import { Recovery } from "./recovery";
import type { EditedTracer, SceneEdits } from "./sceneEdits";
import { type DeviceLease, leaseDevice } from "./sharedDevice";

/** Whom the stage tells what happens on it. */
export type StageListener = Omit<MilestoneListener, "isPaused"> & {
  readonly onLoadProgress: (detail: LoadProgressDetail) => void;
  /** A scene is loaded and compiled; its first picture comes with one of the next frames. */
  readonly onScene: () => void;
  /** The picture is gone, and another one of the same scene is under way. */
  readonly onDeviceLost: (detail: DeviceLostDetail) => void;
  readonly onError: (error: Error) => void;
  /** Settings can't be used; those before stay. */
  readonly onRefusal: (error: Error) => void;
};

type ReadScene = (signal: AbortSignal, report: ReportProgress) => Promise<Scene>;

const HOPELESS =
  "The GPU was lost again and again with this scene, so it is not tried again by itself. A simpler scene or a smaller " +
  "picture may work. Reloading the page tries again.";

/** What lies between a request for a scene and the picture on a canvas. Knows the canvas and the tracer, not the page. */
export class Stage {
  readonly #canvas: HTMLCanvasElement;
  readonly #listener: StageListener;
  readonly #task = new LatestTask();
  /** Held while there is a view, or one is made. */
  #lease: DeviceLease | undefined;
  #view: CanvasView | undefined;
  /** One whose work has failed, while it is found out why. */
  #failedView: CanvasView | undefined;
  readonly #recovery = new Recovery();
  #lossCount = 0;
  #edits: SceneEdits | undefined;
  /** Scenes that are being loaded; those that were overtaken too. */
  #loads = 0;
  #size: PixelSize = { width: 1, height: 1 };
  #settings: Settings = DEFAULT_SETTINGS;
  #look: View = {};
  #isPaused = false;
  #isCalm = false;
  #orbit: CameraOrbit | undefined;
  /** The file of the scene that is shown, and of the one that was asked for last. */
  #shownFile: object | undefined;
  #wantedFile: object | undefined;
  /** Of the tracer that was there last. */
  #lastCamera: ResolvedCamera | undefined;
  /** What of the camera is to be changed once there is one. */
  #pendingCamera: Partial<ResolvedCamera> | undefined;
  readonly #milestones: Milestones;

  constructor(canvas: HTMLCanvasElement, listener: StageListener) {
    this.#canvas = canvas;
    this.#listener = listener;
    const onReady = (detail: ReadyDetail) => {
      this.#recovery.noteReady();
      listener.onReady(detail);
    };
    this.#milestones = new Milestones({ ...listener, onReady, isPaused: () => this.#isPaused });
  }

  get tracer(): PathTracer | undefined {
    return this.#view?.tracer;
  }

  /** Whether a scene is there that has not been seen yet. */
  get owesPicture(): boolean {
    return this.#milestones.owesPicture;
  }

  get camera(): ResolvedCamera | undefined {
    return this.tracer?.camera;
  }

  /**
   * Moves the camera; what is left out stays as it is. Without a scene, it is kept for the first one.
   *
   * @throws {SceneError} if there is no such camera.
   */
  moveCamera(changes: Partial<ResolvedCamera>): void {
    const { tracer } = this;
    if (tracer === undefined) this.#pendingCamera = { ...this.#pendingCamera, ...changes };
    else tracer.setCamera({ ...tracer.camera, ...changes });
  }

  /** Where the camera is around its target when a scene comes, and now; `undefined` is where the scene has it. */
  set orbit(orbit: CameraOrbit | undefined) {
    this.#orbit = orbit;
    this.#applyOrbit();
  }

  set size(size: PixelSize) {
    this.#size = size;
    this.#view?.resize(size);
  }

  set settings(settings: Settings) {
    this.#settings = settings;
    this.#applySettings();
  }

  /** Whether the picture rests as it is; a new view still gets its first sample. */
  set isPaused(isPaused: boolean) {
    this.#isPaused = isPaused;
    this.#applySettings();
  }

  /** How radiance becomes a picture. */
  set look(look: View) {
    this.#look = look;
    if (this.#view !== undefined) this.#view.look = look;
  }

  /** Whether the picture should not flicker while it gets finer. */
  set isCalm(isCalm: boolean) {
    this.#isCalm = isCalm;
    if (this.#view !== undefined) this.#view.isCalm = isCalm;
  }

  /**
   * Shows a scene in place of what there is. Of several calls the last one wins. Never rejects: errors are reported.
   *
   * @param read - gives the scene, and reports how far it is.
   * @param file - stands for the file it is from. Another scene from the file that is shown is seen from where the camera is.
   */
  async show(read: ReadScene, file?: object): Promise<void> {
    this.#recovery.forgive();
    await this.#show(read, file);
  }

  async #show(read: ReadScene, file: object | undefined): Promise<void> {
    this.#wantedFile = file;
    const requestedAt = performance.now();
    const reportFor = (signal: AbortSignal): ReportProgress => {
      return (phase, fraction) => {
        if (!signal.aborted) this.#listener.onLoadProgress({ phase, fraction });
      };
    };
    this.#loads += 1;
    this.#edits?.cancel();
    try {
      const isLast = await this.#task.run(
        (signal) => read(signal, reportFor(signal)),
        (scene, signal) => this.#put(scene, signal, reportFor(signal)),
      );
      if (!isLast || this.#view === undefined) return;
      this.#milestones.expectPicture(requestedAt);
      this.#listener.onScene();
    } catch (error) {
      if (this.#view === undefined) this.#release();
      this.#listener.onError(toError(error));
    } finally {
      this.#loads -= 1;
    }
  }

  /**
   * Shows the scene with other values, seen from where the camera is. Errors are reported.
   *
   * @param createEdits - asked once per tracer; its code comes with the panel.
   * @returns false, and nothing is done, without a scene and while another one is loaded.
   */
  edit(scene: Scene, createEdits: (tracer: EditedTracer) => SceneEdits): boolean {
    const { tracer } = this;
    if (tracer === undefined || this.#loads > 0) return false;
    this.#edits ??= createEdits(tracer);
    this.#edits.show(scene).catch(async (error: unknown) => {
      if (error instanceof WebGpuError && (await lossOf(tracer.device))) return; // it recovers
      this.#listener.onError(toError(error));
    });
    return true;
  }

  /** Does the work of one frame. */
  tick(): void {
    const view = this.#view;
    if (view === undefined || view === this.#failedView) return;
    try {
      if (view.draw()) this.#milestones.noteDrawn();
      this.#milestones.report(view);
    } catch (error) {
      void this.#onFailure(view, toError(error));
    }
  }

  /** Shows the picture again, after the canvas has been moved. */
  refresh(): void {
    this.#view?.refresh();
  }

  /** Ends the loading of a scene, which is never told of. What is shown stays. */
  stopLoading(): void {
    this.#task.cancel();
  }

  /** Ends what is under way and gives back the GPU. */
  clear(): void {
    this.#task.cancel();
    this.#recovery.end();
    this.#view?.dispose();
    this.#forgetView();
    this.#release();
    this.#pendingCamera = undefined;
    this.#shownFile = undefined;
  }

  /** Goes on until the scene is on a device that lives. */
  async #put(scene: Scene, signal: AbortSignal, report: ReportProgress): Promise<void> {
    try {
      await this.#putOnDevice(scene, signal, report);
    } finally {
      if (this.#view === undefined) this.#recovery.end();
    }
  }

  async #putOnDevice(scene: Scene, signal: AbortSignal, report: ReportProgress): Promise<void> {
    while (!signal.aborted) {
      if (this.#lease === undefined) await this.#recovery.begin(signal);
      if (signal.aborted) return;
      const lease = this.#lease ?? (await leaseDevice());
      if (signal.aborted && lease !== this.#lease) return lease.release();
      if (lease !== this.#lease) this.#hold(lease);
      report("compiling");
      const onProgress = (fraction: number) => (fraction < 1 ? report("building", fraction) : report("compiling"));
      const { tracer } = this;
      const camera = this.#keptCamera;
      const options = { onProgress, signal, ...(camera && { camera }) };
      try {
        await (tracer ? tracer.setScene(scene, options) : this.#open(scene, lease, options));
      } catch (error) {
        // What is wrong with the scene has nothing to do with the device, and is told at once.
        const isOfScene = error instanceof SceneError || error instanceof UnsupportedError;
        if (signal.aborted || isOfScene || !(await lossOf(lease.device))) throw error;
      }
      if (signal.aborted || this.#lease !== lease || this.#view === undefined) continue;
      this.#shownFile = this.#wantedFile;
      this.#applyAll(this.#view, camera !== undefined);
      return;
    }
  }

  /** From where what is wanted is seen, where it is another scene of the file that is shown. */
  get #keptCamera(): ResolvedCamera | undefined {
    if (this.#wantedFile === undefined || this.#wantedFile !== this.#shownFile) return undefined;
    return this.camera ?? this.#lastCamera;
  }

  #hold(lease: DeviceLease): void {
    this.#lease = lease;
    void lease.device.lost.then((loss) => {
      if (this.#lease === lease) this.#recover(lease.device, loss);
    });
  }

  async #open(
    scene: Scene,
    { device }: DeviceLease,
    options: SceneOptions & { readonly signal: AbortSignal },
  ): Promise<void> {
    const settings = this.#effectiveSettings();
    const tracer = await PathTracer.create({ scene, ...this.#size, settings, device, ...options });
    try {
      options.signal.throwIfAborted();
      if (this.#lease?.device === device) this.#view = new CanvasView(tracer, this.#canvas);
    } finally {
      if (this.#view?.tracer !== tracer) tracer.dispose();
    }
  }

  /**
   * What the page asked for while the scene was compiled, or before.
   *
   * @param isPlaced - whether the camera has been moved there already.
   */
  #applyAll(view: CanvasView, isPlaced: boolean): void {
    view.resize(this.#size);
    view.look = this.#look;
    view.isCalm = this.#isCalm;
    this.#applySettings();
    if (this.#orbit !== undefined && !isPlaced) this.#applyOrbit();
    const changes = this.#pendingCamera;
    this.#pendingCamera = undefined;
    if (changes !== undefined) this.moveCamera(changes);
  }

  /** Starts over on another device; the canvas keeps its picture until then. */
  #recover(device: GPUDevice, loss: GPUDeviceLostInfo): void {
    const { tracer } = this;
    this.#dropTracer();
    this.#recovery.noteLoss(device);
    this.#lossCount += 1;
    this.#listener.onDeviceLost({ message: loss.message, count: this.#lossCount });
    if (this.#recovery.isHopeless) {
      this.#task.cancel();
      this.#listener.onError(new WebGpuError(HOPELESS, { cause: loss }));
      return;
    }
    // Whatever is on its way to the stage will find a device by itself.
    if (this.#task.isRunning || tracer === undefined) return;
    this.#pendingCamera = tracer.camera;
    void this.#show(async () => tracer.scene, this.#shownFile);
  }

  async #onFailure(view: CanvasView, error: Error): Promise<void> {
    this.#failedView = view;
    if ((await lossOf(view.tracer.device)) || this.#view !== view) return;
    if (this.#task.isRunning) return this.#dropTracer(); // the scene that is on its way opens another one
    this.clear();
    this.#listener.onError(error);
  }

  /** The canvas keeps its picture. */
  #dropTracer(): void {
    this.#lastCamera = this.camera;
    this.tracer?.dispose();
    this.#forgetView();
    this.#release();
  }

  #forgetView(): void {
    this.#view = undefined;
    this.#failedView = undefined;
    this.#edits?.cancel();
    this.#edits = undefined;
    this.#milestones.forget();
  }

  #release(): void {
    this.#lease?.release();
    this.#lease = undefined;
  }

  #applyOrbit(): void {
    const { tracer } = this;
    if (tracer === undefined) return;
    const home = tracer.scene.camera;
    tracer.setCamera(this.#orbit === undefined ? home : placeOnOrbit(home, this.#orbit));
  }

  #applySettings(): void {
    if (this.#view === undefined) return;
    try {
      this.#view.settings = this.#effectiveSettings();
    } catch (error) {
      this.#listener.onRefusal(toError(error));
    }
  }

  /** A pause is a limit of one sample: what has more of them stays, and a new view gets one. */
  #effectiveSettings(): Settings {
    return this.#isPaused ? { ...this.#settings, maxSamples: 1 } : this.#settings;
  }
}

function toError(error: unknown): Error {
  return error instanceof Error ? error : new Error(String(error));
}
