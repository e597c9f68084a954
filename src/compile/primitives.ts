import { sum } from "../lights/light";
import { bodyOf } from "../lights/lights";
import { length, subtract } from "../math/vec3";
import type { ResolvedMaterial, ResolvedObject, ResolvedScene, Rgb, Vec3 } from "../scene/schema";
import type { Place } from "../shapes/shape";
import { isMesh, kindOfObject, type Shape } from "../shapes/shapes";
import type { Geometry } from "./geometry";

/** Something a ray can hit. Its index in the scene is its id in the shader. */
export type Primitive = {
  readonly shape: Shape;
  /** `"black"`: the body of a sphere light, which reflects nothing. */
  readonly material: ResolvedMaterial | "black";
  /** Radiance, W·sr⁻¹·m⁻², from the front side. */
  readonly emission: Rgb;
};

/**
 * The scene's objects, then the bodies of its lights.
 *
 * @param geometry - of the scene's meshes.
 */
export function primitivesOf(scene: ResolvedScene, origin: Vec3, geometry?: Geometry): Primitive[] {
  const place = placeOf(scene, origin);
  const parts = new Map(geometry?.parts.map((part) => [part.id, part]));
  const objects = scene.objects.map((object, id) => {
    const material = scene.materials[object.material]!;
    const part = parts.get(id);
    const triangles = part && { lower: part.lower, upper: part.upper, light: geometry?.lights.get(id) };
    return { shape: shapeOf(object, { ...place, triangles }), material, emission: material.emission };
  });
  const lights = bodiesOf(scene).map(({ body, radiance }): Primitive => {
    return { shape: shapeOf(body, place), material: "black", emission: radiance };
  });
  return [...objects, ...lights];
}

/** The scene's shapes, meshes aside, each with the id of its primitive; one by one, for those who need no more than a few. */
export function* shapesOf(
  scene: ResolvedScene,
  origin: Vec3,
): Generator<{ readonly id: number; readonly shape: Shape }> {
  const place = placeOf(scene, origin);
  for (const [id, object] of scene.objects.entries()) {
    if (!isMesh(object)) yield { id, shape: shapeOf(object, place) };
  }
  for (const [i, { body }] of bodiesOf(scene).entries()) {
    yield { id: scene.objects.length + i, shape: shapeOf(body, place) };
  }
}

/** Lights emit even at power 0, so that turning one down does not change the program. */
export function isEmissive(primitive: Primitive): boolean {
  return primitive.material === "black" || sum(primitive.emission) > 0;
}

function placeOf(scene: ResolvedScene, origin: Vec3): Place {
  return { origin, reach: length(subtract(scene.camera.position, origin)) };
}

function shapeOf(object: ResolvedObject, place: Place): Shape {
  return kindOfObject(object).place(object, place);
}

function bodiesOf({ lights }: ResolvedScene) {
  return lights.flatMap((light) => bodyOf(light) ?? []);
}
