import type { ResolvedMaterial } from "../scene/schema";
import { isMirrorAlpha } from "./fresnel";
import type { Layer, Lobe, MaterialFeatures } from "./lobe";

// Its square is the least α.
const LEAST_ROUGHNESS = 2 ** -12;

/** Has a coat. */
export function hasCoat({ clearcoat }: ResolvedMaterial): boolean {
  return clearcoat > 0;
}

function isRoughCoat(material: ResolvedMaterial): boolean {
  return hasCoat(material) && !isMirrorAlpha(material.clearcoatRoughness ** 2);
}

const when = ({ COAT }: MaterialFeatures) => COAT!;

const COAT: Layer = {
  feature: "COAT",
  through: "package::lobes::clearcoat::coatThrough(bsdf, wo, wi)",
  out: "package::lobes::clearcoat::coatOut(bsdf, wo)",
};

/** A clear coat of microfacets on top of all else. KHR_materials_clearcoat */
export const clearcoat = {
  feature: "ROUGH_COAT",
  features: {
    COAT: { word: "clear coat", isIn: hasCoat },
    ROUGH_COAT: { isIn: isRoughCoat },
    // It has another normal than what lies below it.
    COAT_NORMAL: {
      isIn: (m) => hasCoat(m) && (m.normalTexture !== undefined || m.clearcoatNormalTexture !== undefined),
    },
    COAT_NORMAL_TEXTURE: { isIn: (m) => hasCoat(m) && m.clearcoatNormalTexture !== undefined },
  },
  columns: {
    clearcoat: { type: "f32", when, of: ({ clearcoat }) => clearcoat, texture: ["clearcoatTexture", "r"] },
    // 0 is a perfect mirror.
    coatRoughness: {
      type: "f32",
      when,
      of: (material) => (isRoughCoat(material) ? material.clearcoatRoughness : 0),
      texture: ["clearcoatRoughnessTexture", "g", LEAST_ROUGHNESS],
    },
    coatNormalScale: {
      type: "f32",
      when: ({ COAT_NORMAL_TEXTURE }) => COAT_NORMAL_TEXTURE!,
      of: ({ clearcoatNormalScale }) => clearcoatNormalScale,
    },
  },
  derived: {
    coatAlpha: { type: "f32", when, from: "bsdf.coatRoughness * bsdf.coatRoughness" },
    // In the local frame.
    coatNormal: { type: "vec3f", when: ({ COAT_NORMAL }) => COAT_NORMAL!, from: "package::surface::coatNormal" },
  },
  layer: COAT,
  share: "package::lobes::clearcoat::coatShare(bsdf, wo)",
  value: "package::lobes::clearcoat::coatValue(bsdf, at)",
  sample: "package::lobes::clearcoat::coatDirection(bsdf, wo, u)",
  expect: "package::lobes::clearcoat::coatExpect(bsdf, wo, wi, cosI, size)",
} as const satisfies Lobe;

/** The same without microfacets. */
export const mirrorCoat = {
  feature: "MIRROR_COAT",
  features: { MIRROR_COAT: { isIn: (material) => hasCoat(material) && !isRoughCoat(material) } },
  columns: {},
  layer: COAT,
  share: "package::lobes::clearcoat::mirrorCoatShare(bsdf, wo)",
  delta: "package::lobes::clearcoat::mirrorCoatSample(bsdf, wo, share)",
} as const satisfies Lobe;
