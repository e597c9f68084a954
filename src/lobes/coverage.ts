import type { ResolvedMaterial } from "../scene/schema";
import type { MaterialPart } from "./lobe";

/** Whether rays may pass a surface. */
export function hasHoles({ alphaMode, alphaCutoff }: ResolvedMaterial): boolean {
  return alphaMode === "blend" || (alphaMode === "mask" && alphaCutoff > 0);
}

/** How much of a surface is there: `wgsl/coverage.wgsl`. */
export const coverage = {
  features: {
    ALPHA: { word: "alpha", isIn: hasHoles },
    ALPHA_TEXTURES: { isIn: (material) => hasHoles(material) && material.baseColorTexture !== undefined },
  },
  columns: {
    coverage: {
      type: "f32",
      when: ({ ALPHA }) => ALPHA!,
      of: ({ alpha }) => alpha,
    },
    // What a mask has at least where it is there; 0 of an opaque surface, -1 of one that is there with the probability `coverage`.
    cutoff: {
      type: "f32",
      when: ({ ALPHA }) => ALPHA!,
      of: (material) => (hasHoles(material) ? (material.alphaMode === "mask" ? material.alphaCutoff : -1) : 0),
    },
  },
} as const satisfies MaterialPart;
