import type { ResolvedMaterial } from "../scene/schema";
import type { Textures } from "../tree/packTexels";
import type { StructValue } from "./defineStruct";
import type { FACTORS, TEXTURE } from "./layouts";
import type { Primitive } from "./primitives";

const NO_TEXTURE = 0xffffffff;

/** Ways to wrap, by their number in `wgsl/textures.wgsl`. */
export const WRAPS = { repeat: 0, mirror: 1, clamp: 2 } as const;

/** The textures, as the shader's table wants them; in the order of their texels. */
export function textureRows(textures: Textures): StructValue<typeof TEXTURE.fields>[] {
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
export function factorRows(primitives: readonly Primitive[], textures: Textures): StructValue<typeof FACTORS.fields>[] {
  const numbers = new Map(Object.keys(textures).map((name, number) => [name, number]));
  const numberOf = (name: string | undefined) => (name === undefined ? NO_TEXTURE : numbers.get(name)!);
  const rowOf = (material: Primitive["material"]) => {
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
  const rows = new Map<Primitive["material"], ReturnType<typeof rowOf>>();
  return primitives.map(({ material }) => {
    const row = rows.get(material) ?? rowOf(material);
    rows.set(material, row);
    return row;
  });
}

const BLACK: Pick<
  ResolvedMaterial,
  "baseColor" | "metallic" | "roughness" | "normalScale" | (`${string}Texture` & keyof ResolvedMaterial)
> = { baseColor: [0, 0, 0], metallic: 0, roughness: 1, normalScale: 1 };

export function hasTextures(textures: Textures): boolean {
  return Object.keys(textures).length > 0;
}
