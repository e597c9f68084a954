import type { ResolvedMaterial, Vec3 } from "../scene/schema";
import { isTranslucent } from "./diffuseTransmission";
import type { MaterialFeatures, MaterialPart } from "./lobe";
import { isTransmissive } from "./transmission";

// Per metre: nothing passes. Times any distance it is finite.
const MAX_SIGMA = 1e18;

/** Bounds a solid that light gets into. */
export function isVolume(material: ResolvedMaterial): boolean {
  return material.thickness > 0 && (isTransmissive(material) || isTranslucent(material));
}

/** Bounds one in which light gets lost. */
export function absorbs(material: ResolvedMaterial): boolean {
  const { attenuationDistance, attenuationColor } = material;
  return isVolume(material) && attenuationDistance !== undefined && attenuationColor.some((channel) => channel < 1);
}

/** What light loses on its way in a solid, by the law of Beer and Lambert. KHR_materials_volume */
export const absorption = {
  features: { ABSORPTION: { word: "absorption", isIn: absorbs } },
  columns: {
    // Absorption coefficient, per unit of length.
    sigma: {
      type: "vec3f",
      when: ({ ABSORPTION }: MaterialFeatures) => ABSORPTION!,
      of: (material) => {
        const { attenuationColor, attenuationDistance = 1 } = material;
        if (!absorbs(material)) return [0, 0, 0];
        return attenuationColor.map((channel) =>
          Math.min(-Math.log(channel) / attenuationDistance, MAX_SIGMA),
        ) as unknown as Vec3;
      },
    },
    // Whether light is in something else beyond the surface.
    isVolume: {
      type: "f32",
      when: ({ ABSORPTION }: MaterialFeatures) => ABSORPTION!,
      of: (material) => (isVolume(material) ? 1 : 0),
    },
  },
} as const satisfies MaterialPart;
