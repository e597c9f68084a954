import { scale } from "../math/vec3";
import type { ResolvedMaterial } from "../scene/schema";
import type { Lobe } from "./lobe";

function isDiffuse(material: ResolvedMaterial): boolean {
  const { metallic, transmission, diffuseTransmission } = material;
  // A texture may make a metal less of one, and let less light through.
  return (
    (metallic < 1 || material.metallicRoughnessTexture !== undefined) &&
    (transmission < 1 || material.transmissionTexture !== undefined) &&
    (diffuseTransmission < 1 || material.diffuseTransmissionTexture !== undefined)
  );
}

/** Light that comes back from below the interface, or from a surface that has none. */
export const lambert = {
  feature: "DIFFUSE",
  features: {
    DIFFUSE: {
      word: "diffuse",
      isIn: isDiffuse,
    },
  },
  columns: {
    // (1 − metallic)·baseColor
    diffuse: {
      type: "vec3f",
      when: ({ DIFFUSE, TRANSMISSION }) => DIFFUSE! || TRANSMISSION!,
      of: ({ baseColor, metallic }) => scale(baseColor, 1 - metallic),
    },
  },
  share: "package::lobes::lambert::lambertShare(bsdf, wo)",
  value: "package::lobes::lambert::lambertValue(bsdf, at)",
  sample: "package::directions::cosineHemisphere(u)",
  alone: "package::lobes::lambert::lambertSample(bsdf, u)",
  isEven: true,
  expect: "package::lobes::lambert::lambertExpect(bsdf)",
} as const satisfies Lobe;
