import type { MeshPart } from "./geometry";
import { NO_NORMAL, packDirections } from "./octahedral";

const ITEM_WORDS = 12;

/**
 * The triangles of all meshes as `wgsl/tree.wgsl` and `wgsl/mesh.wgsl` read them, by slot. An item is 48 bytes: vertex a, the
 * primitive's id, vertex b, 1 if the front is where a, b, c run clockwise and else 0, vertex c, 4 unused bytes. Vertices are in
 * lexicographic order, as f32 keeps them: triangles that share an edge then agree on its direction, whatever their own.
 *
 * @param slotOf - by triangle, numbered through all meshes.
 */
export function packItems(
  parts: readonly MeshPart[],
  slotOf: Uint32Array,
): { items: ArrayBuffer; normals: ArrayBuffer | undefined } {
  const items = new ArrayBuffer(4 * ITEM_WORDS * Math.max(slotOf.length, 1));
  const isSmooth = parts.some(({ object }) => object.normals !== undefined);
  const normals = isSmooth ? new Uint32Array(3 * Math.max(slotOf.length, 1)).fill(NO_NORMAL) : undefined;
  const floats = new Float32Array(items);
  const words = new Uint32Array(items);

  for (const { object, id, positions, firstTriangle } of parts) {
    const { indices } = object;
    const isBelow = (v: number, w: number) => {
      for (let axis = 0; axis < 3; axis++) {
        const [x, y] = [positions[3 * v + axis]!, positions[3 * w + axis]!];
        if (x !== y) return x < y;
      }
      return false;
    };
    const vertexNormals = object.normals && packDirections(object.normals);
    for (let i = 0; i < indices.length; i += 3) {
      let [a, b, c] = [indices[i]!, indices[i + 1]!, indices[i + 2]!];
      let isTurned = false;
      if (isBelow(b, a)) [a, b, isTurned] = [b, a, !isTurned];
      if (isBelow(c, b)) [b, c, isTurned] = [c, b, !isTurned];
      if (isBelow(b, a)) [a, b, isTurned] = [b, a, !isTurned];

      const slot = slotOf[firstTriangle + i / 3]!;
      const at = ITEM_WORDS * slot;
      for (let axis = 0; axis < 3; axis++) {
        floats[at + axis] = positions[3 * a + axis]!;
        floats[at + 4 + axis] = positions[3 * b + axis]!;
        floats[at + 8 + axis] = positions[3 * c + axis]!;
      }
      words[at + 3] = id;
      words[at + 7] = isTurned ? 1 : 0;
      if (normals && vertexNormals) {
        normals[3 * slot] = vertexNormals[a]!;
        normals[3 * slot + 1] = vertexNormals[b]!;
        normals[3 * slot + 2] = vertexNormals[c]!;
      }
    }
  }
  return { items, normals: normals?.buffer };
}
