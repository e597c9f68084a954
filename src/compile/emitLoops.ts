// Writes the parts of the shader module `scene` that go through the shapes of a table: planes and huge spheres, of which there are
// too many to unroll them. No tree can hold them.

import { subtract } from "../math/vec3";
import { UNBOUNDED } from "./layouts";
import type { Primitive } from "./primitives";
import type { Unrolling } from "./unrolling";

/** One of the tables, and how its rows are met. */
type Table = { readonly name: string; readonly ids: readonly number[]; readonly distance: string };

function tablesOf({ planes, hugeSpheres }: Unrolling): Table[] {
  const tables = [
    { name: "planes", ids: planes, distance: "planeIntersect(ray, row.point, row.direction)" },
    { name: "hugeSpheres", ids: hugeSpheres, distance: "hugeSphereIntersect(ray, row.point, row.direction, row.id)" },
  ];
  return tables.filter(({ ids }) => ids.length > 0);
}

/** The struct of a row; nothing for a scene without tables. */
export function emitRowStruct(unrolling: Unrolling): string {
  if (tablesOf(unrolling).length === 0) return "";
  return `
// A plane: a point on it and its normal. A huge sphere: its foot, and the vector from its centre to there.
struct Unbounded {
${Object.entries(UNBOUNDED.fields)
  .map(([name, type]) => `  ${name}: ${type},\n`)
  .join("")}}
`;
}

/** The members of the struct `Scene`. */
export function emitTableMembers(unrolling: Unrolling): string {
  return tablesOf(unrolling)
    .map(({ name, ids }) => `  ${name}: array<Unbounded, ${ids.length}>,\n`)
    .join("");
}

/** Statements that put the nearest in `hit`. */
export function emitClosestLoops(unrolling: Unrolling): string {
  return tablesOf(unrolling)
    .map(
      ({ name, ids, distance }) => `  for (var i = 0u; i < ${ids.length}u; i++) {
    let row = scene.${name}[i];
    hit = nearer(hit, ${distance}, row.id, ray);
  }
`,
    )
    .join("");
}

/** Statements that set `blocked` if one is in between. */
export function emitBlockingLoops(unrolling: Unrolling): string {
  return tablesOf(unrolling)
    .map(
      ({ name, ids, distance }) => `  for (var i = 0u; i < ${ids.length}u && !blocked; i++) {
    let row = scene.${name}[i];
    blocked = between(${distance}, distance, row.id, ray) & (row.id != target_);
  }
`,
    )
    .join("");
}

/** The rows of all tables, in the order of the members. */
export function unboundedRows(unrolling: Unrolling, primitives: readonly Primitive[]) {
  return tablesOf(unrolling).flatMap(({ ids }) =>
    ids.map((id) => {
      const { shape } = primitives[id]!;
      if (shape.kind === "plane") return { point: shape.point, id, direction: shape.normal };
      if (shape.kind === "sphere" && shape.foot) {
        return { point: shape.foot, id, direction: subtract(shape.foot, shape.center) };
      }
      throw new TypeError(`a ${shape.kind} is in no table`);
    }),
  );
}
