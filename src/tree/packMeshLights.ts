import { aliasTable } from "../math/aliasTable";
import type { Triangles } from "../shapes/shape";
import type { MeshPart } from "./meshPart";

const ENTRY_WORDS = 4;

/** How light sampling chooses among the triangles of a mesh. */
export type MeshLight = NonNullable<Triangles["light"]>;

/**
 * The triangles of meshes that emit, as `lights/mesh.wgsl` chooses among them: per entry the probability to keep its turn, its
 * slot, and the slot that has the turn otherwise; 16 bytes.
 *
 * @returns the table, undefined if it is empty; and the light of each mesh that has an area, by id.
 */
export function packMeshLights(
  parts: readonly MeshPart[],
  slotOf: Uint32Array,
): { lights: ReadonlyMap<number, MeshLight>; table: ArrayBuffer | undefined } {
  const count = parts.reduce((sum, { object }) => sum + object.indices.length / 3, 0);
  const table = new ArrayBuffer(4 * ENTRY_WORDS * count);
  const [floats, words] = [new Float32Array(table), new Uint32Array(table)];
  const lights = new Map<number, MeshLight>();
  let first = 0;
  for (const part of parts) {
    const areas = areasOf(part);
    const area = areas.reduce((sum, each) => sum + each, 0);
    if (area > 0) {
      const { probability, alias } = aliasTable(areas);
      for (let i = 0; i < areas.length; i++) {
        const at = ENTRY_WORDS * (first + i);
        floats[at] = probability[i]!;
        words[at + 1] = slotOf[part.firstTriangle + i]!;
        words[at + 2] = slotOf[part.firstTriangle + alias[i]!]!;
      }
      lights.set(part.id, { first, count: areas.length, area });
    }
    first += areas.length;
  }
  return { lights, table: lights.size > 0 ? table : undefined };
}

function areasOf({ object: { indices }, positions: p }: MeshPart): Float64Array {
  const areas = new Float64Array(indices.length / 3);
  for (let i = 0; i < areas.length; i++) {
    const [a, b, c] = [3 * indices[3 * i]!, 3 * indices[3 * i + 1]!, 3 * indices[3 * i + 2]!];
    const [ux, uy, uz] = [p[b]! - p[a]!, p[b + 1]! - p[a + 1]!, p[b + 2]! - p[a + 2]!];
    const [vx, vy, vz] = [p[c]! - p[a]!, p[c + 1]! - p[a + 1]!, p[c + 2]! - p[a + 2]!];
    areas[i] = Math.hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx) / 2;
  }
  return areas;
}
