// Light that enters a dielectric and passes: through a thin wall, or into a solid. What the lobes of both have in common.

import type { ResolvedMaterial } from "../scene/schema";
import type { MaterialFeatures, MaterialPart } from "./lobe";

/** Lets light through. */
export function isTransmissive({ transmission, metallic, metallicRoughnessTexture }: ResolvedMaterial): boolean {
  return transmission > 0 && (metallic < 1 || metallicRoughnessTexture !== undefined);
}

/** Bounds a solid that light is refracted into. */
export function isSolid(material: ResolvedMaterial): boolean {
  return isTransmissive(material) && material.thickness > 0;
}

// Differences of the index of refraction per unit of `dispersion` and of ior − 1: a twentieth is 1/V, half of it to either side.
const SPREAD = 1 / 40;

const whenRefractive = ({ REFRACTIVE }: MaterialFeatures) => REFRACTIVE!;

export const transmission = {
  features: {
    TRANSMISSION: { word: "transmission", isIn: isTransmissive },
    REFRACTIVE: { isIn: isSolid },
    DISPERSION: {
      word: "dispersion",
      isIn: (material) => isSolid(material) && material.dispersion > 0 && material.ior !== 1,
    },
  },
  columns: {
    // Of the light that enters.
    transmission: {
      type: "f32",
      when: ({ TRANSMISSION }) => TRANSMISSION!,
      of: (material) => (isTransmissive(material) ? material.transmission : 0),
      texture: ["transmissionTexture", "r"],
    },
    // Index of refraction of a solid; 0 of other surfaces. Seen from a side: of what is below relative to what is above.
    eta: { type: "f32", when: whenRefractive, of: (material) => (isSolid(material) ? material.ior : 0) },
    // How much more it is for blue, and less for red. KHR_materials_dispersion
    spread: {
      type: "f32",
      when: ({ DISPERSION }) => DISPERSION!,
      of: (material) => (isSolid(material) ? (material.ior - 1) * SPREAD * material.dispersion : 0),
    },
  },
  derived: {
    eta: { type: "f32", when: whenRefractive, from: "package::surface::etaSeen(bsdf)" },
    transmitted: {
      type: "vec3f",
      when: ({ TRANSMISSION }) => TRANSMISSION!,
      from: "bsdf.diffuse * bsdf.transmission",
    },
    diffuse: {
      type: "vec3f",
      when: ({ TRANSMISSION }) => TRANSMISSION!,
      from: "bsdf.diffuse * (1.0 - bsdf.transmission)",
    },
    translucent: {
      type: "vec3f",
      when: ({ TRANSMISSION, TRANSLUCENT }) => TRANSMISSION! && TRANSLUCENT!,
      from: "bsdf.translucent * (1.0 - bsdf.transmission)",
    },
  },
} as const satisfies MaterialPart;
