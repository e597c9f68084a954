import { scale } from "../math/vec3";
import type { ResolvedMaterial } from "../scene/schema";
import type { Lobe } from "./lobe";

/** Light that leaves the other side in all directions: paper, leaves, lampshades. */
export function isTranslucent({ diffuseTransmission, metallic, metallicRoughnessTexture }: ResolvedMaterial): boolean {
  return diffuseTransmission > 0 && (metallic < 1 || metallicRoughnessTexture !== undefined);
}

/** Lambert's law on the other side. KHR_materials_diffuse_transmission */
export const diffuseTransmission = {
  feature: "TRANSLUCENT",
  features: { TRANSLUCENT: { word: "diffuse transmission", isIn: isTranslucent } },
  columns: {
    // Of what is scattered below the interface.
    translucency: {
      type: "f32",
      when: ({ TRANSLUCENT }) => TRANSLUCENT!,
      of: ({ diffuseTransmission }) => diffuseTransmission,
      texture: ["diffuseTransmissionTexture", "a"],
    },
    // (1 − metallic)·diffuseTransmissionColor
    translucent: {
      type: "vec3f",
      when: ({ TRANSLUCENT }) => TRANSLUCENT!,
      of: ({ diffuseTransmissionColor, metallic }) => scale(diffuseTransmissionColor, 1 - metallic),
      texture: ["diffuseTransmissionColorTexture", "color"],
    },
  },
  derived: {
    translucent: {
      type: "vec3f",
      when: ({ TRANSLUCENT }) => TRANSLUCENT!,
      from: "bsdf.translucent * bsdf.translucency",
    },
    diffuse: {
      type: "vec3f",
      when: ({ TRANSLUCENT, DIFFUSE }) => TRANSLUCENT! && DIFFUSE!,
      from: "bsdf.diffuse * (1.0 - bsdf.translucency)",
    },
  },
  isBelow: true,
  share: "package::lobes::diffuseTransmission::translucentShare(bsdf, wo)",
  value: "package::lobes::diffuseTransmission::translucentValue(bsdf, at)",
  sample: "package::lobes::diffuseTransmission::translucentDirection(u)",
  expect: "package::lobes::diffuseTransmission::translucentExpect(bsdf)",
} as const satisfies Lobe;
