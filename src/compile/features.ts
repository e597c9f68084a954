import type { Light } from "../lights/light";
import { isDistant } from "../lights/lights";
import { absorbs } from "../lobes/absorption";
import { hasHoles } from "../lobes/coverage";
import { LOBE_WORDS, lobeFeatures } from "../lobes/lobes";
import { TEXTURE_FIELDS, type TextureField } from "../scene/schema";
import { isPlain } from "../scene/textureReference";
import { hullOf, kindOf, type Shape } from "../shapes/shapes";
import type { Geometry } from "../tree/geometry";
import { rareTextures } from "./factors";
import { isEmissive, type Primitive } from "./primitives";
import { mayMeet } from "./volumes";

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
  {
    hasEnvironment,
    hasLens,
    isImmersed,
  }: { readonly hasEnvironment: boolean; readonly hasLens: boolean; readonly isImmersed: boolean },
  geometry: Geometry | undefined,
  settings: ProgramSettings,
) {
  const materials = [...new Set(primitives.map(({ material }) => material))].filter((material) => material !== "black");
  const hasTexture = (field: TextureField) => materials.some((material) => material[field] !== undefined);
  const families = new Set(primitives.map(({ shape }) => familyOf(shape)));
  const NORMAL_TEXTURES = hasTexture("normalTexture");
  const COLORS = geometry?.vertexLayout.colors !== undefined;
  const isStretched = materials.some(({ anisotropy }) => anisotropy > 0);
  const hasUvs = geometry !== undefined && geometry.parts.length > 0 && geometry.vertexLayout.uvs !== undefined;
  const hasTangents = geometry?.vertexLayout.tangents !== undefined;
  const lobes = lobeFeatures(materials);
  const isSmooth = geometry?.data.normals !== undefined;
  return {
    BALLS: families.has("ball"),
    HUGE_BALLS: hasHugeBalls(primitives),
    SOLIDS: families.has("solid"),
    // Flat shapes that may meet at an edge.
    RIMS: hasRims(primitives),
    // Something is in the tree: triangles of meshes, other shapes.
    TREE: geometry !== undefined,
    MESHES: geometry !== undefined && geometry.parts.length > 0,
    // Some of it has holes.
    TREE_HOLES:
      geometry !== undefined &&
      primitives.some(
        ({ shape }, id) => (familyOf(shape) === "triangles" || geometry.shapes.has(id)) && hasHolesAt(primitives, id),
      ),
    // Some of it has a far side.
    TREE_CLOSED: geometry?.treeShapes.some(({ shape }) => familyOf(shape) !== "flat") ?? false,
    TREE_SOLIDS: geometry?.treeShapes.some(({ shape }) => familyOf(shape) === "solid") ?? false,
    // Some mesh has normals.
    SMOOTH: isSmooth,
    // Or a texture of them: shading goes by another normal than the surface's own.
    SHADING_NORMALS: isSmooth || NORMAL_TEXTURES,
    TEXTURES: TEXTURE_FIELDS.some(hasTexture),
    COLORS,
    TANGENTS: (NORMAL_TEXTURES || hasTexture("clearcoatNormalTexture") || isStretched) && hasTangents,
    // Vertices have more than positions and normals.
    VERTICES: COLORS || TEXTURE_FIELDS.some(hasTexture) || (isStretched && hasUvs),
    // The stretch of meshes follows their texture coordinates.
    MESH_STRETCH: isStretched && hasUvs,
    UNLIT_COLORS: COLORS && materials.some(({ unlit }) => unlit),
    SURFACE_TEXTURES: hasTexture("baseColorTexture") || hasTexture("metallicRoughnessTexture"),
    // Textures of glTF's extensions.
    LOBE_TEXTURES: rareTextures(primitives).length > 0,
    SPECULAR_TEXTURES: hasTexture("specularTexture") || hasTexture("specularColorTexture"),
    EMISSION_TEXTURES: hasTexture("emissionTexture"),
    NORMAL_TEXTURES,
    // Some texture is looked up with other coordinates than the first of its mesh as they are.
    UV_TRANSFORMS: TEXTURE_FIELDS.some((field) => materials.some(({ [field]: t }) => t !== undefined && !isPlain(t))),
    ...lobes,
    COLORED_WALLS: lobes.COLORED_WALLS || (lobes.CLEAR_WALLS && COLORS),
    // The camera may be in a solid in which light gets lost.
    IMMERSED: isImmersed,
    // Solids may hold each other, or touch, and light gets lost in some.
    NESTED: mayMeet(primitives),
    // Some solid in which light gets lost is infinite.
    OCEANS: primitives.some(
      ({ shape, material }) => hullOf(shape) === undefined && material !== "black" && absorbs(material),
    ),
    EMISSION: primitives.some(isEmissive),
    EMISSIVE_BALLS: primitives.some((primitive) => isEmissive(primitive) && familyOf(primitive.shape) === "ball"),
    VISIBLE_EMITTERS: primitives.some(isEmissive) && settings.estimator === "path",
    LIGHTS: lights.length > 0,
    // Some light has parts to choose from.
    LIGHT_PICKS: geometry !== undefined && geometry.lights.size > 0,
    MANY_LIGHTS: lights.length > 1 && settings.estimator === "path",
    // Of those, some shine to one side only.
    FLAT_LIGHTS: lights.some(({ front }) => front !== undefined),
    // Rays that escape may find lights.
    SKY_DISKS: lights.some((light) => isDistant(light) && light.size > 0),
    ENVIRONMENT: hasEnvironment,
    LENS: hasLens,
    SOBOL: settings.sampler === "sobol",
    INDEPENDENT: settings.sampler === "independent",
    UNIFORM: settings.estimator === "uniform",
    MANY_LIGHT_SAMPLES: settings.lightSamples > 1,
  };
}

type Family = "flat" | "ball" | "solid" | "triangles";

/** By the row that the shader tells it from: see `ShapeKind`. */
export function familyOf(shape: Shape): Family {
  const { triangleDistance, row } = kindOf(shape);
  if (triangleDistance) return "triangles";
  const w = row(shape)[3];
  if (w === 0) return "flat";
  return w > 0 ? "ball" : "solid";
}

/** Whether a primitive has holes. */
export function hasHolesAt(primitives: readonly Primitive[], id: number): boolean {
  const { material } = primitives[id]!;
  return material !== "black" && hasHoles(material);
}

/** Balls that are better measured from their surface than from their centre. */
function hasHugeBalls(primitives: readonly Primitive[]): boolean {
  return primitives.some(({ shape }) => familyOf(shape) === "ball" && kindOf(shape).anchor(shape)[3] > 0);
}

/** Flat shapes that may meet at an edge. */
function hasRims(primitives: readonly Primitive[]): boolean {
  return primitives.filter(({ shape }) => familyOf(shape) === "flat" && hullOf(shape) !== undefined).length > 1;
}

/** The features in words, for people: what the compiled shader contains. */
export function describeFeatures(
  primitives: readonly Primitive[],
  lights: readonly Light[],
  features: Features,
): string[] {
  return [
    ...counted(primitives.map(({ shape }) => shape.kind)),
    ...wordsOf(SURFACE_WORDS, features),
    ...counted(lights.map(({ kind }) => `${kind} light`)),
    ...wordsOf(SETTING_WORDS, features),
  ];
}

type Words = { readonly [F in keyof Features]?: string };

const SURFACE_WORDS: Words = {
  ...LOBE_WORDS,
  SMOOTH: "smooth normals",
  COLORS: "vertex colours",
  TEXTURES: "textures",
};
const SETTING_WORDS: Words = {
  ENVIRONMENT: "environment",
  LENS: "lens",
  SOBOL: "Sobol points",
  INDEPENDENT: "independent points",
  UNIFORM: "uniform estimator",
  MANY_LIGHT_SAMPLES: "many light samples",
};

function wordsOf(words: Words, features: Features): string[] {
  return Object.entries(words).flatMap(([feature, word]) => (features[feature as keyof Features] ? [word] : []));
}

/** Each once, with its number. */
function counted(names: readonly string[]): string[] {
  const counts = new Map<string, number>();
  for (const name of names) counts.set(name, (counts.get(name) ?? 0) + 1);
  return Array.from(counts, ([name, count]) => (count === 1 ? name : `${count} × ${name}`));
}
