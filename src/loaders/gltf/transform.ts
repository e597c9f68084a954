// Vertices from the space of a mesh to the world's. A matrix is 16 doubles by columns.

/** Whether a matrix changes nothing. */
export function isIdentity(m: Float64Array): boolean {
  return m.every((value, i) => value === (i % 5 === 0 ? 1 : 0));
}

/** Whether a matrix mirrors: what ran counter-clockwise then runs clockwise. */
export function isMirror(m: Float64Array): boolean {
  const [a, b, c] = cofactors(m);
  return m[0]! * a! + m[1]! * b! + m[2]! * c! < 0;
}

/** Of the product of lengths: an area that is all rounding. */
const NO_AREA = 1e-12;

/** Whether a matrix makes a line or a point of everything, so that nothing has an area. */
export function hasNoArea(m: Float64Array): boolean {
  const squaredLength = (axis: number) => m[4 * axis]! ** 2 + m[4 * axis + 1]! ** 2 + m[4 * axis + 2]! ** 2;
  const longest = Math.max(squaredLength(0), squaredLength(1), squaredLength(2));
  return Math.hypot(...cofactors(m)) <= NO_AREA * longest;
}

/** The largest coordinate, of either sign. */
export function reachOf(positions: Float32Array | Float64Array): number {
  let reach = 0;
  for (let i = 0; i < positions.length; i++) reach = Math.max(reach, Math.abs(positions[i]!));
  return reach;
}

/** World positions, in doubles: far from the origin, floats would bend the shape. */
export function transformPositions(positions: Float32Array, m: Float64Array): Float64Array {
  const [m0, m1, m2, , m4, m5, m6, , m8, m9, m10, , m12, m13, m14] = m as unknown as number[];
  const out = new Float64Array(positions.length);
  for (let i = 0; i < out.length; i += 3) {
    const x = positions[i]!;
    const y = positions[i + 1]!;
    const z = positions[i + 2]!;
    out[i] = m0! * x + m4! * y + m8! * z + m12!;
    out[i + 1] = m1! * x + m5! * y + m9! * z + m13!;
    out[i + 2] = m2! * x + m6! * y + m10! * z + m14!;
  }
  return out;
}

/**
 * Normals by the cofactors, which are the inverse transpose times the determinant: where a matrix flattens, they still
 * point across the plane. Of a mirror they would point inwards, so then they are turned.
 *
 * @returns unit vectors; zero where a normal is zero.
 */
export function transformNormals(normals: Float32Array, m: Float64Array): Float32Array {
  const sign = isMirror(m) ? -1 : 1;
  const [c0, c1, c2, c3, c4, c5, c6, c7, c8] = cofactors(m);
  const out = new Float32Array(normals.length);
  for (let i = 0; i < out.length; i += 3) {
    const x = normals[i]!;
    const y = normals[i + 1]!;
    const z = normals[i + 2]!;
    const nx = c0! * x + c3! * y + c6! * z;
    const ny = c1! * x + c4! * y + c7! * z;
    const nz = c2! * x + c5! * y + c8! * z;
    const length = Math.sqrt(nx * nx + ny * ny + nz * nz);
    const scale = length > 0 ? sign / length : 0;
    out[i] = nx * scale;
    out[i + 1] = ny * scale;
    out[i + 2] = nz * scale;
  }
  return out;
}

/** Tangents with the surface. A mirror turns the fourth number: which way the bitangent lies. */
export function transformTangents(tangents: Float32Array, m: Float64Array): Float32Array {
  const sign = isMirror(m) ? -1 : 1;
  const [m0, m1, m2, , m4, m5, m6, , m8, m9, m10] = m as unknown as number[];
  const out = new Float32Array(tangents.length);
  for (let i = 0; i < out.length; i += 4) {
    const x = tangents[i]!;
    const y = tangents[i + 1]!;
    const z = tangents[i + 2]!;
    const tx = m0! * x + m4! * y + m8! * z;
    const ty = m1! * x + m5! * y + m9! * z;
    const tz = m2! * x + m6! * y + m10! * z;
    const length = Math.sqrt(tx * tx + ty * ty + tz * tz);
    const scale = length > 0 ? 1 / length : 0;
    out[i] = tx * scale;
    out[i + 1] = ty * scale;
    out[i + 2] = tz * scale;
    out[i + 3] = length > 0 ? sign * Math.sign(tangents[i + 3]!) : 0;
  }
  return out;
}

/** The triangles seen from their other side. */
export function flipWinding(indices: Uint32Array): Uint32Array {
  const out = indices.slice();
  for (let i = 0; i < out.length; i += 3) {
    out[i + 1] = indices[i + 2]!;
    out[i + 2] = indices[i + 1]!;
  }
  return out;
}

/** Of the upper left 3 × 3, by columns. */
function cofactors(m: Float64Array): readonly number[] {
  const [a, b, c, , d, e, f, , g, h, i] = m as unknown as number[];
  return [
    e! * i! - f! * h!,
    f! * g! - d! * i!,
    d! * h! - e! * g!,
    h! * c! - i! * b!,
    i! * a! - g! * c!,
    g! * b! - h! * a!,
    b! * f! - c! * e!,
    c! * d! - a! * f!,
    a! * e! - b! * d!,
  ];
}
