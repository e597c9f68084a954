import type { CompiledScene } from "../compile/compileScene";
import { checked } from "../gpu/errorScope";
import type { Film } from "../gpu/film";
import type { SceneGeometry } from "../gpu/sceneGeometry";
import { TracePass } from "../gpu/tracePass";
import { createProgram, type Program, programKey } from "./program";

/** What is shown, and what a program reads and writes besides the scene's values. */
export type Bakeable = {
  readonly geometry: SceneGeometry | undefined;
  readonly film: Film;
  /** The scene with its values as constants: the same object while they are the same. */
  readonly bake: () => CompiledScene;
};

/** Whether a program with constants is worth it. `isWanted` tells whether what it was compiled for is still shown. */
export type IsQuicker = (program: Program, scene: CompiledScene, isWanted: () => boolean) => Promise<boolean>;

/**
 * The program of a scene at rest, with the scene's values as constants. It is the same estimator with the same points as
 * the program it stands in for, so that it can take over in the middle of an accumulation.
 */
export class Baked {
  readonly #device: GPUDevice;
  #program: Program | undefined;
  #trace: TracePass | undefined;
  /** What the program is of, or will be once it is compiled. */
  #scene: CompiledScene | undefined;
  #target: Pick<Bakeable, "geometry" | "film"> | undefined;
  #compiling: Promise<void> | undefined;
  /** Counts the changes that make a compilation under way worthless. */
  #changes = 0;

  constructor(device: GPUDevice) {
    this.#device = device;
  }

  /** What to run; undefined until it is compiled, and after a change that it does not fit. */
  get program(): Program | undefined {
    return this.#program;
  }

  get trace(): TracePass | undefined {
    return this.#trace;
  }

  /**
   * Compiles the scene, unless that is done or under way. Resolves when the program is in use, or is not worth it.
   *
   * @param isQuicker - asked whether it is worth it.
   */
  compile(shown: Bakeable, isQuicker: IsQuicker): Promise<void> {
    if (this.#program) return Promise.resolve();
    this.#compiling ??= this.#compile(shown, isQuicker).finally(() => {
      this.#compiling = undefined;
    });
    return this.#compiling;
  }

  async #compile(shown: Bakeable, isQuicker: IsQuicker): Promise<void> {
    const changes = this.#changes;
    const isWanted = () => changes === this.#changes;
    const scene = shown.bake();
    this.#scene = scene;
    this.#target = shown;
    const program = await createProgram(this.#device, scene);
    if (!isWanted()) return;
    const isWorthIt = await isQuicker(program, scene, isWanted);
    if (!isWanted() || !isWorthIt) return;
    await checked(this.#device, () => this.#use(program, scene, shown));
  }

  /** Follows a change: the program stays in use if it fits the scene as it is now. */
  change(shown: Bakeable): void {
    if (!this.#program && !this.#compiling) return;
    const scene = shown.bake();
    const hasSameTarget = shown.film === this.#target?.film && shown.geometry === this.#target.geometry;
    if (scene === this.#scene && hasSameTarget) return;
    this.#changes++;
    if (!this.#program || !this.#trace) return;
    if (programKey(scene) !== this.#program.key) this.drop();
    else if (hasSameTarget) {
      this.#scene = scene;
      this.#trace.writeScene(scene.uniform);
    } else this.#use(this.#program, scene, shown);
  }

  /** Ends the program's use. */
  drop(): void {
    this.#changes++;
    this.#trace?.dispose();
    this.#trace = undefined;
    this.#program = undefined;
  }

  #use(program: Program, scene: CompiledScene, shown: Bakeable): void {
    this.#trace?.dispose();
    this.#program = program;
    this.#scene = scene;
    this.#target = shown;
    const [{ pipelines }, { geometry, film }] = [program, shown];
    this.#trace = new TracePass(this.#device, { pipelines, scene: scene.uniform, geometry, film });
  }
}
