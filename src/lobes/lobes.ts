// Every lobe, a line each. To add one: its fields in the material's schema, its file and shader module here, and a line below.

import type { ResolvedMaterial, Vec3 } from "../scene/schema";
import { BLACK } from "../scene/shown";
import { absorption } from "./absorption";
import { anisotropy, stretch } from "./anisotropy";
import { clearcoat, mirrorCoat } from "./clearcoat";
import { coverage } from "./coverage";
import { diffuseTransmission } from "./diffuseTransmission";
import { fresnel } from "./fresnel";
import { ggx } from "./ggx";
import { hasFilm, iridescence } from "./iridescence";
import { lambert } from "./lambert";
import type { Column, Layer, Lobe, MaterialFeatures, MaterialPart } from "./lobe";
import { mirror } from "./mirror";
import { refraction } from "./refraction";
import { roughRefraction } from "./roughRefraction";
import { roughWall } from "./roughWall";
import { sheen } from "./sheen";
import { sides } from "./sides";
import { isSolid, transmission } from "./transmission";

/**
 * By the names that the shader gives them. The first that a scene has is drawn where no other is, or the first that has a density; of
 * those on a layer, those of one direction come last.
 */
const LOBES = {
  ...{ lambert, diffuseTransmission, ggx, roughRefraction, roughWall, mirror, refraction },
  ...{ sheen, clearcoat, mirrorCoat },
} as const satisfies Readonly<Record<string, Lobe>>;

/** What `Bsdf` is made of, and what only the table of materials has. */
const OF_BSDF = { fresnel, anisotropy, iridescence, transmission, ...LOBES } as const satisfies Readonly<
  Record<string, MaterialPart>
>;
const PARTS = { ...OF_BSDF, coverage, sides, absorption, stretch } as const satisfies Readonly<
  Record<string, MaterialPart>
>;

type Parts = typeof PARTS;
type FeatureName = { [P in keyof Parts]: keyof Parts[P]["features"] }[keyof Parts];

const FEATURES = Object.values(PARTS).flatMap(({ features }: MaterialPart) => Object.entries(features));

type NamedColumn = readonly [name: string, column: Column];

/** Conditions of the shader modules' `@if`s. */
export function lobeFeatures(materials: readonly ResolvedMaterial[]) {
  const all = materials.length > 0 ? materials : [BLACK];
  const named = FEATURES.map(([name, { isIn }]) => [name, all.some(isIn)] as const);
  return {
    ...(Object.fromEntries(named) as { readonly [F in FeatureName]: boolean }),
    // Some surface has several lobes.
    LOBES: all.some((material) => lobesOf(material).length > 1),
    // Some reflectance is another than Schlick's.
    EXACT_FRESNEL: all.some((material) => isSolid(material) || hasFilm(material)),
    // Some lobe's directions are those below the surface.
    BELOW: all.some(scattersBelow),
  };
}

/** Whether light gets through a surface, however it is bent or scattered there. */
export function scattersBelow(material: ResolvedMaterial): boolean {
  return lobesOf(material).some(({ isBelow }) => isBelow);
}

function lobesOf(material: ResolvedMaterial): Lobe[] {
  return Object.values<Lobe>(LOBES).filter(({ feature, features }) => features[feature]!.isIn(material));
}

/** What they are called. */
export const LOBE_WORDS = Object.fromEntries(FEATURES.flatMap(([name, { word }]) => (word ? [[name, word]] : []))) as {
  readonly [F in FeatureName]?: string;
};

/** Those of a scene. */
export function lobesIn(features: MaterialFeatures): [name: string, lobe: Lobe][] {
  return Object.entries<Lobe>(LOBES).filter(([, { feature }]) => features[feature]);
}

/** What lies on the surfaces of a scene, from below. */
export function layersIn(features: MaterialFeatures): Layer[] {
  return [...new Set(lobesIn(features).flatMap(([, { layer }]) => layer ?? []))];
}

/** The columns that are members of a scene's `Bsdf`. */
export function bsdfColumns(features: MaterialFeatures): NamedColumn[] {
  return columnsOf(OF_BSDF, features);
}

/** What is derived of them, in order. */
export function derivedIn(features: MaterialFeatures) {
  return Object.values<MaterialPart>(OF_BSDF)
    .flatMap(({ derived = {} }) => Object.entries(derived))
    .filter(([, { when }]) => when(features));
}

/** The columns of a scene's table of materials. */
export function tableColumns(features: MaterialFeatures): NamedColumn[] {
  return columnsOf(PARTS, features);
}

function columnsOf(parts: Readonly<Record<string, MaterialPart>>, features: MaterialFeatures): NamedColumn[] {
  return Object.values(parts)
    .flatMap(({ columns }) => Object.entries(columns))
    .filter(([, { when }]) => when(features));
}

/** A row of those columns. */
export function rowOf(
  material: ResolvedMaterial | "black",
  columns: readonly NamedColumn[],
): Record<string, number | Vec3> {
  return Object.fromEntries(columns.map(([name, { of }]) => [name, of(material === "black" ? BLACK : material)]));
}
