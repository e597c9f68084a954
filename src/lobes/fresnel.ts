// What reflects at all, and how much: shared by the lobes of an interface.

import { add, scale } from "../math/vec3";
import { dielectricF0 } from "../scene/metals";
import type { ResolvedMaterial } from "../scene/schema";
import type { MaterialFeatures, MaterialPart } from "./lobe";

// Microfacets tilted by less than f32 rounds a direction; with a smaller α the square of their density overflows.
const LEAST_ALPHA = 2 ** -24;

/** A dielectric of ior 1 has no interface: it is Lambert only. */
function hasInterface({ metallic, ior }: ResolvedMaterial): boolean {
  return metallic > 0 || ior > 1;
}

/** Width of the microfacets' distribution; 0 is a perfect mirror. */
function alphaOf({ roughness }: ResolvedMaterial): number {
  const alpha = roughness ** 2;
  return alpha < LEAST_ALPHA ? 0 : alpha;
}

/** Has an interface of microfacets. */
export function isRough(material: ResolvedMaterial): boolean {
  return hasInterface(material) && alphaOf(material) > 0;
}

/** Has an interface without microfacets. */
export function isMirror(material: ResolvedMaterial): boolean {
  return hasInterface(material) && alphaOf(material) === 0;
}

const when = ({ SPECULAR }: MaterialFeatures) => SPECULAR!;

export const fresnel = {
  features: { SPECULAR: { isIn: hasInterface } },
  columns: {
    // Reflectance at normal incidence.
    F0: {
      type: "vec3f",
      when,
      of: (material) => {
        const { baseColor, metallic } = material;
        const f0 = f0Of(material);
        return add(scale([f0, f0, f0], 1 - metallic), scale(baseColor, metallic));
      },
    },
    // The same of the dielectric part alone.
    f0: { type: "f32", when, of: f0Of },
    // Reflectance at grazing incidence: 1, or 0 for a surface that is Lambert only.
    f90: { type: "f32", when, of: (material) => (hasInterface(material) ? 1 : 0) },
    // roughness²; 0 is a perfect mirror.
    alpha: { type: "f32", when, of: (material) => (hasInterface(material) ? alphaOf(material) : 1) },
  },
} as const satisfies MaterialPart;

function f0Of(material: ResolvedMaterial): number {
  return hasInterface(material) ? dielectricF0(material.ior) : 0;
}
