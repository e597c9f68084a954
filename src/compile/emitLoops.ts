// @lean wgsl
// Writes the parts of the shader module `scene` that go through the shapes of a table: planes and huge spheres, of which there are
// too many to unroll them. No tree can hold them.

import { emitStruct } from "./defineStruct";
import { UNBOUNDED } from "./layouts";
import type { Primitive } from "./primitives";
import type { Unrolling } from "./unrolling";

/** Whether primitive `id` has holes. */
type IsPart = (id: number) => boolean;

/** The struct of a row; nothing for a scene without tables. */
export function emitRowStruct(unrolling: Unrolling): string {
  if (unrolling.loops.length === 0) return "";
  return `
// A plane: a point on it and its normal. A huge sphere: its foot, and the vector from its centre to there.
${emitStruct("Unbounded", UNBOUNDED)}`;
}

/** Statements that put the nearest in `hit`. */
export function emitClosestLoops(unrolling: Unrolling, isPart: IsPart): string {
  return unrolling.loops
    .map(
      ({ table: { table, distance }, ids }) => `  for (var i = 0u; i < ${ids.length}u; i++) {
    let row = scene.${table}[i];
    hit = nearer${ids.some(isPart) ? "Part" : ""}(hit, ${distance}, row.id, ray);
  }
`,
    )
    .join("");
}

/** Statements that set `blocked` if one is in between. */
export function emitBlockingLoops(unrolling: Unrolling, isPart: IsPart): string {
  return unrolling.loops
    .map(
      ({ table: { table, distance }, ids }) => `  for (var i = 0u; i < ${ids.length}u && !blocked; i++) {
    let row = scene.${table}[i];
    blocked = between${ids.some(isPart) ? "Part" : ""}(${distance}, distance, row.id, ray) & (row.id != target_);
  }
`,
    )
    .join("");
}

/** The rows of each table. */
export function unboundedRows(unrolling: Unrolling, primitives: readonly Primitive[]) {
  return unrolling.loops.map(({ table, ids }) => ids.map((id) => ({ ...table.row(primitives[id]!.shape), id })));
}
