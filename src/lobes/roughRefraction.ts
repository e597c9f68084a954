import { alphaOf } from "./fresnel";
import type { Lobe } from "./lobe";
import { isSolid } from "./transmission";

/**
 * Into a solid, or out of it, through microfacets. It draws what they reflect too, whose value is that of `ggx`: a microfacet has to be
 * there before it is known how much it reflects.
 */
export const roughRefraction = {
  feature: "ROUGH_REFRACTION",
  features: { ROUGH_REFRACTION: { word: "rough refraction", isIn: (m) => isSolid(m) && alphaOf(m) > 0 } },
  columns: {},
  isBelow: "some",
  share: "package::lobes::roughRefraction::roughRefractionShare(bsdf, wo)",
  value: "package::lobes::roughRefraction::roughRefractionValue(bsdf, at)",
  sample: "package::lobes::roughRefraction::roughRefractionDirection(bsdf, wo, u, rest)",
  expect: "package::lobes::roughRefraction::roughRefractionExpect(bsdf, wo, wi, cosI, size)",
} as const satisfies Lobe;
