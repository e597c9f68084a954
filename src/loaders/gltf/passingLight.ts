// Light that passes: KHR_materials_transmission, _volume, _dispersion and _diffuse_transmission.

import type { Material } from "../../scene/schema";
import type { GltfMaterialExtensions } from "./materialSchema";
import { isBright, NOTHING, type SurfacePart, toFraction, toPositive, toReflectance } from "./surfacePart";

// Bounds of the scene format.
const MIN_DISTANCE = 1e-18;
const MAX_DISTANCE = 1e18;

export function passingLight(extensions: GltfMaterialExtensions, warn: (text: string) => void): SurfacePart {
  const parts = [transmission(extensions), diffuseTransmission(extensions)].filter((part) => part !== NOTHING);
  if (parts.length === 0) return NOTHING;
  return {
    fields: Object.assign({}, ...parts.map(({ fields }) => fields), volume(extensions, warn)),
    textures: parts.flatMap(({ textures }) => textures),
  };
}

function transmission({ KHR_materials_transmission: extension }: GltfMaterialExtensions): SurfacePart {
  const { transmissionFactor = 0, transmissionTexture } = extension ?? {};
  if (transmissionFactor <= 0) return NOTHING;
  return {
    fields: { transmission: toFraction(transmissionFactor) },
    textures: [["transmissionTexture", transmissionTexture]],
  };
}

function diffuseTransmission({ KHR_materials_diffuse_transmission: extension }: GltfMaterialExtensions): SurfacePart {
  const {
    diffuseTransmissionFactor = 0,
    diffuseTransmissionTexture,
    diffuseTransmissionColorFactor = [1, 1, 1],
    diffuseTransmissionColorTexture,
  } = extension ?? {};
  if (diffuseTransmissionFactor <= 0) return NOTHING;
  const color = toReflectance(diffuseTransmissionColorFactor);
  return {
    fields: { diffuseTransmission: toFraction(diffuseTransmissionFactor), diffuseTransmissionColor: color },
    textures: [
      ["diffuseTransmissionTexture", diffuseTransmissionTexture],
      ["diffuseTransmissionColorTexture", isBright(color) ? diffuseTransmissionColorTexture : undefined],
    ],
  };
}

/** What is behind the surface. Without a thickness that is nothing: the surface is a thin wall. */
function volume(extensions: GltfMaterialExtensions, warn: (text: string) => void): Material {
  const { KHR_materials_volume: extension, KHR_materials_dispersion, KHR_materials_ior } = extensions;
  const { thicknessFactor = 0, attenuationDistance: distance, attenuationColor = [1, 1, 1] } = extension ?? {};
  if (thicknessFactor <= 0) return {};
  const dispersion = toPositive(KHR_materials_dispersion?.dispersion ?? 0);
  if (KHR_materials_ior?.ior === 0) {
    warn("KHR_materials_ior: 0 stands for infinity, with which no light would leave a solid: it refracts as with 1.5");
  }
  const attenuates = distance !== undefined && distance !== null && distance < MAX_DISTANCE;
  // Exporters have written 0 for infinity, which is what absorbs nothing.
  if (attenuates && distance <= 0) {
    warn(`KHR_materials_volume: an attenuationDistance of ${distance} is not allowed, so nothing is absorbed`);
  }
  return {
    thickness: thicknessFactor,
    ...(dispersion > 0 && { dispersion }),
    ...(attenuates &&
      distance > 0 && {
        attenuationColor: toReflectance(attenuationColor),
        attenuationDistance: Math.max(MIN_DISTANCE, distance),
      }),
  };
}
