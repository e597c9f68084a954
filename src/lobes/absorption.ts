import type { ResolvedMaterial, Vec3 } from "../scene/schema";
import type { MaterialFeatures, MaterialPart } from "./lobe";

// Per metre: nothing passes. Times any distance it is finite.
const MAX_SIGMA = 1e18;

/** Bounds a solid that light gets into. */
function isVolume({ thickness, transmission, diffuseTransmission }: ResolvedMaterial): boolean {
  return thickness > 0 && (transmission > 0 || diffuseTransmission > 0);
}

function absorbs(material: ResolvedMaterial): boolean {
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
