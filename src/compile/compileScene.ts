import type { ResolvedCamera, ResolvedScene, Vec3 } from "../scene/schema";
import { canBlock } from "./blockers";
import { emitScene } from "./emitScene";
import { emittersOf, isEmissive } from "./emitters";
import { deriveFeatures, describeFeatures, type Features, type ProgramSettings } from "./features";
import type { Geometry } from "./geometry";
import { packScene } from "./packScene";
import { primitivesOf, type Shape } from "./primitives";
import { inSceneUnits } from "./sceneUnits";
import { Literals, Slots } from "./values";
import { scale, subtract } from "./vec3";

// maxUniformBufferBindingSize of every WebGPU device.
const MAX_UNIFORM_BYTES = 65536;

/** A scene made ready for the shader. */
export type CompiledScene = {
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
  /** Those of them that emit. */
  readonly lamps: readonly Shape[];
  /** The scene's point that is the shader's origin; subtract it from the camera's position. */
  readonly origin: Vec3;
  /** The shader's unit of length, in metres: see `inSceneUnits`. */
  readonly unit: number;
};

/**
 * Compiles a scene to generated WGSL and the data it reads. Pure, and quick enough for every change of a value: linking,
 * which is not, is needed only when `sceneModule` or `features` differ from before.
 *
 * @param restingCamera - given one, values stand in the text as constants, and what they rule out, seen from that camera,
 * is left out. Faster to run, good for this scene only, and the same image up to rounding. Without one, values live in the
 * uniform, and the text depends only on what kinds of things there are.
 * @param geometry - what `prepareGeometry` made of the scene.
 */
export function compileScene(
  given: ResolvedScene,
  settings: ProgramSettings,
  restingCamera?: ResolvedCamera,
  geometry?: Geometry,
): CompiledScene {
  const { scene, unit } = inSceneUnits(given);
  // What the camera looks at is where digits matter. Subtracted in doubles, before anything is rounded to f32, it makes a
  // scene far from the world's origin as precise as one around it.
  const origin = scene.camera.target;
  const primitives = primitivesOf(scene, origin, geometry);
  const emitters = emittersOf(scene, primitives, origin);
  const environment = scene.environment.radiance;
  const features = deriveFeatures(
    primitives,
    emitters,
    environment.some((value) => value > 0),
    geometry,
    settings,
  );
  const slots = new Slots();
  const camera = restingCamera && scale(subtract(restingCamera.position, given.camera.target), 1 / unit);
  const textures = features.TEXTURES ? scene.textures : {}; // nobody may use them
  const textureCount = Object.keys(textures).length;
  const pack = () => packScene(primitives, emitters, geometry, environment, textures, slots.numbers);
  const sceneModule = emitScene(
    { primitives, emitters, features, textureCount, geometry },
    camera ? new Literals() : slots,
    (id) => camera === undefined || canBlock(id, primitives, emitters, camera),
    () => ({ slotCount: slots.numbers.length / 4, isStored: pack().byteLength > MAX_UNIFORM_BYTES }),
  );
  const uniform = pack();
  return {
    sceneModule,
    features,
    description: [...describeFeatures(primitives, emitters, features), ...(camera ? ["values as constants"] : [])],
    uniform,
    isStored: uniform.byteLength > MAX_UNIFORM_BYTES,
    shapes: primitives.map(({ shape }) => shape),
    lamps: primitives.filter(isEmissive).map(({ shape }) => shape),
    origin: given.camera.target,
    unit,
  };
}
