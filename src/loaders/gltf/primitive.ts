// One primitive of a mesh as triangles, in its own space.

import type { Accessor } from "@gltf-transform/core";
import { LoadError } from "../../errors";
import { MAX_VERTEX_VALUE } from "../limits";
import type { GltfPrimitive } from "./schema";

/** Triangles in the space of their mesh. Typed arrays may be shared with others made from the same data. */
export type Triangles = {
  readonly positions: Float32Array;
  readonly normals?: Float32Array;
  /** By number of the set: `TEXCOORD_1` is `uvs.get(1)`. */
  readonly uvs: ReadonlyMap<number, Float32Array>;
  readonly indices: Uint32Array;
};

const [TRIANGLES, STRIP, FAN] = [4, 5, 6] as const;

/** Whether a primitive consists of triangles, and not of points or lines. */
export function hasTriangles({ mode }: GltfPrimitive): boolean {
  return mode === TRIANGLES || mode === STRIP || mode === FAN;
}

/** Vertex data as floats, each accessor read and checked once: primitives often share them. */
export class VertexData {
  readonly #accessors: readonly Accessor[];
  readonly #floats = new Map<Accessor, Float32Array>();

  /** @param accessors - unpacked, by their index in the file. */
  constructor(accessors: readonly Accessor[]) {
    this.#accessors = accessors;
  }

  at(index: number): Accessor {
    return this.#accessors[index]!;
  }

  /**
   * The values as they are meant: integers that stand for fractions are those fractions.
   *
   * @throws {LoadError} if the data is not of this form, which Draco's may not be though the JSON says so, or not finite.
   */
  floats(index: number, size: number, vertexCount: number, path: string): Float32Array {
    const accessor = this.at(index);
    const array = accessor.getArray();
    if (accessor.getElementSize() !== size || array === null || array.length !== vertexCount * size) {
      throw new LoadError(`${path}: expected ${size} numbers for each of ${vertexCount} vertices`);
    }
    const known = this.#floats.get(accessor);
    if (known !== undefined) return known;
    const floats = array instanceof Float32Array ? array : toFloats(array, accessor.getNormalized());
    for (let i = 0; i < floats.length; i++) {
      if (Math.abs(floats[i]!) <= MAX_VERTEX_VALUE) continue;
      throw new LoadError(`${path}: number ${i} is ${floats[i]}; expected a magnitude of at most ${MAX_VERTEX_VALUE}`);
    }
    this.#floats.set(accessor, floats);
    return floats;
  }
}

/**
 * Only vertices from the lowest to the highest index are kept: primitives often share one large array.
 *
 * @param path - of the primitive, for errors.
 * @returns `undefined` if there is not a single triangle.
 * @throws {LoadError} if an index is out of range or a position is not finite.
 */
export function readTriangles(primitive: GltfPrimitive, data: VertexData, path: string): Triangles | undefined {
  const { attributes } = primitive;
  if (attributes.POSITION === undefined) return undefined;
  const vertexCount = data.at(attributes.POSITION).getCount();
  const read = (semantic: string, size: number) =>
    data.floats(attributes[semantic]!, size, vertexCount, `${path}.attributes.${semantic}`);
  const positions = read("POSITION", 3);
  const indices = triangulate(indicesOf(primitive, data, vertexCount), primitive.mode);
  if (indices.length === 0) return undefined;

  const [first, last] = rangeOf(indices);
  if (last >= vertexCount) throw new LoadError(`${path}.indices: vertex ${last} is not one of ${vertexCount}`);
  if (first > 0) for (let i = 0; i < indices.length; i++) indices[i]! -= first;
  const cut = (values: Float32Array, size: number) => values.subarray(first * size, (last + 1) * size);

  const uvs = new Map<number, Float32Array>();
  for (const semantic of Object.keys(attributes)) {
    const set = /^TEXCOORD_(\d+)$/.exec(semantic)?.[1];
    if (set !== undefined) uvs.set(Number(set), cut(read(semantic, 2), 2));
  }
  return {
    positions: cut(positions, 3),
    indices,
    uvs,
    ...(attributes.NORMAL !== undefined && { normals: cut(read("NORMAL", 3), 3) }),
  };
}

function toFloats(array: NonNullable<ReturnType<Accessor["getArray"]>>, isNormalized: boolean): Float32Array {
  const floats = new Float32Array(array);
  if (!isNormalized) return floats;
  const isSigned = array instanceof Int8Array || array instanceof Int16Array;
  const maximum = 2 ** (8 * array.BYTES_PER_ELEMENT - (isSigned ? 1 : 0)) - 1;
  for (let i = 0; i < floats.length; i++) floats[i] = Math.max(-1, floats[i]! / maximum);
  return floats;
}

/** A copy of the indices; without any, the vertices in their order. */
function indicesOf({ indices }: GltfPrimitive, data: VertexData, vertexCount: number): Uint32Array {
  if (indices !== undefined) return new Uint32Array(data.at(indices).getArray() ?? []);
  const all = new Uint32Array(vertexCount);
  for (let i = 0; i < vertexCount; i++) all[i] = i;
  return all;
}

/** Strips and fans as separate triangles, wound the same way. What is left over at the end is dropped, as GPUs do. */
function triangulate(indices: Uint32Array, mode: number): Uint32Array {
  if (mode === TRIANGLES) return indices.subarray(0, indices.length - (indices.length % 3));
  const triangleCount = Math.max(0, indices.length - 2);
  const triangles = new Uint32Array(3 * triangleCount);
  for (let i = 0; i < triangleCount; i++) {
    // glTF 2.0, 3.7.2.1: strips turn around every other triangle, fans share their first vertex.
    const [a, b, c] = mode === FAN ? [i + 1, i + 2, 0] : [i, i + 1 + (i % 2), i + 2 - (i % 2)];
    triangles[3 * i] = indices[a]!;
    triangles[3 * i + 1] = indices[b]!;
    triangles[3 * i + 2] = indices[c]!;
  }
  return triangles;
}

function rangeOf(indices: Uint32Array): [number, number] {
  let first = Number.POSITIVE_INFINITY;
  let last = -1;
  for (let i = 0; i < indices.length; i++) {
    const index = indices[i]!;
    if (index < first) first = index;
    if (index > last) last = index;
  }
  return [first, last];
}
