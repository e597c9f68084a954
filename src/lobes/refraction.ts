import { alphaOf } from "./fresnel";
import type { Lobe } from "./lobe";
import { isSolid } from "./transmission";

/** Into a solid, or out of it, through an interface without microfacets. */
export const refraction = {
  feature: "REFRACTION",
  features: { REFRACTION: { isIn: (material) => isSolid(material) && alphaOf(material) === 0 } },
  columns: {},
  isBelow: true,
  share: "package::lobes::refraction::refractionShare(bsdf, wo)",
  delta: "package::lobes::refraction::refractionSample(bsdf, wo, share)",
} as const satisfies Lobe;
