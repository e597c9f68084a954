// Whether what objects and materials refer to by name is there.

import type { AddFieldIssue } from "./containers";
import { show } from "./describe";
import type { ResolvedMaterial, ResolvedObject, ResolvedTexture } from "./schema";

/** The fields of a material that name a texture. */
export const TEXTURE_FIELDS = [
  "baseColorTexture",
  "metallicRoughnessTexture",
  "emissionTexture",
  "normalTexture",
  "transmissionTexture",
  "diffuseTransmissionTexture",
  "diffuseTransmissionColorTexture",
  "specularTexture",
  "specularColorTexture",
  "clearcoatTexture",
  "clearcoatRoughnessTexture",
  "clearcoatNormalTexture",
  "sheenColorTexture",
  "sheenRoughnessTexture",
  "anisotropyTexture",
  "iridescenceTexture",
  "iridescenceThicknessTexture",
] as const;
export type TextureField = (typeof TEXTURE_FIELDS)[number];

// More names than this make a list that nobody reads.
const MAX_LISTED_NAMES = 8;

/** What of a scene is sound: `undefined` is at fault, and has been reported. */
type Parts = {
  readonly objects?: readonly (Sound<ResolvedObject> | undefined)[] | undefined;
  readonly materials?: Readonly<Record<string, Sound<ResolvedMaterial> | undefined>> | undefined;
  readonly textures?: Readonly<Record<string, ResolvedTexture | undefined>> | undefined;
};
type Sound<T> = T extends unknown ? { readonly [K in keyof T]: T[K] | undefined } : never;

/** Reports every name of a material or a texture that is not there, and textures where they cannot show. */
export function checkNames(
  { objects = [], materials, textures }: Parts,
  addIssue: AddFieldIssue<"objects" | "materials">,
): void {
  if (materials === undefined) return;
  const textured = new Set(Object.keys(materials).filter((name) => hasTexture(materials[name])));
  const unknownMaterial = unknownName("material", Object.keys(materials));
  const needs = new Map([...textured].map((name) => [name, setsOf(materials[name]!)]));
  for (const [i, object] of objects.entries()) {
    const name = object?.material;
    if (object === undefined || name === undefined) continue;
    if (!Object.hasOwn(materials, name)) addIssue(["objects", i, "material"], unknownMaterial(name));
    else {
      for (const [set, field] of needs.get(name) ?? []) {
        const list = set === 1 ? "uvs1" : "uvs";
        if (list in object) continue;
        const which = set === 1 ? `${field} with uv 1, which shows` : "textures, which show";
        addIssue(["objects", i, "material"], `${show(name)} has ${which} on meshes with ${list} only`);
      }
    }
  }

  if (textures === undefined) return;
  const unknownTexture = unknownName("texture", Object.keys(textures));
  for (const material of textured) {
    for (const field of TEXTURE_FIELDS) {
      const reference = materials[material]?.[field];
      const { texture } = partsOf(reference);
      if (texture === undefined || Object.hasOwn(textures, texture)) continue;
      const path = typeof reference === "string" ? [field] : [field, "texture"];
      addIssue(["materials", material, ...path], unknownTexture(texture));
    }
  }
}

function hasTexture(material: Sound<ResolvedMaterial> | undefined): boolean {
  return material !== undefined && TEXTURE_FIELDS.some((field) => field in material);
}

/** The sets of texture coordinates that a material's textures ask for, each with the first field that does. */
function setsOf(material: Sound<ResolvedMaterial>): ReadonlyMap<0 | 1, TextureField> {
  const sets = new Map<0 | 1, TextureField>();
  for (const field of TEXTURE_FIELDS) {
    const { uv } = partsOf(material[field]);
    if (uv !== undefined && !sets.has(uv)) sets.set(uv, field);
  }
  return sets;
}

/** What is sound of a reference to a texture. */
function partsOf(reference: ResolvedMaterial[TextureField]): { texture?: string | undefined; uv?: 0 | 1 | undefined } {
  return typeof reference === "string" ? { texture: reference, uv: 0 } : (reference ?? {});
}

/** Says that a name is not among these. They are looked through once: there can be a million, and as many who miss one. */
function unknownName(kind: string, names: readonly string[]): (name: string) => string {
  const listed = names.slice(0, MAX_LISTED_NAMES).map((known) => show(known));
  if (names.length > MAX_LISTED_NAMES) listed.push(`${names.length - MAX_LISTED_NAMES} more`);
  const choice = names.length === 0 ? `the scene has no ${kind}s` : `there are ${listed.join(", ")}`;
  return (name) => `no ${kind} is named ${show(name)}; ${choice}`;
}
