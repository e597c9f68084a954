// A glTF material in the scene format: glTF's metallic-roughness model is ours, so most of this is names and defaults.

import type { Material, Rgb } from "../../scene/schema";
import type { GltfMaterial, GltfTextureInfo } from "./materialSchema";
import { passingLight } from "./passingLight";
import { anisotropy, clearcoat, dielectric, iridescence, sheen } from "./reflections";
import { specularGlossiness } from "./specularGlossiness";
import { isBright, type SurfacePart, toFraction, toReflectance } from "./surfacePart";
import { coordinateSet } from "./textureCoordinates";

/** What lies below the extensions: a metal or a dielectric, and its colour. */
export type Base = SurfacePart & {
  /** Red, green, blue and alpha. */
  readonly color: readonly [number, number, number, number];
  readonly colorTexture: GltfTextureInfo | undefined;
  /** Given: `metallicRoughnessTexture` is a picture with glossiness in its alpha, which this multiplies. */
  readonly glossiness?: number;
};

export type Surface = SurfacePart &
  Pick<Base, "glossiness"> & {
    /** The texture coordinates that say which way its reflections are stretched, on meshes without tangents. */
    readonly tangentSet?: number;
  };

/**
 * A material as a surface. What has no effect is left out.
 *
 * @param warn - is told what glTF does not allow, and what is not shown.
 */
export function surfaceOf(material: GltfMaterial, warn: (text: string) => void): Surface {
  const { KHR_materials_pbrSpecularGlossiness: glossy, KHR_materials_unlit: unlit } = material.extensions ?? {};
  const base = glossy === undefined ? metallicRoughness(material, warn) : specularGlossiness(glossy);
  if (glossy && material.extensions?.KHR_materials_specular) {
    warn("KHR_materials_specular is left out where KHR_materials_pbrSpecularGlossiness says the same in its way");
  }
  const color = colorOf(base, material);
  // In the order in which textures get texture coordinates, while there are any.
  const parts = unlit
    ? [color, { fields: { unlit: true }, textures: [] }]
    : [color, bentNormal(material), base, emissionOf(material), ...extensionsOf(material, warn)];
  const fields: Material = Object.assign({}, ...parts.map((part) => part.fields));
  return {
    fields,
    textures: parts.flatMap(({ textures }) => textures),
    ...(fields.anisotropy !== undefined && { tangentSet: coordinateSet(material.normalTexture ?? {}) }),
    ...(base.glossiness !== undefined && { glossiness: base.glossiness }),
  };
}

function metallicRoughness(material: GltfMaterial, warn: (text: string) => void): Base {
  const {
    baseColorFactor: color = [1, 1, 1, 1],
    metallicFactor = 1,
    roughnessFactor = 1,
    baseColorTexture: colorTexture,
    metallicRoughnessTexture,
  } = material.pbrMetallicRoughness ?? {};
  const { fields, textures } = dielectric(material.extensions ?? {}, warn);
  return {
    color,
    colorTexture,
    fields: { metallic: toFraction(metallicFactor), roughness: toFraction(roughnessFactor), ...fields },
    textures: [["metallicRoughnessTexture", metallicRoughnessTexture], ...textures],
  };
}

/** The colour, and what of the surface is there. */
function colorOf({ color: [r, g, b, a], colorTexture }: Base, { alphaMode, alphaCutoff }: GltfMaterial): SurfacePart {
  const alpha = toFraction(a);
  return {
    fields: {
      baseColor: toReflectance([r, g, b]),
      ...(alphaMode === "BLEND" && { alphaMode: "blend", alpha }),
      ...(alphaMode === "MASK" && { alphaMode: "mask", alpha, ...(alphaCutoff !== undefined && { alphaCutoff }) }),
    },
    textures: [["baseColorTexture", colorTexture]],
  };
}

function bentNormal({ normalTexture }: GltfMaterial): SurfacePart {
  const { scale: normalScale } = normalTexture ?? {};
  return {
    fields: { ...(normalScale !== undefined && { normalScale }) },
    textures: [["normalTexture", normalTexture]],
  };
}

/** Radiance: emission of strength 1 is 1 W·sr⁻¹·m⁻². */
function emissionOf(material: GltfMaterial): SurfacePart {
  const { emissiveFactor = [0, 0, 0], emissiveTexture, doubleSided, extensions } = material;
  const strength = extensions?.KHR_materials_emissive_strength?.emissiveStrength ?? 1;
  const emission = emissiveFactor.map((channel) => channel * strength) as unknown as Rgb;
  if (!isBright(emission)) return { fields: {}, textures: [] };
  return {
    fields: { emission, ...(doubleSided && { doubleSided }) },
    textures: [["emissionTexture", emissiveTexture]],
  };
}

function extensionsOf({ extensions = {} }: GltfMaterial, warn: (text: string) => void): readonly SurfacePart[] {
  return [
    passingLight(extensions, warn),
    clearcoat(extensions),
    sheen(extensions),
    anisotropy(extensions),
    iridescence(extensions),
  ];
}
