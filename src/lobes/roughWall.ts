import { alphaOf } from "./fresnel";
import type { Lobe } from "./lobe";
import { isSolid, isTransmissive } from "./transmission";

/** Through a thin wall of microfacets: what GGX reflects, on the other side. */
export const roughWall = {
  feature: "ROUGH_WALL",
  features: {
    ROUGH_WALL: {
      word: "rough transmission",
      isIn: (material) => isTransmissive(material) && !isSolid(material) && alphaOf(material) > 0,
    },
  },
  columns: {
    // 1 of a thin wall, else 0.
    isWall: {
      type: "f32",
      when: ({ ROUGH_WALL }) => ROUGH_WALL!,
      of: (material) => (isTransmissive(material) && !isSolid(material) ? 1 : 0),
    },
  },
  isBelow: true,
  share: "package::lobes::roughWall::roughWallShare(bsdf, wo)",
  value: "package::lobes::roughWall::roughWallValue(bsdf, at)",
  sample: "package::lobes::roughWall::roughWallDirection(bsdf, wo, u)",
  expect: "package::lobes::roughWall::roughWallExpect(bsdf, wo, wi, cosI, size)",
} as const satisfies Lobe;
