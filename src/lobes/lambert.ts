import { scale } from "../math/vec3";
import type { Lobe } from "./lobe";

/** Light that comes back from below the interface, or from a surface that has none. */
export const lambert = {
  feature: "DIFFUSE",
  features: {
    DIFFUSE: {
      word: "diffuse",
      // A texture may make a metal less of one.
      isIn: ({ metallic, metallicRoughnessTexture }) => metallic < 1 || metallicRoughnessTexture !== undefined,
    },
  },
  columns: {
    // (1 − metallic)·baseColor
    diffuse: {
      type: "vec3f",
      when: ({ DIFFUSE }) => DIFFUSE!,
      of: ({ baseColor, metallic }) => scale(baseColor, 1 - metallic),
    },
  },
  share: "package::lobes::lambert::lambertShare(bsdf, wo)",
  value: "package::lobes::lambert::lambertValue(bsdf, at)",
  sample: "package::directions::cosineHemisphere(u)",
  alone: "package::lobes::lambert::lambertSample(bsdf, u)",
  isEven: true,
  expect: "package::lobes::lambert::lambertExpect(bsdf)",
} as const satisfies Lobe;
