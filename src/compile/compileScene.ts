import { scale, subtract } from "../math/vec3";
import type { ResolvedCamera, ResolvedScene, Vec3 } from "../scene/schema";
import { inSceneUnits } from "../shapes/sceneUnits";
import type { Shape } from "../shapes/shapes";
import type { Geometry } from "../tree/geometry";
import { Blockers } from "./blockers";
import { emitScene, type SceneParts } from "./emitScene";
import { type Emitter, emittersOf } from "./emitterWindow";
import { deriveFeatures, describeFeatures, type Features, type ProgramSettings } from "./features";
import { lightsOfScene } from "./lights";
import { tablesOf } from "./packScene";
import { isEmissive, primitivesOf } from "./primitives";
import { bytesOf, type Member, packMembers, sceneMembers, slotsMember } from "./sceneMembers";
import { unrollingOf } from "./unrolling";
import { Literals, Slots } from "./values";
import { mayBeIn } from "./volumes";

// maxUniformBufferBindingSize of every WebGPU device.
const MAX_UNIFORM_BYTES = 65536;

/**
 * Compiles a scene to generated WGSL and the data it reads. Pure, and quick enough for every change of a value: linking,
 * which is not, is needed only when `sceneModule` or `features` differ from before.
 *
 * @param restingCamera - given one, the scene is compiled for it: see `CompiledScene.atRest`. Without one, values live in the
 * uniform, and the text depends only on what kinds of things there are.
 * @param geometry - what `prepareGeometry` made of the scene.
 * @param camera - of the program, if it is not the scene's own: see `CompiledScene.isFor`.
 */
export function compileScene(
  given: ResolvedScene,
  settings: ProgramSettings,
  restingCamera?: ResolvedCamera,
  geometry?: Geometry,
  camera = given.camera,
): CompiledScene {
  const { scene, unit } = inSceneUnits(given);
  const primitives = primitivesOf(scene, geometry);
  const lights = lightsOfScene(scene, primitives);
  const hasEnvironment = scene.environment.radiance.some((value) => value > 0);
  const origin = given.camera.target;
  const view = viewOf(camera, origin, unit);
  const rest = {
    hasEnvironment,
    hasLens: camera.aperture > 0,
    isImmersed: mayBeIn(primitives, view.position, view.reach),
  };
  const features = deriveFeatures(primitives, lights, rest, geometry, settings);
  const unrolling = unrollingOf(primitives, geometry);
  const tables = tablesOf(primitives, lights, unrolling, geometry, scene, features);
  const parts = { primitives, lights, unrolling, features, tables, geometry };
  const compiled = new CompiledScene({
    ...parts,
    origin,
    unit,
    members: sceneMembers(tables, unrolling),
    description: describeFeatures(primitives, lights, features),
    shapes: primitives.map(({ shape }) => shape),
    emitters: emittersOf(primitives.filter(isEmissive).map(({ shape }) => shape)),
    lightCount: lights.length,
    blockers: new Blockers(primitives, lights),
  });
  return restingCamera ? compiled.atRest(restingCamera) : compiled;
}

/** Where rays of a camera start, in the shader's coordinates: within `reach` of `position`. */
function viewOf({ position, orthographicHeight, aperture }: ResolvedCamera, origin: Vec3, unit: number) {
  return {
    position: scale(subtract(position, origin), 1 / unit),
    // How wide the picture is, and so where the parallel rays of an orthographic one start, is not known here.
    reach: orthographicHeight === undefined ? aperture / unit : Number.POSITIVE_INFINITY,
  };
}

/** What the two programs of a scene have in common. */
type Shared = SceneParts & {
  readonly origin: Vec3;
  readonly unit: number;
  /** Of `scene`, but for the slots. */
  readonly members: readonly Member[];
  readonly description: readonly string[];
  readonly shapes: readonly Shape[];
  readonly emitters: readonly Emitter[];
  readonly lightCount: number;
  readonly blockers: Blockers;
};

/** A scene made ready for the shader. */
export class CompiledScene {
  /** The generated module `scene`. Scenes that differ only in values that live in slots have the same text. */
  readonly sceneModule: string;
  readonly features: Features;
  /** The features in words. */
  readonly description: readonly string[];
  /** Contents of `scene`: of a uniform buffer or, if stored, of a read-only storage buffer. */
  readonly uniform: ArrayBuffer;
  readonly isStored: boolean;
  /** What rays can hit, relative to `origin`, in units. */
  readonly shapes: readonly Shape[];
  /** What holds those of them that emit. */
  readonly emitters: readonly Emitter[];
  /** What light sampling chooses among. */
  readonly lightCount: number;
  /** The scene's point that is the shader's origin; subtract it from the camera's position. */
  readonly origin: Vec3;
  /** The shader's unit of length, in metres: see `inSceneUnits`. */
  readonly unit: number;
  readonly #shared: Shared;
  /** The last one made, and the primitives that could block in it. */
  #atRest: { readonly blocking: string; readonly compiled: CompiledScene } | undefined;

  /** @param blocking - for values as constants: which of the unrolled primitives can block. */
  constructor(shared: Shared, blocking?: ReadonlySet<number>) {
    const slots = new Slots();
    const packed = () => {
      const members = [...shared.members, slotsMember(slots.numbers)];
      return { members, isStored: bytesOf(members) > MAX_UNIFORM_BYTES };
    };
    const values = blocking ? new Literals() : slots;
    this.sceneModule = emitScene(shared, values, (id) => blocking?.has(id) ?? true, packed);
    const { members, isStored } = packed();
    this.uniform = packMembers(members);
    this.isStored = isStored;
    this.features = shared.features;
    this.description = [...shared.description, blocking ? "values as constants" : "values in a buffer"];
    this.shapes = shared.shapes;
    this.emitters = shared.emitters;
    this.lightCount = shared.lightCount;
    this.origin = shared.origin;
    this.unit = shared.unit;
    this.#shared = shared;
  }

  /** Whether the program has what a camera needs: a lens is code of its own, and so is finding out in what solid the camera is. */
  isFor(camera: ResolvedCamera): boolean {
    const { primitives, origin, unit } = this.#shared;
    const { position, reach } = viewOf(camera, origin, unit);
    const { LENS, IMMERSED } = this.features;
    return LENS === camera.aperture > 0 && (IMMERSED || !mayBeIn(primitives, position, reach));
  }

  /**
   * The same scene with its values in the text as constants; what they rule out, seen from a camera, is left out. Faster to run,
   * good for this scene only, and the same image up to rounding. Cameras for which that makes no difference get the same object:
   * a moving camera costs next to nothing.
   */
  atRest(camera: ResolvedCamera): CompiledScene {
    const { blockers, unrolling, origin, unit } = this.#shared;
    const { position, reach } = viewOf(camera, origin, unit);
    const ids = unrolling.unrolled.filter((id) => blockers.canBlock(id, position, reach));
    const blocking = ids.join(" ");
    if (this.#atRest?.blocking !== blocking) {
      this.#atRest = { blocking, compiled: new CompiledScene(this.#shared, new Set(ids)) };
    }
    return this.#atRest.compiled;
  }
}
