// Shapes that a tree can hold, and whether a scene needs one.

import { isClearWall } from "../lobes/coverage";
import type { ResolvedScene } from "../scene/schema";
import { placed } from "../shapes/placed";
import { isMesh, kindOf, type Shape } from "../shapes/shapes";

/** A shape that is neither infinite, nor nowhere, nor too large; and the id of its primitive. */
export type BoundedPrimitive = { readonly id: number; readonly shape: Shape };

/**
 * More bounded shapes are not all unrolled into the program. On a software adapter the tree is as quick for about so many, in the
 * open a few less and in a room a few more, and compiles in half the time.
 */
export const MAX_UNROLLED = 32;

export function boundedShapesOf(scene: ResolvedScene): BoundedPrimitive[] {
  const { shapes } = placed(scene);
  const bounded: BoundedPrimitive[] = [];
  for (const [id, shape] of shapes.entries()) {
    if (shape && kindOf(shape).meeting(shape) === "bounded") bounded.push({ id, shape });
  }
  return bounded;
}

/** Whether a scene has something for the tree: for `prepareGeometry`, which pages load only then. */
export function needsGeometry(scene: ResolvedScene): boolean {
  if (scene.objects.some(isMesh)) return true;
  const bounded = boundedShapesOf(scene);
  return bounded.length > MAX_UNROLLED || bounded.some((each) => isWall(scene, each));
}

/**
 * Whether a shape is a wall that light passes straight. What it lets pass takes the whole of a surface to tell: in a program that is
 * compiled many times over for a shape that is unrolled, and once for all that are in a tree. Four of them took over 80 s to compile.
 */
export function isWall({ objects, materials }: ResolvedScene, { id }: Pick<BoundedPrimitive, "id">): boolean {
  const object = objects[id];
  if (object === undefined) return false; // the body of a light
  const material = materials[object.material]!;
  return !material.unlit && isClearWall(material);
}
