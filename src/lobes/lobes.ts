// Lobes of a material: what the shader has to know of them, and when.

import { add, scale } from "../math/vec3";
import { dielectricF0 } from "../scene/metals";
import type { ResolvedMaterial, Rgb } from "../scene/schema";

// Microfacets tilted by less than f32 rounds a direction; with a smaller α the square of their density overflows.
const LEAST_ALPHA = 2 ** -24;

/** Width of the microfacets' distribution; 0 is a perfect mirror. */
function alphaOf({ roughness }: ResolvedMaterial): number {
  const alpha = roughness ** 2;
  return alpha < LEAST_ALPHA ? 0 : alpha;
}

/** A dielectric of ior 1 has no interface: it is Lambert only. */
function hasSpecularLobe({ metallic, ior }: ResolvedMaterial): boolean {
  return metallic > 0 || ior > 1;
}

/** A texture may make a metal less of one. */
function hasDiffuseLobe({ metallic, metallicRoughnessTexture }: ResolvedMaterial): boolean {
  return metallic < 1 || metallicRoughnessTexture !== undefined;
}

/** Conditions of the shader modules' `@if`s. */
export function lobeFeatures(materials: readonly ResolvedMaterial[]) {
  const specular = materials.filter(hasSpecularLobe);
  const rough = specular.filter((material) => alphaOf(material) > 0);
  return {
    DIFFUSE: materials.length === 0 || materials.some(hasDiffuseLobe),
    SPECULAR: specular.length > 0,
    ROUGH: rough.length > 0,
    MIRROR: specular.some((material) => alphaOf(material) === 0),
    SMITH: rough.some(({ masking }) => masking === "smith"),
    SCHLICK_BECKMANN: rough.some(({ masking }) => masking === "schlick-beckmann"),
    MULTISCATTER: rough.some(({ multiscatter, metallic }) => multiscatter && metallic > 0),
    // Some surface has both a diffuse and a specular lobe.
    LOBES: specular.some(hasDiffuseLobe),
  };
}

/** What they are called. */
export const LOBE_WORDS = {
  DIFFUSE: "diffuse",
  ROUGH: "GGX",
  MIRROR: "mirror",
  SMITH: "Smith masking",
  SCHLICK_BECKMANN: "Schlick–Beckmann masking",
  MULTISCATTER: "multiple scattering",
} as const satisfies { readonly [F in keyof ReturnType<typeof lobeFeatures>]?: string };

/** What the table of materials holds of its lobes: see `Material` in `wgsl/surface.wgsl`. */
export function reflectance(material: ResolvedMaterial | "black") {
  if (material === "black") return BLACK;
  const { baseColor, metallic, ior, masking, multiscatter } = material;
  if (!hasSpecularLobe(material)) return { ...BLACK, diffuse: baseColor };
  const f0 = dielectricF0(ior);
  return {
    F0: add(scale([f0, f0, f0], 1 - metallic), scale(baseColor, metallic)),
    alpha: alphaOf(material),
    diffuse: scale(baseColor, 1 - metallic),
    f0,
    f90: 1,
    schlickBeckmann: masking === "schlick-beckmann" ? 1 : 0,
    multiscatter: multiscatter ? metallic : 0,
  };
}

const BLACK = {
  F0: [0, 0, 0],
  alpha: 1,
  diffuse: [0, 0, 0] as Rgb,
  f0: 0,
  f90: 0,
  schlickBeckmann: 0,
  multiscatter: 0,
};
