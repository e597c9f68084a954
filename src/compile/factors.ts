// The table of what textures multiply, a row per primitive: `Factors` in the generated module.

import { TEXTURE_FIELDS, type TextureField } from "../scene/schema";
import { defineStruct, type StructFields, type StructLayout } from "./defineStruct";
import type { Primitive } from "./primitives";

/** The textures of glTF without extensions: each has a column in every table. */
const COMMON = ["baseColorTexture", "metallicRoughnessTexture", "emissionTexture", "normalTexture"] as const;

/** Those whose columns come together. */
const PAIRS: readonly (readonly TextureField[])[] = [["specularTexture", "specularColorTexture"]];

/** The other textures that some primitive has, in order. */
export function rareTextures(primitives: readonly Primitive[]): readonly TextureField[] {
  const used = new Set<TextureField>();
  for (const material of new Set(primitives.map(({ material }) => material))) {
    if (material === "black") continue;
    for (const field of TEXTURE_FIELDS) if (material[field] !== undefined) used.add(field);
  }
  for (const pair of PAIRS) if (pair.some((field) => used.has(field))) for (const field of pair) used.add(field);
  return TEXTURE_FIELDS.filter((field) => used.has(field) && !(COMMON as readonly TextureField[]).includes(field));
}

/** What a primitive's textures multiply, and which they are. */
export function factorsLayout(rare: readonly TextureField[]): StructLayout<StructFields> {
  return defineStruct({
    baseColor: "vec3f",
    metallic: "f32",
    roughness: "f32",
    normalScale: "f32",
    ...Object.fromEntries([...COMMON, ...rare].map((field) => [field, "u32" as const])),
  });
}
