// Every kind of shape, a line each. To add one: its entry in the scene's schema, its file and shader module here, and a line below.

import type { ResolvedObject, Vec3 } from "../scene/schema";
import { type Box, box } from "./box";
import { type Mesh, mesh } from "./mesh";
import { type Plane, plane } from "./plane";
import { type Quad, quad } from "./quad";
import type { Hull, ItemRow, ShapeKind } from "./shape";
import { type Sphere, sphere } from "./sphere";
import { type Triangle, triangle } from "./triangle";

/** A shape as the intersectors want it, relative to the compiled scene's origin. */
export type Shape = Plane | Triangle | Sphere | Quad | Box | Mesh;

/** In the order in which the shader numbers those that the tree can hold. */
export const SHAPE_KINDS = { plane, triangle, sphere, quad, box, mesh } as const satisfies {
  readonly [K in ResolvedObject["type"]]: ShapeKind<ResolvedObject & { type: K }, Shape & { kind: K }>;
};

/** An object whose triangles go into the tree. */
export type MeshObject = Parameters<typeof mesh.place>[0];

/** Everything there is to know of a shape's kind. TypeScript does not correlate a union with its table. */
export type AnyKind = ShapeKind<ResolvedObject, Shape>;

export function kindOf({ kind }: Shape): AnyKind {
  return SHAPE_KINDS[kind] as unknown as AnyKind;
}

/** Likewise of an object of the scene. */
export function kindOfObject({ type }: ResolvedObject): AnyKind {
  return SHAPE_KINDS[type] as unknown as AnyKind;
}

/** Whether an object's triangles go into the tree. */
export function isMesh(object: ResolvedObject): object is MeshObject {
  return kindOfObject(object).triangleDistance !== undefined;
}

/** See `ShapeKind`. */
export function reachAlong(shape: Shape, direction: Vec3, from: Vec3): number {
  return kindOf(shape).reachAlong(shape, direction, from);
}

/** See `ShapeKind`. */
export function hullOf(shape: Shape): Hull | undefined {
  return kindOf(shape).hull(shape);
}

const ALL = Object.values(SHAPE_KINDS) as unknown as readonly AnyKind[];

export type LoopTable = NonNullable<AnyKind["loop"]>;
/** Tables of what no tree can hold. */
export const LOOPS: readonly LoopTable[] = ALL.flatMap(({ loop }) => loop ?? []);

// The first two are triangles of meshes: see `tree.wgsl`.
const FIRST_ITEM = 2;
const WITH_ITEMS = ALL.filter(({ item }) => item !== undefined);

/** What the shader's tree can hold beside the triangles of meshes, by its number there. */
export const ITEMS = WITH_ITEMS.map(({ item }, i) => ({ tag: FIRST_ITEM + i, ...item! }));

/** The number of a shape's kind in the tree. */
export function itemTag(shape: Shape): number {
  return FIRST_ITEM + WITH_ITEMS.indexOf(kindOf(shape));
}

/** A shape as an item of the tree. */
export function itemOf(shape: Shape): ItemRow & { readonly tag: number } {
  return { tag: itemTag(shape), ...kindOf(shape).item!.row(shape) };
}
