import type { ResolvedMaterial } from "../scene/schema";
import type { Layer, Lobe, MaterialFeatures } from "./lobe";

// Fibres more upright than these shine at grazing angles only, too narrowly for a table of what they reflect.
const LEAST_ROUGHNESS = 0.07;

function hasSheen({ sheenColor }: ResolvedMaterial): boolean {
  return sheenColor.some((channel) => channel > 0);
}

const when = ({ SHEEN }: MaterialFeatures) => SHEEN!;

const FIBRES: Layer = {
  feature: "SHEEN",
  through: "package::lobes::sheen::sheenThrough(bsdf, wi)",
  out: "package::lobes::sheen::sheenOut(bsdf)",
};

/** Fibres that stand off a surface, as of velvet. KHR_materials_sheen */
export const sheen = {
  feature: "SHEEN",
  features: { SHEEN: { word: "sheen", isIn: hasSheen } },
  columns: {
    sheenColor: {
      type: "vec3f",
      when,
      of: ({ sheenColor }) => sheenColor,
      texture: ["sheenColorTexture", "color"],
    },
    sheenRoughness: {
      type: "f32",
      when,
      of: ({ sheenRoughness }) => Math.max(sheenRoughness, LEAST_ROUGHNESS),
      texture: ["sheenRoughnessTexture", "a", LEAST_ROUGHNESS],
    },
  },
  derived: {
    // What white fibres reflect towards the viewer.
    sheenAlbedo: { type: "f32", when, from: "package::lobes::sheen::sheenAlbedo(wo.z, bsdf.sheenRoughness)" },
  },
  layer: FIBRES,
  share: "package::lobes::sheen::sheenShare(bsdf)",
  value: "package::lobes::sheen::sheenValue(bsdf, at)",
  sample: "package::directions::uniformHemisphere(u)",
  expect: "package::lobes::sheen::sheenExpect(bsdf)",
} as const satisfies Lobe;
