// KHR_materials_variants: looks of one model, each with materials of its own.

import { missingVariant } from "../missingVariant";
import type { Warnings } from "../warnings";
import type { GltfJson } from "./schema";

/** The names of the variants, in the order of the file. */
export function variantNames({ extensions }: GltfJson): string[] {
  return extensions?.KHR_materials_variants?.variants.map(({ name }) => name) ?? [];
}

/**
 * The file with the materials of one variant. A name that it does not have changes nothing, with a warning.
 *
 * @param wanted - a name; `undefined` for the materials without any variant.
 */
export function applyVariant(json: GltfJson, wanted: string | undefined, warnings: Warnings): GltfJson {
  if (wanted === undefined) return json;
  const names = variantNames(json);
  const variant = names.indexOf(wanted);
  if (variant < 0) {
    warnings.add(missingVariant("The file", wanted, names));
    return json;
  }
  const meshes = json.meshes.map((mesh) => ({
    ...mesh,
    primitives: mesh.primitives.map((primitive) => {
      const mappings = primitive.extensions?.KHR_materials_variants?.mappings;
      const mapping = mappings?.find(({ variants }) => variants.includes(variant));
      return mapping === undefined ? primitive : { ...primitive, material: mapping.material };
    }),
  }));
  return { ...json, meshes };
}
