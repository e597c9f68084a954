type Vec3 = readonly [number, number, number];

const [WINDINGS_P, WINDINGS_Q] = [2, 3];
const [ALONG, AROUND] = [750, 40]; // 60,000 triangles

/** A tube along the (2, 3) torus knot, which fills a ball of about three radii: positions, normals and triangles. */
export function torusKnot({ center, radius, tube }: { center: Vec3; radius: number; tube: number }) {
  const positions = new Float32Array(3 * ALONG * AROUND);
  const normals = new Float32Array(3 * ALONG * AROUND);
  const indices = new Uint32Array(6 * ALONG * AROUND);
  for (let i = 0; i < ALONG; i++) {
    const t = (2 * Math.PI * i) / ALONG;
    const [here, next] = [curve(t), curve(t + 1e-3)];
    const forward = unit(subtract(next, here));
    // Two directions across the tube.
    const side = unit(cross(forward, add(here, next)));
    const up = cross(side, forward);
    for (let j = 0; j < AROUND; j++) {
      const a = (2 * Math.PI * j) / AROUND;
      const normal = add(scale(side, Math.cos(a)), scale(up, Math.sin(a)));
      const vertex = i * AROUND + j;
      normals.set(normal, 3 * vertex);
      positions.set(add(center, add(scale(here, radius), scale(normal, tube))), 3 * vertex);
      const [ahead, beside] = [((i + 1) % ALONG) * AROUND, (j + 1) % AROUND];
      const corners = [vertex, i * AROUND + beside, ahead + j, ahead + j, i * AROUND + beside, ahead + beside];
      indices.set(corners, 6 * vertex);
    }
  }
  return { positions, normals, indices };
}

function curve(t: number): Vec3 {
  const r = 1 + 0.5 * Math.cos(WINDINGS_Q * t);
  return [r * Math.cos(WINDINGS_P * t), r * Math.sin(WINDINGS_P * t), 0.75 * Math.sin(WINDINGS_Q * t)];
}

const add = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const subtract = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const scale = (a: Vec3, factor: number): Vec3 => [a[0] * factor, a[1] * factor, a[2] * factor];
const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
const unit = (a: Vec3): Vec3 => scale(a, 1 / Math.hypot(...a));
