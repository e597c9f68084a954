// The part of a glTF material that is read, its extensions included.

import * as v from "valibot";
import { color, finite, index, isFlagged, name, nonNegative, vec2, vec3, vec4 } from "./schemaParts";

const textureInfo = {
  index,
  texCoord: v.optional(index),
  extensions: v.optional(
    v.object({
      KHR_texture_transform: v.optional(
        v.object({
          offset: v.optional(vec2),
          rotation: v.optional(finite),
          scale: v.optional(vec2),
          texCoord: v.optional(index),
        }),
      ),
    }),
  ),
};
const Texture = v.optional(v.object(textureInfo));
const NormalTexture = v.optional(v.object({ ...textureInfo, scale: v.optional(finite) }));
/** What is out of range is brought into it later, and not refused. */
const Factor = v.optional(finite);
const Color = v.optional(vec3);

const Extensions = v.object({
  KHR_materials_emissive_strength: v.optional(v.object({ emissiveStrength: v.optional(nonNegative) })),
  KHR_materials_unlit: v.optional(v.object({})),
  KHR_materials_ior: v.optional(v.object({ ior: Factor })),
  KHR_materials_pbrSpecularGlossiness: v.optional(
    v.object({
      diffuseFactor: v.optional(vec4),
      diffuseTexture: Texture,
      specularFactor: Color,
      glossinessFactor: Factor,
      specularGlossinessTexture: Texture,
    }),
  ),
  KHR_materials_specular: v.optional(
    v.object({
      specularFactor: Factor,
      specularTexture: Texture,
      specularColorFactor: Color,
      specularColorTexture: Texture,
    }),
  ),
  KHR_materials_transmission: v.optional(v.object({ transmissionFactor: Factor, transmissionTexture: Texture })),
  // Rays find out themselves how thick things are: thicknessTexture is not read.
  KHR_materials_volume: v.optional(
    v.object({
      thicknessFactor: Factor,
      // Infinity is what absorbs nothing: 1e999 in JSON, or the null that JavaScript makes of it.
      attenuationDistance: v.nullish(v.number()),
      attenuationColor: Color,
    }),
  ),
  KHR_materials_dispersion: v.optional(v.object({ dispersion: Factor })),
  KHR_materials_diffuse_transmission: v.optional(
    v.object({
      diffuseTransmissionFactor: Factor,
      diffuseTransmissionTexture: Texture,
      diffuseTransmissionColorFactor: Color,
      diffuseTransmissionColorTexture: Texture,
    }),
  ),
  KHR_materials_clearcoat: v.optional(
    v.object({
      clearcoatFactor: Factor,
      clearcoatTexture: Texture,
      clearcoatRoughnessFactor: Factor,
      clearcoatRoughnessTexture: Texture,
      clearcoatNormalTexture: NormalTexture,
    }),
  ),
  KHR_materials_sheen: v.optional(
    v.object({
      sheenColorFactor: Color,
      sheenColorTexture: Texture,
      sheenRoughnessFactor: Factor,
      sheenRoughnessTexture: Texture,
    }),
  ),
  KHR_materials_anisotropy: v.optional(
    v.object({ anisotropyStrength: Factor, anisotropyRotation: Factor, anisotropyTexture: Texture }),
  ),
  KHR_materials_iridescence: v.optional(
    v.object({
      iridescenceFactor: Factor,
      iridescenceTexture: Texture,
      iridescenceIor: Factor,
      iridescenceThicknessMinimum: Factor,
      iridescenceThicknessMaximum: Factor,
      iridescenceThicknessTexture: Texture,
    }),
  ),
});

export const MaterialSchema = v.object({
  name,
  pbrMetallicRoughness: v.optional(
    v.object({
      baseColorFactor: v.optional(vec4),
      metallicFactor: Factor,
      roughnessFactor: Factor,
      baseColorTexture: Texture,
      metallicRoughnessTexture: Texture,
    }),
  ),
  normalTexture: NormalTexture,
  emissiveTexture: Texture,
  emissiveFactor: v.optional(color),
  alphaMode: v.optional(v.picklist(["OPAQUE", "MASK", "BLEND"])),
  alphaCutoff: v.optional(nonNegative),
  doubleSided: isFlagged,
  extensions: v.optional(Extensions),
});

export type GltfMaterial = v.InferOutput<typeof MaterialSchema>;
export type GltfMaterialExtensions = v.InferOutput<typeof Extensions>;
/** Which texture of the file, and where it lies. */
export type GltfTextureInfo = NonNullable<GltfMaterial["emissiveTexture"]>;
