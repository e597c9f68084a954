// Shapes that a tree can hold, and whether a scene needs one.

import type { ResolvedScene, Vec3 } from "../scene/schema";
import { hasArea, type Shape, shapesOf } from "./primitives";

/** All but meshes, planes and what is nowhere or too large. */
export type BoundedShape = Exclude<Shape, { kind: "mesh" | "plane" }>;
/** A shape, and the id of its primitive. */
export type BoundedPrimitive = { readonly id: number; readonly shape: BoundedShape };

/**
 * More bounded shapes are not all unrolled into the program. On a software adapter the tree is as quick for about so many, in the
 * open a few less and in a room a few more, and compiles in half the time.
 */
export const MAX_UNROLLED = 32;

export function* boundedShapesOf(scene: ResolvedScene, origin: Vec3): Generator<BoundedPrimitive> {
  for (const { id, shape } of shapesOf(scene, origin)) if (isBounded(shape)) yield { id, shape };
}

/** Whether a scene has something for the tree: for `prepareGeometry`, which pages load only then. */
export function needsGeometry(scene: ResolvedScene): boolean {
  if (scene.objects.some(({ type }) => type === "mesh")) return true;
  const bounded = boundedShapesOf(scene, scene.camera.target);
  for (let count = 0; !bounded.next().done; count++) if (count === MAX_UNROLLED) return true;
  return false;
}

/** Huge spheres are measured from a point on them, which the tree has no room for. */
function isBounded(shape: Shape): shape is BoundedShape {
  if (shape.kind === "sphere") return shape.foot === undefined;
  if (shape.kind === "triangle") return hasArea(shape.vertices);
  return shape.kind !== "plane" && shape.kind !== "mesh";
}
