import type { Light } from "../lights/light";
import { type ResolvedMaterial, TEXTURE_FIELDS, type TextureField } from "../scene/schema";
import { hullOf, kindOf, type Shape } from "../shapes/shapes";
import type { Geometry } from "../tree/geometry";
import { isEmissive, type Primitive } from "./primitives";

/** Which estimator and sampler to compile; the settings that shape the program. */
export type ProgramSettings = {
  readonly estimator: "path" | "uniform";
  readonly sampler: "sobol" | "independent";
  readonly lightSamples: number;
};

/** The conditions of the shader modules' `@if`s. */
export type Features = ReturnType<typeof deriveFeatures>;

/** What the shader must be able to do for this scene. Derived, never configured. */
export function deriveFeatures(
  primitives: readonly Primitive[],
  lights: readonly Light[],
  hasEnvironment: boolean,
  geometry: Geometry | undefined,
  settings: ProgramSettings,
) {
  const materials = [...new Set(primitives.map(({ material }) => material))].filter((material) => material !== "black");
  const specular = materials.filter(hasSpecularLobe);
  const rough = specular.filter((material) => alphaOf(material) > 0);
  const hasTexture = (field: TextureField) => materials.some((material) => material[field] !== undefined);
  const families = new Set(primitives.map(({ shape }) => familyOf(shape)));
  const NORMAL_TEXTURES = hasTexture("normalTexture");
  const isSmooth = geometry?.data.normals !== undefined;

  const DIFFUSE = materials.length === 0 || materials.some(hasDiffuseLobe);
  const SPECULAR = specular.length > 0;
  return {
    BALLS: families.has("ball"),
    HUGE_BALLS: hasHugeBalls(primitives),
    SOLIDS: families.has("solid"),
    // Flat shapes that may meet at an edge.
    RIMS: hasRims(primitives),
    // Something is in the tree: triangles of meshes, other shapes.
    TREE: geometry !== undefined,
    MESHES: geometry !== undefined && geometry.parts.length > 0,
    TREE_SOLIDS: geometry?.treeShapes.some(({ shape }) => familyOf(shape) === "solid") ?? false,
    // Some mesh has normals.
    SMOOTH: isSmooth,
    // Or a texture of them: shading goes by another normal than the surface's own.
    SHADING_NORMALS: isSmooth || NORMAL_TEXTURES,
    TEXTURES: TEXTURE_FIELDS.some(hasTexture),
    SURFACE_TEXTURES: hasTexture("baseColorTexture") || hasTexture("metallicRoughnessTexture"),
    EMISSION_TEXTURES: hasTexture("emissionTexture"),
    NORMAL_TEXTURES,
    DIFFUSE,
    SPECULAR,
    ROUGH: rough.length > 0,
    MIRROR: specular.some((material) => alphaOf(material) === 0),
    SMITH: rough.some((material) => material.masking === "smith"),
    SCHLICK_BECKMANN: rough.some((material) => material.masking === "schlick-beckmann"),
    MULTISCATTER: rough.some((material) => material.multiscatter && material.metallic > 0),
    // Some surface has both.
    LOBES: specular.some(hasDiffuseLobe),
    EMISSION: primitives.some(isEmissive),
    EMISSIVE_BALLS: primitives.some((primitive) => isEmissive(primitive) && familyOf(primitive.shape) === "ball"),
    LAMPS: primitives.some(isEmissive) && settings.estimator === "path",
    LIGHTS: lights.length > 0,
    // Some light has parts to choose from.
    LIGHT_PICKS: geometry !== undefined && geometry.lights.size > 0,
    MANY_LIGHTS: lights.length > 1 && settings.estimator === "path",
    // Of those, some shine to one side only.
    FLAT_LIGHTS: lights.some(({ front }) => front !== undefined),
    ENVIRONMENT: hasEnvironment,
    SOBOL: settings.sampler === "sobol",
    UNIFORM: settings.estimator === "uniform",
    MANY_LIGHT_SAMPLES: settings.lightSamples > 1,
  };
}

type Family = "flat" | "ball" | "solid" | "mesh";

/** By the row that the shader tells it from: see `ShapeKind`. */
function familyOf(shape: Shape): Family {
  const { triangleDistance, row } = kindOf(shape);
  if (triangleDistance) return "mesh";
  const w = row(shape)[3];
  if (w === 0) return "flat";
  return w > 0 ? "ball" : "solid";
}

/** Balls that are better measured from their surface than from their centre. */
export function hasHugeBalls(primitives: readonly Primitive[]): boolean {
  return primitives.some(({ shape }) => familyOf(shape) === "ball" && kindOf(shape).anchor(shape)[3] > 0);
}

/** Flat shapes that may meet at an edge. */
export function hasRims(primitives: readonly Primitive[]): boolean {
  return primitives.filter(({ shape }) => familyOf(shape) === "flat" && hullOf(shape) !== undefined).length > 1;
}

/** A texture may make a metal less of one. */
function hasDiffuseLobe({ metallic, metallicRoughnessTexture }: ResolvedMaterial): boolean {
  return metallic < 1 || metallicRoughnessTexture !== undefined;
}

/** A dielectric of ior 1 has no interface: it is Lambert only. */
export function hasSpecularLobe(material: ResolvedMaterial): boolean {
  return material.metallic > 0 || material.ior > 1;
}

// Microfacets tilted by less than f32 rounds a direction; with a smaller α the square of their density overflows.
const LEAST_ALPHA = 2 ** -24;

/** Width of the microfacets' distribution; 0 is a perfect mirror. */
export function alphaOf({ roughness }: ResolvedMaterial): number {
  const alpha = roughness ** 2;
  return alpha < LEAST_ALPHA ? 0 : alpha;
}

/** The features in words, for people: what the compiled shader contains. */
export function describeFeatures(
  primitives: readonly Primitive[],
  lights: readonly Light[],
  features: Features,
): string[] {
  const shapes = new Map<string, number>();
  for (const { shape } of primitives) shapes.set(shape.kind, (shapes.get(shape.kind) ?? 0) + 1);
  const lightCounts = new Map<string, number>();
  for (const { kind } of lights) lightCounts.set(kind, (lightCounts.get(kind) ?? 0) + 1);
  const counted = (count: number, what: string) => (count === 1 ? what : `${count} × ${what}`);
  return [
    ...[...shapes].map(([kind, count]) => counted(count, kind)),
    ...(features.DIFFUSE ? ["diffuse"] : []),
    ...(features.ROUGH ? ["GGX"] : []),
    ...(features.MIRROR ? ["mirror"] : []),
    ...(features.SMITH ? ["Smith masking"] : []),
    ...(features.SCHLICK_BECKMANN ? ["Schlick–Beckmann masking"] : []),
    ...(features.MULTISCATTER ? ["multiple scattering"] : []),
    ...(features.SMOOTH ? ["smooth normals"] : []),
    ...(features.TEXTURES ? ["textures"] : []),
    ...[...lightCounts].map(([kind, count]) => counted(count, `${kind} light`)),
    ...(features.ENVIRONMENT ? ["environment"] : []),
    features.SOBOL ? "Sobol points" : "independent points",
    ...(features.UNIFORM ? ["uniform estimator"] : []),
    ...(features.MANY_LIGHT_SAMPLES ? ["many light samples"] : []),
  ];
}
