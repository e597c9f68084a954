import { isRough } from "./fresnel";
import type { Lobe } from "./lobe";

/** An interface of microfacets. */
export const ggx = {
  feature: "ROUGH",
  features: {
    ROUGH: { word: "GGX", isIn: isRough },
    SMITH: { word: "Smith masking", isIn: (material) => isRough(material) && material.masking === "smith" },
    SCHLICK_BECKMANN: {
      word: "Schlick–Beckmann masking",
      isIn: (material) => isRough(material) && material.masking === "schlick-beckmann",
    },
    MULTISCATTER: {
      word: "multiple scattering",
      isIn: (material) => isRough(material) && material.multiscatter && material.metallic > 0,
    },
  },
  columns: {
    // 1 for the masking "schlick-beckmann", else 0.
    schlickBeckmann: {
      type: "f32",
      when: ({ SMITH, SCHLICK_BECKMANN }) => SMITH! && SCHLICK_BECKMANN!,
      of: (material) => (isRough(material) && material.masking === "schlick-beckmann" ? 1 : 0),
    },
    // Share of the light lost to multiple scattering that is given back: `metallic`, or 0 without the flag.
    multiscatter: {
      type: "f32",
      when: ({ MULTISCATTER }) => MULTISCATTER!,
      of: ({ multiscatter, metallic }) => (multiscatter ? metallic : 0),
    },
  },
  derived: {
    // What gives the lobe back the light of multiple scattering.
    gain: {
      type: "vec3f",
      when: ({ MULTISCATTER }) => MULTISCATTER!,
      from: "package::lobes::multiscatter::multiscatterGain(wo.z, bsdf.alpha, bsdf.F0 * bsdf.multiscatter)",
    },
  },
  share: "package::lobes::ggx::ggxShare(bsdf, wo)",
  value: "package::lobes::ggx::ggxValue(bsdf, at)",
  sample: "package::lobes::ggx::ggxDirection(bsdf, wo, u)",
  expect: "package::lobes::ggx::ggxExpect(bsdf, wo, wi, cosI, size)",
} as const satisfies Lobe;
