// Which shapes the program meets one by one, in code of their own, and which it goes through in a loop.

import type { Geometry } from "./geometry";
import { hasArea, type Primitive, type Shape } from "./primitives";

/** Ids of primitives, by how a program meets what is not in its tree. */
export type Unrolling = {
  readonly unrolled: readonly number[];
  /** Planes past the first few. */
  readonly planes: readonly number[];
  /** Huge spheres, likewise. */
  readonly hugeSpheres: readonly number[];
};

// A shape takes some 20 ms to compile, and more the more there are: 200 planes took 12 s. Bounded shapes are in the tree where they
// are many. No tree can hold planes and huge spheres: those past this number, all kinds together, are rows of a table. In its
// loop they take no time to compile, and a ray takes four times as long to meet one on a software adapter.
const MAX_UNROLLED = 40;

/** At most `MAX_UNROLLED` shapes are unrolled: bounded ones first, then planes, then huge spheres. */
export function unrollingOf(primitives: readonly Primitive[], geometry: Geometry | undefined): Unrolling {
  const [bounded, planes, hugeSpheres]: [number[], number[], number[]] = [[], [], []];
  for (const [id, { shape }] of primitives.entries()) {
    if (shape.kind === "plane") planes.push(id);
    else if (shape.kind === "sphere" && shape.foot) hugeSpheres.push(id);
    else if (isMet(shape) && !geometry?.shapes.has(id)) bounded.push(id);
  }
  const planeCount = Math.min(planes.length, Math.max(MAX_UNROLLED - bounded.length, 0));
  const hugeCount = Math.min(hugeSpheres.length, Math.max(MAX_UNROLLED - bounded.length - planeCount, 0));
  const unrolled = [...bounded, ...planes.slice(0, planeCount), ...hugeSpheres.slice(0, hugeCount)];
  return {
    unrolled: unrolled.sort((a, b) => a - b),
    planes: planes.slice(planeCount),
    hugeSpheres: hugeSpheres.slice(hugeCount),
  };
}

/** A mesh is met by its triangles. A triangle without area, in f32, would be hit by rays at it, at distances that are noise. */
function isMet(shape: Shape): boolean {
  if (shape.kind === "triangle") return hasArea(shape.vertices);
  return shape.kind !== "mesh";
}
