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
  /** What the constants come from: while these are the same objects, so are the constants. */
  readonly sources: readonly object[];
  /** Compiles it with its values as constants. */
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
  #shown: Bakeable | undefined;
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
    this.#shown = shown;
    const scene = shown.bake();
    const program = await createProgram(this.#device, scene);
    if (!isWanted()) return;
    const isWorthIt = await isQuicker(program, scene, isWanted);
    if (!isWanted() || !isWorthIt) return;
    await checked(this.#device, () => this.#use(program, scene, shown));
  }

  /** Follows a change: the program stays in use if it fits the scene as it is now. */
  change(shown: Bakeable): void {
    const before = this.#shown;
    const isSame = before !== undefined && shown.sources.every((source, i) => source === before.sources[i]);
    const hasSameTarget = shown.film === before?.film && shown.geometry === before.geometry;
    if (isSame && hasSameTarget) return;
    this.#changes++;
    if (!this.#program || !this.#trace) return;
    const compiled = shown.bake();
    if (programKey(compiled) !== this.#program.key) this.drop();
    else if (hasSameTarget) {
      this.#shown = shown;
      this.#trace.writeScene(compiled.uniform);
    } else this.#use(this.#program, compiled, shown);
  }

  /** Ends the program's use. */
  drop(): void {
    this.#changes++;
    this.#trace?.dispose();
    this.#trace = undefined;
    this.#program = undefined;
    this.#shown = undefined;
  }

  #use(program: Program, scene: CompiledScene, shown: Bakeable): void {
    this.#trace?.dispose();
    this.#program = program;
    this.#shown = shown;
    this.#trace = new TracePass(this.#device, program.pipelines, scene.uniform, shown.geometry, shown.film);
  }
}
