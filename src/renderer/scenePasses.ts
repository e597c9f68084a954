import { explainFailure } from "../gpu/device";
import type { Film } from "../gpu/film";
import { TracePass } from "../gpu/tracePass";
import { type Bakeable, Baked, type IsQuicker } from "./baked";
import type { InstalledScene } from "./installation";
import type { Pace } from "./pace";
import type { Program } from "./program";
import type { Settings } from "./settings";
import { sharedUniforms } from "./sharedUniforms";

// Pixels of the longer side where two programs are compared: enough to fill a GPU.
const COMPARED_SIDE = 512;

type ScenePassesOptions = {
  readonly device: GPUDevice;
  /** Both asked whenever they matter. */
  readonly shown: () => InstalledScene;
  readonly settings: () => Settings;
};

/**
 * Traces what is shown into a film: by a program that reads the scene's values or, once the scene rests and where that is quicker,
 * by one that has them as constants.
 */
export class ScenePasses {
  readonly #device: GPUDevice;
  readonly #shown: () => InstalledScene;
  readonly #settings: () => Settings;
  #film: Film;
  #general: TracePass;
  /** Stands in for the general one while the scene rests. */
  readonly #baked: Baked;
  /** The program whose values, as constants, made it no quicker. */
  #unbakeable: Program | undefined;
  #isDisposed = false;

  /** Inside of an error scope, as all that follows but `bake`. */
  constructor({ device, shown, settings }: ScenePassesOptions, film: Film) {
    this.#device = device;
    this.#shown = shown;
    this.#settings = settings;
    this.#film = film;
    this.#general = this.#createGeneral();
    this.#baked = new Baked(device);
  }

  /** What runs now. */
  get program(): Program {
    return this.#baked.program ?? this.#shown().program;
  }

  /** The pass that runs it. */
  get trace(): TracePass {
    return this.#baked.trace ?? this.#general;
  }

  /** For another program, geometry or film. `update` is to follow. */
  rebuild(film = this.#film): void {
    this.#general.dispose();
    this.#film = film;
    this.#general = this.#createGeneral();
  }

  /** Follows a change of the scene's values, the camera or the settings. */
  update(): void {
    this.#general.writeScene(this.#shown().compiled.uniform);
    if (this.#settings().constants) this.#baked.change(this.#bakeable);
    else this.#baked.drop();
  }

  /**
   * Compiles the program with constants. Resolves when it is in use, or was found to be no quicker.
   *
   * @param pace - asked when programs are compared, which it learns from.
   * @throws {WebGpuError} if the device fails.
   */
  async bake(pace: () => Pace): Promise<void> {
    if (this.#settings().constants === "auto" && this.#unbakeable === this.#shown().program) return;
    try {
      await this.#baked.compile(this.#bakeable, this.#isQuicker(pace));
    } catch (error) {
      throw await explainFailure(this.#device, error);
    }
    if (this.#isDisposed) this.#baked.drop();
  }

  dispose(): void {
    this.#isDisposed = true;
    this.#general.dispose();
    this.#baked.drop();
  }

  get #bakeable(): Bakeable {
    const bake = () => this.#shown().compiled.atRest(this.#shown().camera);
    return { geometry: this.#shown().geometry, film: this.#film, bake };
  }

  #createGeneral(): TracePass {
    const { program, compiled, geometry } = this.#shown();
    const { pipelines } = program;
    return new TracePass(this.#device, { pipelines, scene: compiled.uniform, geometry, film: this.#film });
  }

  /** Whether a program with the scene's values as constants is to take the place of the general one. */
  #isQuicker(pace: () => Pace): IsQuicker {
    return async (program, compiled, isWanted) => {
      if (this.#settings().constants !== "auto") return true;
      const { compareTraces } = await import("./compareTraces");
      if (!isWanted()) return false;
      const general = this.#shown();
      const { width, height } = this.#film;
      const scale = Math.min(1, COMPARED_SIDE / Math.max(width, height));
      const ratio = await compareTraces(this.#device, {
        contenders: [general, { program, compiled }],
        geometry: general.geometry,
        shared: sharedUniforms(general, this.#settings(), Math.ceil(scale * width), Math.ceil(scale * height)),
        pace: pace(),
        isWanted,
      });
      if (ratio !== undefined && ratio > 1) this.#unbakeable = general.program;
      return ratio !== undefined && ratio <= 1;
    };
  }
}
