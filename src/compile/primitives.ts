import { sum } from "../lights/light";
import type { ResolvedMaterial, ResolvedScene, Rgb } from "../scene/schema";
import { shown } from "../scene/shown";
import { placed, placeOf } from "../shapes/placed";
import { kindOfObject, type Shape } from "../shapes/shapes";
import type { Geometry } from "../tree/geometry";

/** Something a ray can hit. Its index in the scene is its id in the shader. */
export type Primitive = {
  readonly shape: Shape;
  /** `"black"`: the body of a light, which reflects nothing. */
  readonly material: ResolvedMaterial | "black";
  /** Radiance, W·sr⁻¹·m⁻², from the front side. */
  readonly emission: Rgb;
};

/**
 * The scene's objects, then the bodies of its lights.
 *
 * @param geometry - of the scene's meshes.
 * @throws {TypeError} without the geometry of a mesh.
 */
export function primitivesOf(scene: ResolvedScene, geometry?: Geometry): Primitive[] {
  const place = placeOf(scene);
  const parts = new Map(geometry?.parts.map((part) => [part.id, part]));
  const { shapes, bodies } = placed(scene);
  const surfaces = new Map(Object.entries(scene.materials).map(([name, material]) => [name, shown(material)]));
  const objects = scene.objects.map((object, id) => {
    const material = surfaces.get(object.material)!;
    const part = parts.get(id);
    const triangles = part && { lower: part.lower, upper: part.upper, light: geometry?.lights.get(id) };
    const shape = shapes[id] ?? kindOfObject(object).place(object, { ...place, triangles });
    return { shape, material, emission: material.emission };
  });
  return [
    ...objects,
    ...bodies.map(({ shape, radiance }) => ({ shape, material: "black" as const, emission: radiance })),
  ];
}

/** Lights emit even at power 0, so that turning one down does not change the program. */
export function isEmissive(primitive: Primitive): boolean {
  return primitive.material === "black" || sum(primitive.emission) > 0;
}
