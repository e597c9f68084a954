import type { ResolvedMaterial } from "../scene/schema";
import { hasInterface } from "./fresnel";
import type { MaterialFeatures, MaterialPart } from "./lobe";

/** Has a film. */
export function hasFilm(material: ResolvedMaterial): boolean {
  return material.iridescence > 0 && hasInterface(material);
}

const when = ({ IRIDESCENCE }: MaterialFeatures) => IRIDESCENCE!;

/** A thin film on an interface, whose reflection interferes with its own. KHR_materials_iridescence */
export const iridescence = {
  features: {
    IRIDESCENCE: { word: "iridescence", isIn: hasFilm },
    FILM_TEXTURES: { isIn: (material) => hasFilm(material) && material.iridescenceThicknessTexture !== undefined },
  },
  columns: {
    iridescence: {
      type: "f32",
      when,
      of: (material) => (hasFilm(material) ? material.iridescence : 0),
      texture: ["iridescenceTexture", "r"],
    },
    filmIor: { type: "f32", when, of: ({ iridescenceIor }) => iridescenceIor },
    // Nanometres.
    filmThickness: { type: "f32", when, of: ({ iridescenceThickness }) => iridescenceThickness },
    // The same where its texture is 0.
    thinnestFilm: {
      type: "f32",
      when: ({ FILM_TEXTURES }) => FILM_TEXTURES!,
      of: ({ iridescenceThicknessMinimum }) => iridescenceThicknessMinimum,
    },
  },
} as const satisfies MaterialPart;
