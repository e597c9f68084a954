import type { ResolvedMaterial, Vec3 } from "../scene/schema";
import type { MaterialFeatures, MaterialPart } from "./lobe";

function isAnisotropic({ anisotropy }: ResolvedMaterial): boolean {
  return anisotropy > 0;
}

/** Microfacets that stretch reflections in one direction, as grooves do across them. KHR_materials_anisotropy */
export const anisotropy = {
  features: {
    ANISOTROPY: { word: "anisotropy", isIn: isAnisotropic },
    STRETCH_TEXTURES: { isIn: (material) => isAnisotropic(material) && material.anisotropyTexture !== undefined },
  },
  columns: {
    anisotropy: {
      type: "f32",
      when: ({ ANISOTROPY }: MaterialFeatures) => ANISOTROPY!,
      of: ({ anisotropy }) => anisotropy,
      texture: ["anisotropyTexture", "b"],
    },
  },
  derived: {
    // α in that direction; `alpha` is that across it.
    alphaAlong: {
      type: "f32",
      when: ({ ANISOTROPY }: MaterialFeatures) => ANISOTROPY!,
      from: "mix(bsdf.alpha, select(0.0, 1.0, bsdf.alpha > 0.0), bsdf.anisotropy * bsdf.anisotropy)",
    },
  },
} as const satisfies MaterialPart;

/** That direction, from the tangent: in the table of materials only. */
export const stretch = {
  features: {},
  columns: {
    stretch: {
      type: "vec3f",
      when: ({ ANISOTROPY }: MaterialFeatures) => ANISOTROPY!,
      of: ({ anisotropyRotation }): Vec3 => {
        const angle = (anisotropyRotation * Math.PI) / 180;
        return [Math.cos(angle), Math.sin(angle), 0];
      },
    },
  },
} as const satisfies MaterialPart;
