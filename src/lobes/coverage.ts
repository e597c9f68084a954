import type { ResolvedMaterial } from "../scene/schema";
import { alphaOf } from "./fresnel";
import type { MaterialPart } from "./lobe";
import { isSolid, isTransmissive } from "./transmission";

/** Whether rays may pass a surface. */
export function hasHoles(material: ResolvedMaterial): boolean {
  return hasAlpha(material) || isClearWall(material);
}

/** Is a thin wall without microfacets, which light passes straight. */
export function isClearWall(material: ResolvedMaterial): boolean {
  return isTransmissive(material) && !isSolid(material) && alphaOf(material) === 0;
}

function hasAlpha({ alphaMode, alphaCutoff }: ResolvedMaterial): boolean {
  return alphaMode === "blend" || (alphaMode === "mask" && alphaCutoff > 0);
}

/** Whether light that passes it is coloured. */
function isColored(material: ResolvedMaterial): boolean {
  const { baseColor } = material;
  return material.baseColorTexture !== undefined || baseColor.some((channel) => channel !== baseColor[0]);
}

// As in wgsl/coverage.wgsl.
const BLEND = -1;
const CLEAR = -2;

/** How much of a surface is there: `wgsl/coverage.wgsl`. */
export const coverage = {
  features: {
    HOLES: { isIn: hasHoles },
    ALPHA: { word: "alpha", isIn: hasAlpha },
    ALPHA_TEXTURES: { isIn: (material) => hasAlpha(material) && material.baseColorTexture !== undefined },
    CLEAR_WALLS: { isIn: isClearWall },
    COLORED_WALLS: { isIn: (material) => isClearWall(material) && isColored(material) },
  },
  columns: {
    coverage: {
      type: "f32",
      when: ({ HOLES }) => HOLES!,
      of: (material) => (hasAlpha(material) ? material.alpha : 1),
    },
    // What a mask has at least where it is there; 0 of an opaque surface, BLEND of one that is there with the probability `coverage`,
    // CLEAR of a wall that is there.
    cutoff: {
      type: "f32",
      when: ({ HOLES }) => HOLES!,
      of: (material) => {
        if (!hasAlpha(material)) return isClearWall(material) ? CLEAR : 0;
        return material.alphaMode === "mask" ? material.alphaCutoff : BLEND;
      },
    },
    // 1 of a wall that light passes straight.
    isClear: {
      type: "f32",
      when: ({ CLEAR_WALLS }) => CLEAR_WALLS!,
      of: (material) => (isClearWall(material) ? 1 : 0),
    },
  },
} as const satisfies MaterialPart;
