import { NO_NORMAL, packDirections } from "../math/octahedral";
import { itemOf } from "../shapes/shapes";
import type { BoundedPrimitive } from "./boundedShapes";
import type { MeshPart } from "./meshPart";
import { type VertexLayout, writeVertex } from "./vertexLayout";

const ITEM_WORDS = 12;
// Kinds of items: the two that are triangles of a mesh.
const MESH_TRIANGLE = 0;
const TURNED_TRIANGLE = 1;

export type PackedItems = {
  readonly items: ArrayBuffer;
  /** Of the three vertices of each triangle; undefined where no mesh has normals. */
  readonly normals: ArrayBuffer | undefined;
  /** Likewise what else vertices have; undefined where that is nothing. */
  readonly vertices: ArrayBuffer | undefined;
};

/**
 * The items of the tree as `wgsl/tree.wgsl` and `shapes/mesh.wgsl` read them, by slot. An item is 48 bytes: three f32, the
 * primitive's id, three f32, the kind, four f32. A triangle's vertices are in lexicographic order, as f32 keeps them: triangles
 * that share an edge then agree on its direction, whatever their own.
 *
 * @param slotOf - by item: the triangles of all meshes, then the shapes.
 */
export function packItems(
  parts: readonly MeshPart[],
  shapes: readonly BoundedPrimitive[],
  slotOf: Uint32Array,
  layout: VertexLayout,
): PackedItems {
  const count = Math.max(slotOf.length, 1); // WebGPU has no empty buffers
  const items = new ArrayBuffer(4 * ITEM_WORDS * count);
  const [floats, words] = [new Float32Array(items), new Uint32Array(items)];
  const isSmooth = parts.some(({ object }) => object.normals !== undefined);
  const normals = isSmooth ? new Uint32Array(3 * count).fill(NO_NORMAL) : undefined;
  const vertices = layout.stride > 0 ? new Float32Array(6 * layout.stride * count) : undefined;

  for (const { object, id, positions, firstTriangle } of parts) {
    const { indices } = object;
    const vertexNormals = object.normals && packDirections(object.normals);
    const corners = new Uint32Array(3);
    for (let i = 0; i < indices.length; i += 3) {
      for (let corner = 0; corner < 3; corner++) corners[corner] = indices[i + corner]!;
      const isTurned = sortCorners(corners, positions);
      const slot = slotOf[firstTriangle + i / 3]!;
      const at = ITEM_WORDS * slot;
      words[at + 3] = id;
      words[at + 7] = isTurned ? TURNED_TRIANGLE : MESH_TRIANGLE;
      for (let corner = 0; corner < 3; corner++) {
        const vertex = corners[corner]!;
        for (let axis = 0; axis < 3; axis++) floats[at + 4 * corner + axis] = positions[3 * vertex + axis]!;
        if (normals && vertexNormals) normals[3 * slot + corner] = vertexNormals[vertex]!;
        if (vertices) writeVertex(vertices, 2 * layout.stride * (3 * slot + corner), vertex, object, layout);
      }
    }
  }
  for (const [i, { id, shape }] of shapes.entries()) {
    const { tag, vectors, w } = itemOf(shape);
    const at = ITEM_WORDS * slotOf[slotOf.length - shapes.length + i]!;
    for (const [row, vector] of vectors.entries()) floats.set(vector, at + 4 * row);
    words[at + 3] = id;
    words[at + 7] = tag;
    floats[at + 11] = w;
  }
  return { items, normals: normals?.buffer, vertices: vertices?.buffer };
}

/** Sorts three vertices by their positions, and tells whether that turned the triangle round. */
function sortCorners(corners: Uint32Array, positions: Float32Array): boolean {
  const first = sortPair(corners, 0, positions);
  const second = sortPair(corners, 1, positions);
  const third = sortPair(corners, 0, positions);
  return (first !== second) !== third;
}

/** Swaps a corner with the next one if it comes after it, and tells whether. */
function sortPair(corners: Uint32Array, i: number, positions: Float32Array): boolean {
  const [v, w] = [corners[i]!, corners[i + 1]!];
  for (let axis = 0; axis < 3; axis++) {
    const difference = positions[3 * v + axis]! - positions[3 * w + axis]!;
    if (difference < 0) return false;
    if (difference === 0) continue;
    corners[i] = w;
    corners[i + 1] = v;
    return true;
  }
  return false;
}
