import { defaultsOf } from "./containers";
import { type Material, MaterialSchema, type ResolvedMaterial, type Rgb } from "./schema";

/** Radiance of a surface: one that is unlit has the colour it should show. */
export function emissionOf({ unlit, baseColor = [1, 1, 1], emission = [0, 0, 0] }: Material): Rgb {
  return unlit ? baseColor : emission;
}

/** The surface that looks the same: one that is unlit is black, and emits its colour from both sides. */
export function shown(material: ResolvedMaterial): ResolvedMaterial {
  const { unlit, baseColorTexture, alpha, alphaMode, alphaCutoff } = material;
  if (!unlit) return material;
  return {
    ...BLACK,
    ...{ unlit, alpha, alphaMode, alphaCutoff },
    emission: emissionOf(material),
    doubleSided: true,
    // Which has its alpha, too.
    ...(baseColorTexture !== undefined && { baseColorTexture, emissionTexture: baseColorTexture }),
  };
}

/** Reflects nothing. */
export const BLACK: ResolvedMaterial = { ...defaultsOf(MaterialSchema), baseColor: [0, 0, 0], ior: 1 };
