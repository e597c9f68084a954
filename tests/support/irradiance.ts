// Irradiance at the origin of a surface with normal +y, in doubles: what a lit plane must show.
//
// [1] Lambert 1760, "Photometria": the irradiance of a polygon
import type { Vec3 } from "../../src/scene/schema";

type Point = readonly [number, number, number];

/**
 * Irradiance at `p`, normal +y, from a polygon of radiance 1 that emits to the side from which its vertices run
 * counter-clockwise. The part below the horizon is cut off. [1]
 */
export function polygonIrradiance(p: Vec3, vertices: readonly Vec3[]): number {
  const polygon = aboveHorizon(vertices.map((v) => [v[0] - p[0], v[1] - p[1], v[2] - p[2]] as const));
  let sum = 0;
  for (const [i, a] of polygon.entries()) {
    const b = polygon[(i + 1) % polygon.length]!;
    const normal = cross(a, b);
    const sine = Math.hypot(...normal);
    if (sine === 0) continue;
    sum += (Math.atan2(sine, dot(a, b)) * normal[1]) / sine;
  }
  // Seen from p, the vertices of a polygon that faces it run clockwise around +y.
  return Math.max(-sum / 2, 0);
}

/** Sutherland–Hodgman against the plane y = 0. */
function aboveHorizon(polygon: readonly Point[]): Point[] {
  return polygon.flatMap((a, i) => {
    const b = polygon[(i + 1) % polygon.length]!;
    const kept = a[1] > 0 ? [a] : [];
    if (a[1] > 0 === b[1] > 0) return kept;
    const t = a[1] / (a[1] - b[1]);
    return [...kept, [a[0] + t * (b[0] - a[0]), 0, a[2] + t * (b[2] - a[2])] as const];
  });
}

/**
 * Irradiance at `p`, normal +y, from a sphere of radiance 1: the midpoint rule in polar coordinates around the direction to
 * its centre, 1000² directions, relative error < 1e-5 (the integrand is smooth but for a kink at the horizon).
 */
export function sphereIrradiance(p: Vec3, center: Vec3, radius: number): number {
  const toCenter = [center[0] - p[0], center[1] - p[1], center[2] - p[2]] as const;
  const d = Math.hypot(...toCenter);
  const cosCenter = toCenter[1] / d;
  const sinCenter = Math.sqrt(Math.max(1 - cosCenter ** 2, 0));
  const sin2Max = (radius / d) ** 2;
  const steps = 1000;
  let sum = 0;
  // In sin² of the cone's angle, the cosine-weighted measure around its axis is uniform: cos·dω = d(sin²)·dφ / 2.
  for (let i = 0; i < steps; i++) {
    const sin2 = (sin2Max * (i + 0.5)) / steps;
    const [sin, cos] = [Math.sqrt(sin2), Math.sqrt(1 - sin2)];
    for (let j = 0; j < steps; j++) {
      const phi = (2 * Math.PI * (j + 0.5)) / steps;
      const y = cos * cosCenter + sin * Math.cos(phi) * sinCenter;
      sum += Math.max(y, 0) / cos;
    }
  }
  return (sum * sin2Max * Math.PI) / steps ** 2;
}

function dot(a: Point, b: Point): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

function cross(a: Point, b: Point): Point {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}
