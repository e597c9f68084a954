// Shapes other than meshes that are too many to be unrolled, and go into the tree instead.

import type { ResolvedScene, Vec3 } from "../scene/schema";
import { hasArea, type Shape, shapesOf } from "./primitives";

/** A shape in the tree, and the id of its primitive. */
export type TreeShape = { readonly id: number; readonly shape: BoundedShape };
export type BoundedShape = Exclude<Shape, { kind: "mesh" | "plane" }>;

// Keeps the size and the compile time of programs bounded: 150 unrolled shapes took 2.3 s. Where the tree becomes the quicker one
// has not been measured.
const MAX_UNROLLED = 48;

/** The scene's bounded shapes, if they are more than `MAX_UNROLLED`; else none. */
export function treeShapesOf(scene: ResolvedScene, origin: Vec3): TreeShape[] {
  const bounded = shapesOf(scene, origin).filter((entry): entry is TreeShape => isBounded(entry.shape));
  return bounded.length > MAX_UNROLLED ? bounded : [];
}

/** Whether a scene has something for the tree: for `prepareGeometry`, which pages load only then. */
export function needsGeometry(scene: ResolvedScene): boolean {
  return scene.objects.some(({ type }) => type === "mesh") || treeShapesOf(scene, scene.camera.target).length > 0;
}

/** Huge spheres are measured from a point on them, which the tree has no room for. */
function isBounded(shape: Shape): boolean {
  if (shape.kind === "sphere") return shape.foot === undefined;
  if (shape.kind === "triangle") return hasArea(shape.vertices);
  return shape.kind !== "plane" && shape.kind !== "mesh";
}
