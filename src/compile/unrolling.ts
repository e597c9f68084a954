// Which shapes the program meets one by one, in code of their own, and which it goes through in a loop.

import { isClearWall } from "../lobes/coverage";
import { kindOf, LOOPS, type LoopTable } from "../shapes/shapes";
import type { Geometry } from "../tree/geometry";
import type { Primitive } from "./primitives";

/** Ids of primitives, by how a program meets what is not in its tree. */
export type Unrolling = {
  readonly unrolled: readonly number[];
  /** The rows of each table that has some: the rest of those that no tree can hold. */
  readonly loops: readonly { readonly table: LoopTable; readonly ids: readonly number[] }[];
};

// A shape takes some 20 ms to compile, and more the more there are: 200 planes took 12 s. Bounded shapes are in the tree where they
// are many. No tree can hold planes and huge spheres: those past this number, all kinds together, are rows of a table. In its
// loop they take no time to compile, and a ray takes four times as long to meet one on a software adapter.
const MAX_UNROLLED = 40;

/**
 * At most `MAX_UNROLLED` shapes are unrolled: bounded ones first, then those of one table after the other. Of those no wall that light
 * passes straight is: see `isWall`.
 */
export function unrollingOf(primitives: readonly Primitive[], geometry: Geometry | undefined): Unrolling {
  const unrolled: number[] = [];
  const walls = new Set<number>();
  const tables = new Map<LoopTable, number[]>(LOOPS.map((table) => [table, []]));
  for (const [id, { shape, material }] of primitives.entries()) {
    const { meeting, loop } = kindOf(shape);
    const how = meeting(shape);
    if (how === "loop") tables.get(loop!)!.push(id);
    if (how === "loop" && material !== "black" && isClearWall(material)) walls.add(id);
    if (how === "bounded" && !geometry?.shapes.has(id)) unrolled.push(id);
  }
  const loops = [];
  for (const [table, all] of tables) {
    const free = all.filter((id) => !walls.has(id));
    unrolled.push(...free.slice(0, Math.max(MAX_UNROLLED - unrolled.length, 0)));
    const ids = all.filter((id) => !unrolled.includes(id));
    if (ids.length > 0) loops.push({ table, ids });
  }
  return { unrolled: unrolled.sort((a, b) => a - b), loops };
}
