// Equal treatment of narrow and wide densities: directions, binned in polar coordinates around an axis, finer towards it.
import type { Vec3 } from "../../src/scene/schema";

/** Polar coordinates: the logarithm of 1 − cos θ, which spreads peaks of width `scale` and tails alike, and φ. */
export type Polar = {
  /** Unit. */
  readonly axis: Vec3;
  /** 1 − cos θ where the bins stop to be even and start to grow. */
  readonly scale: number;
  /** Largest 1 − cos θ: 1 for a hemisphere, 2 for all directions. */
  readonly most: number;
};

const RINGS = 24;
const SECTORS = 16;
/** Directions per bin and dimension with which a density is integrated over a bin, by the midpoint rule. */
const STEPS = 12;

export const BIN_COUNT = RINGS * SECTORS;

/** The bin of a direction that need not be exactly unit; undefined beyond `most`. */
export function binOf({ axis, scale, most }: Polar, direction: Vec3): number | undefined {
  const length = Math.hypot(...direction);
  const [t, b] = tangents(axis);
  // |w − a|²/2 = 1 − cos θ without its cancellation.
  const away = Math.hypot(...direction.map((component, i) => component / length - axis[i]!)) ** 2 / 2;
  const ring = Math.floor((RINGS * Math.log1p(away / scale)) / Math.log1p(most / scale));
  const turns = Math.atan2(dot(direction, b), dot(direction, t)) / (2 * Math.PI);
  const sector = Math.min(Math.floor(SECTORS * (turns < 0 ? turns + 1 : turns)), SECTORS - 1);
  return ring < RINGS ? ring * SECTORS + sector : undefined;
}

/** Directions with the solid angle that each stands for; the first `steps`² lie in bin 0, and so on. */
export function binDirections(
  { axis, scale, most }: Polar,
  steps = STEPS,
): { direction: Vec3; solidAngle: number; bin: number }[] {
  const [t, b] = tangents(axis);
  const range = Math.log1p(most / scale);
  return Array.from({ length: BIN_COUNT * steps ** 2 }, (_, n) => {
    const bin = Math.floor(n / steps ** 2);
    const [i, j] = [Math.floor((n % steps ** 2) / steps), n % steps];
    const x = (Math.floor(bin / SECTORS) + (i + 0.5) / steps) / RINGS;
    const phi = (2 * Math.PI * ((bin % SECTORS) + (j + 0.5) / steps)) / SECTORS;
    const away = scale * Math.expm1(x * range);
    const radius = Math.sqrt(away * (2 - away));
    const [u, v] = [radius * Math.cos(phi), radius * Math.sin(phi)];
    const direction = axis.map((a, k) => (1 - away) * a + u * t[k]! + v * b[k]!) as unknown as Vec3;
    const perX = (away + scale) * range;
    return { direction, bin, solidAngle: (2 * Math.PI * perX) / (BIN_COUNT * steps ** 2) };
  });
}

/** Two unit vectors orthogonal to `axis` and to each other. */
function tangents(axis: Vec3): [Vec3, Vec3] {
  const other: Vec3 = Math.abs(axis[0]) < 0.6 ? [1, 0, 0] : [0, 1, 0];
  const t = normalize(cross(other, axis));
  return [t, cross(axis, t)];
}

export function normalize(a: Vec3): Vec3 {
  const length = Math.hypot(...a);
  return [a[0] / length, a[1] / length, a[2] / length];
}

export function cross(a: Vec3, b: Vec3): Vec3 {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

export function dot(a: Vec3, b: Vec3): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
