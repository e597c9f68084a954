import type { Rgb } from "./schema";

type Spot = {
  readonly power?: Rgb | undefined;
  readonly intensity?: Rgb | undefined;
  readonly innerAngle?: number | undefined;
  readonly outerAngle?: number | undefined;
};

/** How a spot shines, by 1 − cos of the angle from its axis, which keeps the digits of narrow cones. */
export type SpotCone = {
  /** Within the inner cone, W·sr⁻¹. */
  readonly intensity: Rgb;
  /** 1 − cos of the outer angle. */
  readonly outer: number;
  /** One over the difference of the cosines of the two angles. */
  readonly sharpness: number;
};

/**
 * The falloff is that of KHR_lights_punctual: between the cones intensity goes as x², where x rises from 0 to 1 in proportion to the
 * cosine. So power is intensity · 2π·((1 − cos inner) + (cos inner − cos outer)/3).
 */
export function spotCone({ power, intensity, innerAngle = 0, outerAngle = 45 }: Spot): SpotCone {
  const [inner, outer] = [oneMinusCos(innerAngle), oneMinusCos(outerAngle)];
  const solidAngle = 2 * Math.PI * (inner + (outer - inner) / 3);
  const [r, g, b] = intensity ?? power!;
  const share = intensity ? 1 : 1 / solidAngle;
  return {
    intensity: [r * share, g * share, b * share],
    outer,
    sharpness: 1 / Math.max(outer - inner, LEAST_DIFFERENCE),
  };
}

/** How much of its intensity a spot sends in a direction. */
export function spotFalloff({ outer, sharpness }: SpotCone, cosine: number): number {
  return Math.min(Math.max((outer - (1 - cosine)) * sharpness, 0), 1) ** 2;
}

// Of cosines that a direction in f32 can tell apart, about.
const LEAST_DIFFERENCE = 1e-12;

function oneMinusCos(degrees: number): number {
  return 2 * Math.sin((degrees * Math.PI) / 360) ** 2;
}
