// KHR_materials_pbrSpecularGlossiness, as KHR_materials_specular converts it.
//
// F0, α and, at normal incidence, the diffuse albedo are exactly the extension's. It scales the albedo by 1 − max(F0) whatever
// the angle. Here that is 1 − max(F), as for every dielectric, so that no light is made of nothing at grazing angles.

import type { Material, Rgb } from "../../scene/schema";
import type { GltfMaterialExtensions } from "./materialSchema";
import type { Base } from "./surface";
import { isBright, toFraction, toReflectance } from "./surfacePart";

type SpecularGlossiness = NonNullable<GltfMaterialExtensions["KHR_materials_pbrSpecularGlossiness"]>;

/** 1/F0 of ior 1.5. As a specular colour it makes a dielectric reflect everything. */
const FULL_REFLECTION = 25;

export function specularGlossiness({
  diffuseFactor = [1, 1, 1, 1],
  diffuseTexture,
  specularFactor = [1, 1, 1],
  glossinessFactor = 1,
  specularGlossinessTexture,
}: SpecularGlossiness): Base {
  const specular = toReflectance(specularFactor);
  const glossiness = toFraction(glossinessFactor);
  return {
    color: diffuseFactor,
    colorTexture: diffuseTexture,
    fields: { metallic: 0, roughness: 1 - glossiness, ...reflecting(specular) },
    textures: [
      ["metallicRoughnessTexture", glossiness > 0 ? specularGlossinessTexture : undefined],
      ["specularColorTexture", isBright(specular) ? specularGlossinessTexture : undefined],
    ],
    glossiness,
  };
}

/**
 * A dielectric that reflects so much at normal incidence. An `ior` that does so by itself would be infinite, and of no use for
 * refraction.
 */
export function reflecting([r, g, b]: Rgb): Material {
  return { ior: 1.5, specularColor: [FULL_REFLECTION * r, FULL_REFLECTION * g, FULL_REFLECTION * b] };
}
