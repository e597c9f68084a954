import { UnsupportedError } from "../errors";
import type { ResolvedScene, Vec3 } from "../scene/schema";
import { emitScene } from "./emitScene";
import { emittersOf } from "./emitters";
import { deriveFeatures, describeFeatures, type Features, type ProgramSettings } from "./features";
import { packScene } from "./packScene";
import { primitivesOf } from "./primitives";
import { Slots } from "./values";

// maxUniformBufferBindingSize of every WebGPU device.
const MAX_UNIFORM_BYTES = 65536;

/** A scene made ready for the shader. */
export type CompiledScene = {
  /** The generated module `scene`. Scenes that differ only in values that live in slots have the same text. */
  readonly sceneModule: string;
  readonly features: Features;
  /** The features in words. */
  readonly description: readonly string[];
  /** Contents of the uniform `scene`. */
  readonly uniform: ArrayBuffer;
  /** The scene's point that is the shader's origin; subtract it from the camera's position. */
  readonly origin: Vec3;
};

/**
 * Compiles a scene to generated WGSL and the data it reads. Pure, and quick enough for every change of a value: linking,
 * which is not, is needed only when `sceneModule` or `features` differ from before.
 *
 * @throws {UnsupportedError} if the scene holds something that can't be rendered yet.
 */
export function compileScene(scene: ResolvedScene, settings: ProgramSettings): CompiledScene {
  // What the camera looks at is where digits matter. Subtracted in doubles, before anything is rounded to f32, it makes a
  // scene far from the world's origin as precise as one around it.
  const origin = scene.camera.target;
  const primitives = primitivesOf(scene, origin);
  const emitters = emittersOf(scene, primitives, origin, settings.estimator === "uniform" ? "even" : "power");
  const environment = scene.environment.radiance;
  const features = deriveFeatures(
    primitives,
    emitters,
    environment.some((value) => value > 0),
    settings,
  );
  const slots = new Slots();
  const sceneModule = emitScene(primitives, emitters, features, slots, () => slots.numbers.length / 4);
  const uniform = packScene(primitives, emitters, environment, slots.numbers);
  if (uniform.byteLength > MAX_UNIFORM_BYTES) {
    throw new UnsupportedError(
      `the scene's ${primitives.length} objects need ${uniform.byteLength} bytes of uniforms; there are ${MAX_UNIFORM_BYTES}. Use fewer objects`,
    );
  }
  return { sceneModule, features, description: describeFeatures(primitives, emitters, features), uniform, origin };
}
