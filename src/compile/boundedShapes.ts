// Shapes that a tree can hold, and whether a scene needs one.

import type { ResolvedScene, Vec3 } from "../scene/schema";
import { isMesh, kindOf, type Shape } from "../shapes/shapes";
import { shapesOf } from "./primitives";

/** A shape that is neither infinite, nor nowhere, nor too large; and the id of its primitive. */
export type BoundedPrimitive = { readonly id: number; readonly shape: Shape };

/**
 * More bounded shapes are not all unrolled into the program. On a software adapter the tree is as quick for about so many, in the
 * open a few less and in a room a few more, and compiles in half the time.
 */
export const MAX_UNROLLED = 32;

export function* boundedShapesOf(scene: ResolvedScene, origin: Vec3): Generator<BoundedPrimitive> {
  for (const primitive of shapesOf(scene, origin)) {
    const { shape } = primitive;
    if (kindOf(shape).meeting(shape) === "bounded") yield primitive;
  }
}

/** Whether a scene has something for the tree: for `prepareGeometry`, which pages load only then. */
export function needsGeometry(scene: ResolvedScene): boolean {
  if (scene.objects.some(isMesh)) return true;
  const bounded = boundedShapesOf(scene, scene.camera.target);
  for (let count = 0; !bounded.next().done; count++) if (count === MAX_UNROLLED) return true;
  return false;
}
