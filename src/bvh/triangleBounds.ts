/**
 * Boxes of triangles, in the form `buildBvh` takes.
 *
 * @param positions - `[x, y, z]` per vertex.
 * @param indices - three vertices per triangle; without them, every three vertices in a row are one.
 * @returns `[minX, minY, minZ, maxX, maxY, maxZ]` per triangle. Of doubles the minima are rounded down and the maxima up, so
 *   that a box holds its triangle.
 * @throws {RangeError} if an index names no vertex, or numbers are left over.
 */
export function triangleBounds(
  positions: Float32Array | Float64Array,
  indices: Uint32Array = everyVertex(positions),
): Float32Array {
  if (positions.length % 3 !== 0) {
    throw new RangeError(`positions: expected 3 numbers per vertex, got ${positions.length} numbers`);
  }
  if (indices.length % 3 !== 0) {
    throw new RangeError(`indices: expected 3 per triangle, got ${indices.length}`);
  }
  const vertexCount = positions.length / 3;
  const bounds = new Float32Array(2 * indices.length);
  for (let i = 0, to = 0; i < indices.length; i += 3, to += 6) {
    const a = 3 * indices[i]!;
    const b = 3 * indices[i + 1]!;
    const c = 3 * indices[i + 2]!;
    if (Math.max(a, b, c) >= positions.length) {
      const at = [i, i + 1, i + 2].find((corner) => indices[corner]! >= vertexCount)!;
      throw new RangeError(`indices[${at}]: expected a vertex below ${vertexCount}, got ${indices[at]}`);
    }
    for (let axis = 0; axis < 3; axis++) {
      const x = positions[a + axis]!;
      const y = positions[b + axis]!;
      const z = positions[c + axis]!;
      bounds[to + axis] = Math.min(x, y, z);
      bounds[to + 3 + axis] = Math.max(x, y, z);
    }
  }
  if (positions instanceof Float64Array) widen(bounds, positions, indices);
  return bounds;
}

function everyVertex(positions: Float32Array | Float64Array): Uint32Array {
  return Uint32Array.from({ length: positions.length / 3 }, (_, vertex) => vertex);
}

/** Where rounding to f32 went inwards, takes the next f32 outwards. */
function widen(bounds: Float32Array, positions: Float64Array, indices: Uint32Array): void {
  for (let i = 0; i < indices.length; i++) {
    const to = 6 * Math.trunc(i / 3);
    for (let axis = 0; axis < 3; axis++) {
      const value = positions[3 * indices[i]! + axis]!;
      if (value < bounds[to + axis]!) bounds[to + axis] = nextDown(bounds[to + axis]!);
      if (value > bounds[to + 3 + axis]!) bounds[to + 3 + axis] = -nextDown(-bounds[to + 3 + axis]!);
    }
  }
}

const float = new Float32Array(1);
const bits = new Int32Array(float.buffer);

/** The largest f32 below `value`; NaN and −∞ stay. */
function nextDown(value: number): number {
  if (!(value > Number.NEGATIVE_INFINITY)) return value;
  float[0] = value === 0 ? 0 : value; // one zero, for below either lies the same number
  bits[0]! = value > 0 ? bits[0]! - 1 : value === 0 ? -0x7fffffff : bits[0]! + 1;
  return float[0]!;
}
