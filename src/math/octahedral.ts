/** Stands for "no normal": the encoder has no −32768. */
export const NO_NORMAL = 0x80008000;

/**
 * Unit vectors as two snorm16 each on an octahedron folded flat, to within 7·10⁻⁵ rad (Cigolle et al. 2014, "A Survey of
 * Efficient Representations for Independent Unit Vectors", JCGT 3(2)). `octahedral` in `shapes/mesh.wgsl` reads them.
 *
 * @param vectors - x, y, z each, of any length; zero becomes `NO_NORMAL`.
 */
export function packDirections(vectors: Float32Array): Uint32Array {
  const packed = new Uint32Array(vectors.length / 3);
  for (let i = 0; i < packed.length; i++) {
    const [x, y, z] = [vectors[3 * i]!, vectors[3 * i + 1]!, vectors[3 * i + 2]!];
    const size = Math.abs(x) + Math.abs(y) + Math.abs(z);
    packed[i] = size > 0 && Number.isFinite(size) ? packDirection(x / size, y / size, z) : NO_NORMAL;
  }
  return packed;
}

/** @param x - and `y` on the octahedron |x| + |y| + |z| = 1; of `z` only the sign counts. */
function packDirection(x: number, y: number, z: number): number {
  const u = z >= 0 ? x : (1 - Math.abs(y)) * (x >= 0 ? 1 : -1);
  const v = z >= 0 ? y : (1 - Math.abs(x)) * (y >= 0 ? 1 : -1);
  return ((toSnorm(u) & 0xffff) | (toSnorm(v) << 16)) >>> 0;
}

function toSnorm(value: number): number {
  return Math.round(value * 32767);
}
