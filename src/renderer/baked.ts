import type { CompiledScene } from "../compile/compileScene";
import { checked } from "../gpu/errorScope";
import type { Film } from "../gpu/film";
import type { SceneGeometry } from "../gpu/sceneGeometry";
import { TracePass } from "../gpu/tracePass";
import { createProgram, type Program, programKey } from "./program";

/** What a program reads and writes besides the scene's values. */
export type Target = { readonly geometry: SceneGeometry | undefined; readonly film: Film };

/**
 * The program of a scene at rest, with the scene's values as constants. It is the same estimator with the same points as
 * the program it stands in for, so that it can take over in the middle of an accumulation.
 */
export class Baked {
  readonly #device: GPUDevice;
  #program: Program | undefined;
  #trace: TracePass | undefined;
  #target: Target | undefined;
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

  /** Compiles the scene, unless that is done or under way. Resolves when the program is in use. */
  compile(scene: () => CompiledScene, target: Target): Promise<void> {
    if (this.#program) return Promise.resolve();
    this.#compiling ??= this.#compile(scene(), target).finally(() => {
      this.#compiling = undefined;
    });
    return this.#compiling;
  }

  async #compile(scene: CompiledScene, target: Target): Promise<void> {
    const changes = this.#changes;
    const program = await createProgram(this.#device, scene);
    if (changes !== this.#changes) return;
    this.#program = program;
    await checked(this.#device, () => this.#use(program, scene, target));
  }

  /** Follows a change: the program stays in use if it fits the scene as it is now. */
  change(scene: () => CompiledScene, target: Target): void {
    this.#changes++;
    if (!this.#program || !this.#trace) return;
    const compiled = scene();
    if (programKey(compiled) !== this.#program.key) this.drop();
    else if (target.film === this.#target?.film && target.geometry === this.#target.geometry) {
      this.#trace.writeScene(compiled.uniform);
    } else this.#use(this.#program, compiled, target);
  }

  /** Ends the program's use. */
  drop(): void {
    this.#changes++;
    this.#trace?.dispose();
    this.#trace = undefined;
    this.#program = undefined;
  }

  #use(program: Program, scene: CompiledScene, target: Target): void {
    this.#trace?.dispose();
    this.#target = target;
    this.#trace = new TracePass(this.#device, program.pipelines, scene.uniform, target.geometry, target.film);
  }
}
