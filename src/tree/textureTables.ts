import { type ResolvedMaterial, TEXTURE_FIELDS, type TextureField, type TextureReference } from "../scene/schema";
import { BLACK } from "../scene/shown";
import { uvRows, type WholeReference, wholeReference } from "../scene/textureReference";
import type { Textures } from "./packTexels";

const NO_TEXTURE = 0xffffffff;

/** Ways to wrap, by their number in `wgsl/textures.wgsl`. */
export const WRAPS = { repeat: 0, mirror: 1, clamp: 2 } as const;

/** A material, or `"black"`: the body of a light. */
type Surface = ResolvedMaterial | "black";

/**
 * What the shader looks up of textures: `factors` by primitive, and `textures` by number, one for each texture in each of its places.
 *
 * @param materials - by primitive.
 */
export function textureTables(textures: Textures, materials: readonly Surface[]) {
  const references = referencesIn(textures, materials);
  const numbers = new Map([...references.keys()].map((key, number) => [key, number]));
  return { factors: factorRows(numbers, materials), textures: textureRows(textures, [...references.values()]) };
}

/** Every texture as it is, in the order of their texels; then those that lie elsewhere, each place once. */
function referencesIn(textures: Textures, materials: readonly Surface[]): ReadonlyMap<string, WholeReference> {
  const references = new Map<string, WholeReference>();
  const add = (reference: WholeReference) => references.set(keyOf(reference), reference);
  for (const texture of Object.keys(textures)) add(wholeReference(texture));
  for (const material of new Set(materials)) {
    if (material === "black") continue;
    for (const field of TEXTURE_FIELDS) if (material[field] !== undefined) add(wholeReference(material[field]));
  }
  return references;
}

function keyOf({ texture, uv, offset, scale, rotation }: WholeReference): string {
  return JSON.stringify([texture, uv, offset, scale, rotation]);
}

/** Textures in their places, as the shader's table wants them. */
function textureRows(textures: Textures, references: readonly WholeReference[]) {
  const firsts = new Map<string, number>();
  let next = 0;
  for (const [name, { width, height }] of Object.entries(textures)) {
    firsts.set(name, next);
    next += width * height;
  }
  return references.map((reference) => {
    const { width, height, wrapU, wrapV, filter } = textures[reference.texture]!;
    const [toU, toV] = uvRows(reference);
    return {
      place: [width, height, firsts.get(reference.texture)!],
      wrapU: WRAPS[wrapU],
      wrapV: WRAPS[wrapV],
      nearest: filter === "nearest" ? 1 : 0,
      uv: reference.uv,
      toU,
      toV,
    };
  });
}

/** What textures multiply, by primitive. Primitives of one material share a row. */
function factorRows(numbers: ReadonlyMap<string, number>, materials: readonly Surface[]) {
  const numberOf = (reference: TextureReference | undefined) =>
    reference === undefined ? NO_TEXTURE : numbers.get(keyOf(wholeReference(reference)))!;
  const rowOf = (material: Surface) => {
    const shown = material === "black" ? BLACK : material;
    const { baseColor, metallic, roughness, normalScale } = shown;
    const numbered = TEXTURE_FIELDS.map((field) => [field, numberOf(shown[field])] as const);
    return {
      baseColor,
      metallic,
      roughness,
      normalScale,
      ...(Object.fromEntries(numbered) as Record<TextureField, number>),
    };
  };
  const rows = new Map<Surface, ReturnType<typeof rowOf>>();
  return materials.map((material) => {
    const row = rows.get(material) ?? rowOf(material);
    rows.set(material, row);
    return row;
  });
}
