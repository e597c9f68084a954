import type { ResolvedMaterial } from "../scene/schema";
import type { Textures } from "./packTexels";

const NO_TEXTURE = 0xffffffff;

/** Ways to wrap, by their number in `wgsl/textures.wgsl`. */
export const WRAPS = { repeat: 0, mirror: 1, clamp: 2 } as const;

/** A material, or `"black"`: the body of a light. */
type Surface = ResolvedMaterial | "black";

/**
 * What the shader looks up of textures: `factors` by primitive, and `textures` by number.
 *
 * @param materials - by primitive.
 */
export function textureTables(textures: Textures, materials: readonly Surface[]) {
  return { factors: factorRows(textures, materials), textures: textureRows(textures) };
}

/** The textures, as the shader's table wants them; in the order of their texels. */
function textureRows(textures: Textures) {
  let next = 0;
  return Object.values(textures).map(({ width, height, wrapU, wrapV, filter }) => {
    const first = next;
    next += width * height;
    return {
      place: [width, height, first],
      wrapU: WRAPS[wrapU],
      wrapV: WRAPS[wrapV],
      nearest: filter === "nearest" ? 1 : 0,
    };
  });
}

/** What textures multiply, by primitive. Primitives of one material share a row. */
function factorRows(textures: Textures, materials: readonly Surface[]) {
  const numbers = new Map(Object.keys(textures).map((name, number) => [name, number]));
  const numberOf = (name: string | undefined) => (name === undefined ? NO_TEXTURE : numbers.get(name)!);
  const rowOf = (material: Surface) => {
    const { baseColor, metallic, roughness, normalScale, ...names } = material === "black" ? BLACK : material;
    return {
      baseColor,
      metallic,
      roughness,
      normalScale,
      baseColorTexture: numberOf(names.baseColorTexture),
      metallicRoughnessTexture: numberOf(names.metallicRoughnessTexture),
      emissionTexture: numberOf(names.emissionTexture),
      normalTexture: numberOf(names.normalTexture),
    };
  };
  const rows = new Map<Surface, ReturnType<typeof rowOf>>();
  return materials.map((material) => {
    const row = rows.get(material) ?? rowOf(material);
    rows.set(material, row);
    return row;
  });
}

const BLACK: Pick<
  ResolvedMaterial,
  "baseColor" | "metallic" | "roughness" | "normalScale" | (`${string}Texture` & keyof ResolvedMaterial)
> = { baseColor: [0, 0, 0], metallic: 0, roughness: 1, normalScale: 1 };
