import type { CompiledScene } from "../compile/compileScene";
import type { SceneGeometry } from "../gpu/sceneGeometry";
import { parseCamera } from "../scene/parseScene";
import type { Camera, ResolvedCamera, ResolvedScene } from "../scene/schema";
import { type BuiltGeometry, buildGeometry } from "./buildGeometry";
import type { DeviceGuard } from "./deviceGuard";
import { compileFor, createProgram, type Program, programKey } from "./program";
import type { Settings } from "./settings";

/** What somebody who shows a scene may want to know meanwhile. */
export type SceneOptions = {
  /** From where it is shown. Default: the scene's own. */
  readonly camera?: Camera;
  /** Told which share of a scene's geometry is sorted, from 0 to 1, where there is much of it. */
  readonly onProgress?: (fraction: number) => void;
  /** Ends the sorting, in a worker too; the promise is then rejected with its reason. A scene that was shown stays. */
  readonly signal?: AbortSignal;
};

/** A scene, where it is seen from, and all that a device needs to render it. Replaced when anything of it changes. */
export type InstalledScene = {
  readonly scene: ResolvedScene;
  readonly camera: ResolvedCamera;
  readonly compiled: CompiledScene;
  readonly program: Program;
  readonly geometry: SceneGeometry | undefined;
};

/** The same, before its geometry is on the device. */
export type ReadyScene = Omit<InstalledScene, "geometry"> & { readonly geometry: BuiltGeometry | undefined };

type Shown = Pick<InstalledScene, "scene" | "camera">;

/** From where a scene is shown at first. @throws {SceneError} if what was asked for is no camera. */
export function cameraFor(scene: ResolvedScene, { camera }: SceneOptions): ResolvedCamera {
  return camera ? parseCamera(camera) : scene.camera;
}

type InstallationOptions = {
  readonly guard: DeviceGuard;
  readonly first: ReadyScene;
  /** Asked whenever a scene is compiled. */
  readonly settings: () => Settings;
  /** Told when something else is to be seen. With another program or geometry, passes made for those before can't run any more. */
  readonly onChange: (needsPasses: boolean) => void;
};

/**
 * Installs scenes: sorts their geometry, compiles them and brings them onto the device. Until all of that is done, what was
 * installed before is shown.
 */
export class Installation {
  readonly #guard: DeviceGuard;
  readonly #settings: () => Settings;
  readonly #onChange: (needsPasses: boolean) => void;
  #shown: InstalledScene;
  /** What will be shown, and the work for it; the newest only. */
  #pending: Shown | undefined;
  #installing: Promise<void> | undefined;
  /** Ends that work, for something newer. */
  #overtake = new AbortController();
  #isDisposed = false;

  /**
   * Inside of an error scope.
   *
   * @throws {UnsupportedError | WebGpuError} if the device has no room for the scene's geometry.
   */
  constructor({ guard, first, settings, onChange }: InstallationOptions) {
    this.#guard = guard;
    this.#settings = settings;
    this.#onChange = onChange;
    this.#shown = { ...first, geometry: first.geometry?.upload(guard.device) };
  }

  get shown(): InstalledScene {
    return this.#shown;
  }

  /** The scene that settings have to fit: what will be shown, if anything will. */
  get nextScene(): ResolvedScene {
    return (this.#pending ?? this.#shown).scene;
  }

  /** Pending while another scene is sorted or compiled. Never rejects. */
  get installing(): Promise<void> | undefined {
    return this.#installing;
  }

  /** Of what is shown, and of what will be. */
  setCamera(camera: ResolvedCamera): void {
    if (this.#pending) this.#pending = { ...this.#pending, camera };
    if (JSON.stringify(camera) === JSON.stringify(this.#shown.camera)) return;
    this.#shown = { ...this.#shown, camera };
    this.#onChange(false);
    // Until the rest is compiled it is shown without.
    if (!this.#shown.compiled.isFor(camera)) this.recompile().catch(this.#guard.fail);
  }

  /** Shows another scene, or the same with other values. @throws {SceneError | UnsupportedError | WebGpuError} The old one stays. */
  async install(scene: ResolvedScene, options: SceneOptions): Promise<void> {
    await this.#install({ scene, camera: cameraFor(scene, options) }, options);
  }

  /** For other settings, or another kind of camera. What is pending is compiled for the newest settings as it is. */
  async recompile(): Promise<void> {
    if (!this.#pending) await this.#install(this.#shown, {});
  }

  dispose(): void {
    this.#isDisposed = true;
    this.#overtake.abort();
    this.#installing = this.#pending = undefined; // or who waits for it would wait for ever
    this.#shown.geometry?.dispose();
  }

  /** A newer call overtakes an older one. */
  async #install({ scene, camera }: Shown, options: SceneOptions): Promise<void> {
    if (this.#isDisposed) return;
    this.#overtake.abort();
    this.#overtake = new AbortController();
    const { signal } = this.#overtake;
    this.#pending = { scene, camera };
    const either = AbortSignal.any([signal, options.signal ?? signal]);
    const installing = this.#compile(scene, { ...options, signal: either });
    this.#installing = installing.catch(() => undefined); // for those who only wait
    try {
      await installing;
    } catch (error) {
      if (!signal.aborted) throw error;
    } finally {
      if (!signal.aborted) this.#installing = this.#pending = undefined;
    }
  }

  /** In one go where nothing has to be sorted or compiled. */
  async #compile(scene: ResolvedScene, options: SceneOptions & { readonly signal: AbortSignal }): Promise<void> {
    const building = buildGeometry(scene, { previous: this.#shown.geometry?.source, ...options });
    const geometry = building && (await building);
    options.signal.throwIfAborted();
    let { program } = this.#shown;
    for (;;) {
      const compiled = compileFor(this.#pending!, this.#settings(), geometry?.source);
      if (program.key === programKey(compiled)) return this.#show({ ...this.#pending!, compiled, program, geometry });
      program = await createProgram(this.#guard.device, compiled); // settings may change meanwhile
      options.signal.throwIfAborted();
    }
  }

  #show({ geometry, ...ready }: ReadyScene): void {
    const before = this.#shown;
    const hasSameGeometry = geometry?.source === before.geometry?.source;
    // First, because the device may have no room for it: then the old scene stays.
    const uploaded = hasSameGeometry ? before.geometry : this.#guard.run(() => geometry?.upload(this.#guard.device));
    this.#pending = undefined;
    this.#shown = { ...ready, geometry: uploaded };
    if (!hasSameGeometry) before.geometry?.dispose();
    this.#onChange(!hasSameGeometry || ready.program !== before.program);
  }
}
