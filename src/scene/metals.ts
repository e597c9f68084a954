import { reflectanceToRgb } from "./colorimetry";
import { ALUMINIUM, CHROMIUM, COPPER, GOLD, IRON, type OpticalConstants, SILVER, TITANIUM } from "./opticalConstants";
import type { Rgb } from "./schema";

/**
 * `baseColor` of real metals, for `metallic: 1`: reflectance at normal incidence, linear Rec. 709, lit by D65. Computed
 * over the visible range from measured indices of refraction (see `opticalConstants.ts`).
 */
export const metals = {
  gold: /* @__PURE__ */ metalF0(GOLD),
  silver: /* @__PURE__ */ metalF0(SILVER),
  copper: /* @__PURE__ */ metalF0(COPPER),
  aluminium: /* @__PURE__ */ metalF0(ALUMINIUM),
  iron: /* @__PURE__ */ metalF0(IRON),
  titanium: /* @__PURE__ */ metalF0(TITANIUM),
  chromium: /* @__PURE__ */ metalF0(CHROMIUM),
} as const;

/** Reflectance at normal incidence, from air, of a conductor of complex index n + ik. */
export function conductorF0(n: number, k: number): number {
  return ((n - 1) ** 2 + k ** 2) / ((n + 1) ** 2 + k ** 2);
}

/** Reflectance at normal incidence, from air, of a dielectric of index `ior`. */
export function dielectricF0(ior: number): number {
  return conductorF0(ior, 0);
}

/** The colour of a metal whose table covers 390 to 780 nm; n and k are interpolated linearly between its rows. */
export function metalF0(constants: OpticalConstants): Rgb {
  return reflectanceToRgb((nm) => {
    const next = constants.findIndex(([rowNm]) => rowNm >= nm);
    const [nm0, n0, k0] = constants[next - 1]!;
    const [nm1, n1, k1] = constants[next]!;
    const t = (nm - nm0) / (nm1 - nm0);
    return conductorF0(n0 + t * (n1 - n0), k0 + t * (k1 - k0));
  });
}
