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

/** Everything there is to know of a shape's kind. TypeScript does not correlate a union with its table. */
export type AnyKind = ShapeKind<ResolvedObject, Shape>;

export function kindOf({ kind }: Shape): AnyKind {
  return SHAPE_KINDS[kind] as unknown as AnyKind;
}

/** Likewise of an object of the scene. */
export function kindOfObject({ type }: ResolvedObject): AnyKind {
  return SHAPE_KINDS[type] as unknown as AnyKind;
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

// A mesh has two kinds of items: triangles that run counter-clockwise seen from their front, and those that run clockwise.
const FIRST_ITEM = 2;
const WITH_ITEMS = ALL.filter(({ item }) => item !== undefined);

/** What the shader's tree can hold beside the triangles of meshes, by its number there. */
export const ITEMS = WITH_ITEMS.map(({ item }, i) => ({ tag: FIRST_ITEM + i, ...item! }));

/** A shape as an item of the tree: its kind's number, three vectors and a number. */
export function itemOf(shape: Shape): ItemRow & { readonly tag: number } {
  const kind = kindOf(shape);
  return { tag: FIRST_ITEM + WITH_ITEMS.indexOf(kind), ...kind.item!.row(shape) };
}
