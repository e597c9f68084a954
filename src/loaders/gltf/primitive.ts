// One primitive of a mesh as triangles, in its own space.

import type { Accessor } from "@gltf-transform/core";
import { LoadError } from "../../errors";
import { MAX_VERTEX_VALUE } from "../limits";
import type { Warnings } from "../warnings";
import { fillFacetNormals, gather, separateBareCorners, withoutVertices } from "./repairTriangles";
import type { GltfPrimitive } from "./schema";

/** Triangles in the space of their mesh. Typed arrays may be shared with others made from the same data. */
export type Triangles = {
  readonly positions: Float32Array;
  readonly normals?: Float32Array;
  /** By number of the set: `TEXCOORD_1` is `uvs.get(1)`. */
  readonly uvs: ReadonlyMap<number, Float32Array>;
  /** Red, green, blue and alpha per vertex, from 0 to 1. */
  readonly colors?: Float32Array;
  /** x, y, z and ±1 per vertex. */
  readonly tangents?: Float32Array;
  readonly indices: Uint32Array;
};

const [TRIANGLES, STRIP, FAN] = [4, 5, 6] as const;

/** Whether a primitive consists of triangles, and not of points or lines. */
export function hasTriangles({ mode }: GltfPrimitive): boolean {
  return mode === TRIANGLES || mode === STRIP || mode === FAN;
}

/** Whether an attribute of this name has a part in the picture. No other is looked at, so none can refuse a file. */
export function isRead(semantic: string): boolean {
  return /^(POSITION|NORMAL|TANGENT|COLOR_0|TEXCOORD_\d+)$/.test(semantic);
}

/** Vertex data as floats, each accessor read and checked once: primitives often share them. */
export class VertexData {
  readonly #accessors: readonly Accessor[];
  readonly #floats = new Map<Accessor, Float32Array>();
  readonly #lost = new Map<Accessor, ReadonlySet<number>>();

  /** @param accessors - unpacked, by their index in the file. */
  constructor(accessors: readonly Accessor[]) {
    this.#accessors = accessors;
  }

  at(index: number): Accessor {
    return this.#accessors[index]!;
  }

  /**
   * The values as they are meant: integers that stand for fractions are those fractions. A vertex with a number that is not
   * finite, or too large, has zeros.
   *
   * @throws {LoadError} if the data is not of this form, which Draco's may not be though the JSON says so.
   */
  floats(index: number, size: number, vertexCount: number, path: string): Float32Array {
    const accessor = this.at(index);
    const array = accessor.getArray();
    if (accessor.getElementSize() !== size || array === null || array.length !== vertexCount * size) {
      throw new LoadError(`${path}: expected ${size} numbers for each of ${vertexCount} vertices`);
    }
    const known = this.#floats.get(accessor);
    if (known !== undefined) return known;
    const lost = new Set<number>();
    let floats = array instanceof Float32Array ? array : toFloats(array, accessor.getNormalized());
    for (let i = 0; i < floats.length; i++) {
      if (!(Math.abs(floats[i]!) <= MAX_VERTEX_VALUE)) lost.add(Math.floor(i / size));
    }
    if (lost.size > 0) floats = floats.slice();
    for (const vertex of lost) floats.fill(0, vertex * size, (vertex + 1) * size);
    this.#floats.set(accessor, floats);
    this.#lost.set(accessor, lost);
    return floats;
  }

  /** The vertices that have zeros because their numbers are not finite, or too large. To be asked after `floats`. */
  lost(index: number): ReadonlySet<number> {
    return this.#lost.get(this.at(index))!;
  }
}

/**
 * Only vertices from the lowest to the highest index are kept: primitives often share one large array. What of the data is no
 * number is left out or replaced, with a warning.
 *
 * @param path - of the primitive, for errors and warnings.
 * @returns `undefined` if there is not a single triangle.
 * @throws {LoadError} if an index is out of range.
 */
export function readTriangles(
  primitive: GltfPrimitive,
  data: VertexData,
  path: string,
  warnings: Warnings,
): Triangles | undefined {
  const { attributes } = primitive;
  if (attributes.POSITION === undefined) return undefined;
  const vertexCount = data.at(attributes.POSITION).getCount();
  const read = (semantic: string, size: number) =>
    data.floats(attributes[semantic]!, size, vertexCount, `${path}.attributes.${semantic}`);
  /** A vertex whose colour is no number is white. */
  const readColors = (accessor: number) => {
    const size = data.at(accessor).getElementSize();
    const given = read("COLOR_0", size === 3 ? 3 : 4);
    const lost = data.lost(accessor);
    const colors = new Float32Array(4 * vertexCount).fill(1);
    for (let vertex = 0; vertex < vertexCount; vertex++) {
      if (lost.has(vertex)) continue;
      for (let i = 0; i < size; i++) colors[4 * vertex + i] = Math.min(1, Math.max(0, given[size * vertex + i]!));
    }
    return colors;
  };
  const positions = read("POSITION", 3);
  const all = triangulate(indicesOf(primitive, data, vertexCount), primitive.mode);
  const [, highest] = rangeOf(all);
  if (highest >= vertexCount) throw new LoadError(`${path}.indices: vertex ${highest} is not one of ${vertexCount}`);
  const indices = withoutVertices(all, data.lost(attributes.POSITION));
  if (indices.length < all.length) {
    const count = `${(all.length - indices.length) / 3} of ${all.length / 3}`;
    warnings.add("Triangles with a corner at no finite place are left out", `${count} in ${path}`);
  }
  if (indices.length === 0) return undefined;

  const [first, last] = rangeOf(indices);
  if (first > 0) for (let i = 0; i < indices.length; i++) indices[i]! -= first;
  const slice = (values: Float32Array, size: number) => values.subarray(first * size, (last + 1) * size);
  const bare = attributes.NORMAL === undefined ? undefined : separateBareCorners(indices, slice(read("NORMAL", 3), 3));
  if (bare !== undefined && bare.vertexCount > 0) {
    const count = `${bare.vertexCount} of ${last - first + 1} in ${path}`;
    warnings.add("Normals that are zero or not finite give way to the normals of their triangles", count);
  }
  const cut = (values: Float32Array, size: number) => gather(slice(values, size), size, bare?.repeated);

  const uvs = new Map<number, Float32Array>();
  for (const [semantic, accessor] of Object.entries(attributes)) {
    const set = /^TEXCOORD_(\d+)$/.exec(semantic)?.[1];
    if (set === undefined) continue;
    uvs.set(Number(set), cut(read(semantic, 2), 2));
    const count = countWithin(data.lost(accessor), first, last);
    if (count === 0) continue;
    warnings.add(
      "Texture coordinates that are not finite are taken as 0",
      `${count} of ${last - first + 1} in ${path}`,
    );
  }
  const sizeOf = (semantic: string) => (semantic in attributes ? data.at(attributes[semantic]!).getElementSize() : 0);
  const colors = sizeOf("COLOR_0") >= 3 ? cut(readColors(attributes.COLOR_0!), 4) : undefined;
  const triangles = { positions: cut(positions, 3), indices, uvs, ...(colors && { colors }) };
  if (bare === undefined || bare.isEverywhere) return triangles;
  const normals = cut(read("NORMAL", 3), 3);
  if (bare.repeated.length > 0) fillFacetNormals(normals, last - first + 1, triangles);
  // glTF 2.0, 3.7.2.1: tangents have a meaning beside normals only. Those that are zero give way to the texture coordinates'.
  const tangents = sizeOf("TANGENT") === 4 ? cut(read("TANGENT", 4), 4) : undefined;
  return { ...triangles, normals, ...(tangents && { tangents }) };
}

/** How many of the numbers from first to last are in a set. */
function countWithin(numbers: ReadonlySet<number>, first: number, last: number): number {
  let count = 0;
  if (numbers.size > 0) for (let i = first; i <= last; i++) if (numbers.has(i)) count += 1;
  return count;
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
