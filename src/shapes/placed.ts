import { bodyOf } from "../lights/lights";
import { length, subtract } from "../math/vec3";
import type { ResolvedScene, Rgb } from "../scene/schema";
import type { Place } from "./shape";
import { isMesh, kindOfObject, type Shape } from "./shapes";

/**
 * Where the compiler puts a scene: around what its camera looks at, because that is where digits matter. Subtracted in doubles,
 * before anything is rounded to f32, it makes a scene far from the world's origin as precise as one around it.
 */
export function placeOf({ camera }: ResolvedScene): Place {
  return { origin: camera.target, reach: length(subtract(camera.position, camera.target)) };
}

/** What has a shape, and where nothing else can be hit: the scene's objects, then the bodies of its lights. */
export type Placed = {
  /** By the id of the primitive; undefined for a mesh, whose triangles are another's. */
  readonly shapes: readonly (Shape | undefined)[];
  /** Of each body, after the objects: its radiance, W·sr⁻¹·m⁻². */
  readonly bodies: readonly { readonly shape: Shape; readonly radiance: Rgb }[];
};

/** The shapes of a scene; the same for the same scene. */
export function placed(scene: ResolvedScene): Placed {
  const before = known.get(scene);
  if (before) return before;
  const place = placeOf(scene);
  const bodies = scene.lights.flatMap((light) => {
    const given = bodyOf(light);
    return given ? [{ shape: kindOfObject(given.body).place(given.body, place), radiance: given.radiance }] : [];
  });
  const objects = scene.objects.map((object) => {
    return isMesh(object) ? undefined : kindOfObject(object).place(object, place);
  });
  const result = { shapes: [...objects, ...bodies.map(({ shape }) => shape)], bodies };
  known.set(scene, result);
  return result;
}

// A scene is placed when its tree is asked for, when that is built, and when it is compiled.
const known = new WeakMap<ResolvedScene, Placed>();
