import type { Rgb } from "./schema";

type Metal = "gold" | "silver" | "copper" | "aluminium" | "iron" | "titanium" | "chromium";

/**
 * `baseColor` of real metals, for `metallic: 1`: reflectance at normal incidence, linear Rec. 709, lit by D65. Computed over
 * the visible range from measured indices of refraction (see `tools/metals/opticalConstants.ts`), to six digits.
 */
export const metals: Readonly<Record<Metal, Rgb>> = {
  gold: [1, 0.774678, 0.30714],
  silver: [0.99075, 0.985001, 0.973761],
  copper: [0.92915, 0.623719, 0.522282],
  aluminium: [0.907514, 0.915783, 0.922338],
  iron: [0.529401, 0.513332, 0.494249],
  titanium: [0.618195, 0.579559, 0.542482],
  chromium: [0.549532, 0.556047, 0.554295],
};

/** Reflectance at normal incidence, from air, of a conductor of complex index n + ik. */
export function conductorF0(n: number, k: number): number {
  return ((n - 1) ** 2 + k ** 2) / ((n + 1) ** 2 + k ** 2);
}

/** Reflectance at normal incidence, from air, of a dielectric of index `ior`. */
export function dielectricF0(ior: number): number {
  return conductorF0(ior, 0);
}
