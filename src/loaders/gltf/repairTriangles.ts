// Triangles of which some numbers are missing, made whole. Vertices are renumbered here, in place where it is said.

/** Triangles that have none of some vertices. @returns `indices` itself if all are kept. */
export function withoutVertices(indices: Uint32Array, lost: ReadonlySet<number>): Uint32Array {
  if (lost.size === 0) return indices;
  const kept = new Uint32Array(indices.length);
  let length = 0;
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [indices[i]!, indices[i + 1]!, indices[i + 2]!];
    if (lost.has(a) || lost.has(b) || lost.has(c)) continue;
    kept.set([a, b, c], length);
    length += 3;
  }
  return kept.subarray(0, length);
}

/** Corners without a normal, which are now vertices of their own. */
export type BareCorners = {
  /** Vertices in use that have no normal. */
  readonly vertexCount: number;
  /** Whether no vertex in use has one. Then nothing is renumbered. */
  readonly isEverywhere: boolean;
  /** Of each new vertex, which follow those that were there, the one that it repeats. */
  readonly repeated: Uint32Array;
};

/**
 * Gives each corner whose vertex has no normal a vertex of its own, because the normal there is its triangle's.
 *
 * @param indices - changed in place.
 * @param normals - zero where there is none.
 */
export function separateBareCorners(indices: Uint32Array, normals: Float32Array): BareCorners {
  const vertexCount = normals.length / 3;
  const isBare = new Uint8Array(vertexCount);
  let hasBare = false;
  for (let i = 0; i < vertexCount; i++) {
    if (normals[3 * i] !== 0 || normals[3 * i + 1] !== 0 || normals[3 * i + 2] !== 0) continue;
    isBare[i] = 1;
    hasBare = true;
  }
  const none = { vertexCount: 0, isEverywhere: false, repeated: new Uint32Array() };
  if (!hasBare) return none;
  let bareCount = 0;
  let cornerCount = 0;
  const isSeen = new Uint8Array(vertexCount);
  for (const index of indices) {
    if (isBare[index] === 0) continue;
    cornerCount += 1;
    if (isSeen[index] === 0) bareCount += 1;
    isSeen[index] = 1;
  }
  if (cornerCount === indices.length) return { vertexCount: bareCount, isEverywhere: true, repeated: none.repeated };
  const repeated = new Uint32Array(cornerCount);
  let next = 0;
  for (let i = 0; i < indices.length; i++) {
    const index = indices[i]!;
    if (isBare[index] === 0) continue;
    repeated[next] = index;
    indices[i] = vertexCount + next++;
  }
  return { vertexCount: bareCount, isEverywhere: false, repeated };
}

/**
 * Numbers per vertex, with those of some vertices once more behind them.
 *
 * @returns `values` itself if none is repeated.
 */
export function gather(values: Float32Array, size: number, repeated: Uint32Array | undefined): Float32Array {
  if (repeated === undefined || repeated.length === 0) return values;
  const out = new Float32Array(values.length + size * repeated.length);
  out.set(values);
  let at = values.length;
  for (const vertex of repeated) {
    for (let i = 0; i < size; i++) out[at++] = values[vertex * size + i]!;
  }
  return out;
}

/**
 * Writes the unit normals of their triangles to some vertices, each of which is a corner of one triangle. Where that has no area
 * the normal stays zero.
 *
 * @param normals - changed in place.
 * @param first - the first of these vertices. All that follow are of them.
 */
export function fillFacetNormals(
  normals: Float32Array,
  first: number,
  { positions, indices }: { readonly positions: Float32Array; readonly indices: Uint32Array },
): void {
  for (let i = 0; i < indices.length; i += 3) {
    const corners = [indices[i]!, indices[i + 1]!, indices[i + 2]!] as const;
    if (corners.every((corner) => corner < first)) continue;
    const edge = (to: number, axis: number) => positions[3 * to + axis]! - positions[3 * corners[0] + axis]!;
    const [, b, c] = corners;
    const x = edge(b, 1) * edge(c, 2) - edge(b, 2) * edge(c, 1);
    const y = edge(b, 2) * edge(c, 0) - edge(b, 0) * edge(c, 2);
    const z = edge(b, 0) * edge(c, 1) - edge(b, 1) * edge(c, 0);
    const length = Math.hypot(x, y, z);
    if (length === 0) continue;
    for (const corner of corners) if (corner >= first) normals.set([x / length, y / length, z / length], 3 * corner);
  }
}
