// What reflects at all, and how much: shared by the lobes of an interface.

import { add, scale } from "../math/vec3";
import { dielectricF0 } from "../scene/metals";
import type { ResolvedMaterial, Vec3 } from "../scene/schema";
import type { MaterialFeatures, MaterialPart } from "./lobe";
import { isSolid, isTransmissive } from "./transmission";

// Microfacets tilted by less than f32 rounds a direction; with a smaller α the square of their density overflows.
const LEAST_ALPHA = 2 ** -24;

// A solid that differs by less from what is around it bends light too little for its microfacets to show, and for f32 to tell which of
// them did.
const LEAST_BEND = 1e-3;

/** A dielectric of ior 1 or of strength 0 has no interface: it is Lambert only. */
export function hasInterface({ metallic, ior, specular }: ResolvedMaterial): boolean {
  return metallic > 0 || (ior !== 1 && specular > 0);
}

/** Whether microfacets of this α are a perfect mirror. */
export function isMirrorAlpha(alpha: number): boolean {
  return alpha < LEAST_ALPHA;
}

/** Width of the microfacets' distribution; 0 is a perfect mirror. */
export function alphaOf(material: ResolvedMaterial): number {
  const alpha = material.roughness ** 2;
  const isClear = isSolid(material) && Math.abs(material.ior - 1) < LEAST_BEND;
  return isMirrorAlpha(alpha) || isClear ? 0 : alpha;
}

/** Has an interface of microfacets. */
export function isRough(material: ResolvedMaterial): boolean {
  return hasInterface(material) && alphaOf(material) > 0;
}

/** Has an interface without microfacets. */
export function isMirror(material: ResolvedMaterial): boolean {
  return hasInterface(material) && alphaOf(material) === 0;
}

/** Whether a dielectric's reflection is not what its ior alone tells. */
function isTinted({ specular, specularColor, specularTexture, specularColorTexture }: ResolvedMaterial): boolean {
  if (specularTexture !== undefined || specularColorTexture !== undefined) return true;
  return specular < 1 || specularColor.some((channel) => channel !== 1);
}

const when = ({ SPECULAR }: MaterialFeatures) => SPECULAR!;
const whenTinted = ({ TINTED }: MaterialFeatures) => TINTED!;

export const fresnel = {
  features: {
    SPECULAR: { isIn: (material) => hasInterface(material) || isTransmissive(material) },
    TINTED: { word: "tinted reflection", isIn: (material) => hasInterface(material) && isTinted(material) },
  },
  columns: {
    // Reflectance at normal incidence.
    F0: {
      type: "vec3f",
      when,
      of: (material) => {
        const { baseColor, metallic } = material;
        return add(scale(dielectricF0Of(material), 1 - metallic), scale(baseColor, metallic));
      },
    },
    // The greatest channel of that of the dielectric part alone.
    f0: { type: "f32", when, of: (material) => Math.max(...dielectricF0Of(material)) },
    // Reflectance at grazing incidence: 1, or 0 for a surface that is Lambert only.
    f90: {
      type: "f32",
      when,
      of: (material) => (hasInterface(material) ? material.specular * (1 - material.metallic) + material.metallic : 0),
    },
    // The same of the dielectric part alone.
    dielectricF90: {
      type: "f32",
      when: whenTinted,
      of: (material) => (hasInterface(material) ? material.specular : 0),
      texture: ["specularTexture", "a"],
    },
    // What `specular` multiplies of the dielectric's reflectance at normal incidence, before it is cut at 1.
    specularF0: {
      type: "vec3f",
      when: whenTinted,
      of: (material) => scale(material.specularColor, hasInterface(material) ? dielectricF0(material.ior) : 0),
      texture: ["specularColorTexture", "color"],
    },
    // roughness²; 0 is a perfect mirror.
    alpha: {
      type: "f32",
      when,
      of: (material) => (hasInterface(material) || isTransmissive(material) ? alphaOf(material) : 1),
    },
  },
} as const satisfies MaterialPart;

/** Of light at normal incidence. KHR_materials_specular */
function dielectricF0Of(material: ResolvedMaterial): Vec3 {
  const { ior, specular, specularColor } = material;
  if (!hasInterface(material)) return [0, 0, 0];
  const f0 = dielectricF0(ior);
  return scale(specularColor.map((channel) => Math.min(channel * f0, 1)) as unknown as Vec3, specular);
}
