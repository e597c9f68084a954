/**
 * Encodes linear radiance as a Portable FloatMap: RGB, little endian, bottom row first, as the format wants it.
 *
 * @param radiance - RGBA, top row first, `4 · width · height` values.
 */
export function encodePfm(radiance: Float32Array, width: number, height: number): Uint8Array {
  const header = new TextEncoder().encode(`PF\n${width} ${height}\n-1.0\n`);
  const bytes = new Uint8Array(header.length + 12 * width * height);
  bytes.set(header);
  const view = new DataView(bytes.buffer, header.length);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const from = 4 * (y * width + x);
      const to = 12 * ((height - 1 - y) * width + x);
      for (let c = 0; c < 3; c++) view.setFloat32(to + 4 * c, radiance[from + c]!, true);
    }
  }
  return bytes;
}
