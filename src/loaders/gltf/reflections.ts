// Other reflections: KHR_materials_ior, _specular, _clearcoat, _sheen, _anisotropy and _iridescence.

import type { GltfMaterialExtensions } from "./materialSchema";
import { reflecting } from "./specularGlossiness";
import { isBright, NOTHING, type SurfacePart, toFraction, toPositive, toReflectance } from "./surfacePart";
import { toDegrees } from "./textureCoordinates";

// Less than this is nothing that anybody means, and a mirror in any case: it reflects 99.6 %.
const MIN_IOR = 1e-3;

/** The reflection of what is not metal. */
export function dielectric(extensions: GltfMaterialExtensions, warn: (text: string) => void): SurfacePart {
  const { KHR_materials_ior, KHR_materials_specular: extension } = extensions;
  const {
    specularFactor = 1,
    specularTexture,
    specularColorFactor = [1, 1, 1],
    specularColorTexture,
  } = extension ?? {};
  const [r, g, b] = specularColorFactor;
  const color = [toPositive(r), toPositive(g), toPositive(b)] as const;
  const specular = toFraction(specularFactor);
  const ior = iorOf(KHR_materials_ior?.ior, warn);
  return {
    fields: {
      // The extension's word for materials that were specular-glossiness: all light is reflected, as far as the colour lets it.
      ...(ior === 0 ? reflecting(color) : { ior }),
      ...(extension?.specularFactor !== undefined && { specular }),
      ...(ior !== 0 && extension?.specularColorFactor !== undefined && { specularColor: color }),
    },
    textures: [
      ["specularTexture", specular > 0 ? specularTexture : undefined],
      ["specularColorTexture", specular > 0 && isBright(color) ? specularColorTexture : undefined],
    ],
  };
}

function iorOf(ior = 1.5, warn: (text: string) => void): number {
  if (ior < 0) {
    warn(`KHR_materials_ior: ${ior} is not allowed: 1.5 takes its place`);
    return 1.5;
  }
  if (ior === 0 || ior >= 1) return ior;
  warn(`KHR_materials_ior: ${ior} is not allowed, and shown as it is: as if what is around were denser`);
  return Math.max(MIN_IOR, ior);
}

export function clearcoat({ KHR_materials_clearcoat: extension }: GltfMaterialExtensions): SurfacePart {
  const {
    clearcoatFactor = 0,
    clearcoatTexture,
    clearcoatRoughnessFactor = 0,
    clearcoatRoughnessTexture,
    clearcoatNormalTexture,
  } = extension ?? {};
  if (clearcoatFactor <= 0) return NOTHING;
  const { scale: clearcoatNormalScale } = clearcoatNormalTexture ?? {};
  return {
    fields: {
      clearcoat: toFraction(clearcoatFactor),
      clearcoatRoughness: toFraction(clearcoatRoughnessFactor),
      ...(clearcoatNormalScale !== undefined && { clearcoatNormalScale }),
    },
    textures: [
      ["clearcoatTexture", clearcoatTexture],
      ["clearcoatRoughnessTexture", clearcoatRoughnessFactor > 0 ? clearcoatRoughnessTexture : undefined],
      ["clearcoatNormalTexture", clearcoatNormalTexture],
    ],
  };
}

export function sheen({ KHR_materials_sheen: extension }: GltfMaterialExtensions): SurfacePart {
  const {
    sheenColorFactor = [0, 0, 0],
    sheenColorTexture,
    sheenRoughnessFactor = 0,
    sheenRoughnessTexture,
  } = extension ?? {};
  if (!isBright(sheenColorFactor)) return NOTHING;
  return {
    fields: { sheenColor: toReflectance(sheenColorFactor), sheenRoughness: toFraction(sheenRoughnessFactor) },
    textures: [
      ["sheenColorTexture", sheenColorTexture],
      ["sheenRoughnessTexture", sheenRoughnessFactor > 0 ? sheenRoughnessTexture : undefined],
    ],
  };
}

export function anisotropy({ KHR_materials_anisotropy: extension }: GltfMaterialExtensions): SurfacePart {
  const { anisotropyStrength = 0, anisotropyRotation = 0, anisotropyTexture } = extension ?? {};
  if (anisotropyStrength <= 0) return NOTHING;
  return {
    fields: { anisotropy: toFraction(anisotropyStrength), anisotropyRotation: toDegrees(anisotropyRotation) },
    textures: [["anisotropyTexture", anisotropyTexture]],
  };
}

export function iridescence({ KHR_materials_iridescence: extension }: GltfMaterialExtensions): SurfacePart {
  const {
    iridescenceFactor = 0,
    iridescenceTexture,
    iridescenceIor = 1.3,
    iridescenceThicknessMinimum = 100,
    iridescenceThicknessMaximum = 400,
    iridescenceThicknessTexture,
  } = extension ?? {};
  if (iridescenceFactor <= 0) return NOTHING;
  const [least, most] = [toPositive(iridescenceThicknessMinimum), toPositive(iridescenceThicknessMaximum)];
  return {
    fields: {
      iridescence: toFraction(iridescenceFactor),
      iridescenceIor: Math.max(1, iridescenceIor),
      iridescenceThickness: most,
      ...(iridescenceThicknessTexture !== undefined && { iridescenceThicknessMinimum: least }),
    },
    textures: [
      ["iridescenceTexture", iridescenceTexture],
      ["iridescenceThicknessTexture", least === most ? undefined : iridescenceThicknessTexture],
    ],
  };
}
