// Where a texture of a file lies: KHR_texture_transform in the scene format's words.

import type { TextureReference } from "../../scene/schema";
import { isPlain } from "../../scene/textureReference";

type Transform = {
  readonly offset?: readonly [number, number] | undefined;
  readonly rotation?: number | undefined;
  readonly scale?: readonly [number, number] | undefined;
  readonly texCoord?: number | undefined;
};
type TextureInfo = {
  readonly texCoord?: number | undefined;
  readonly extensions?: { readonly KHR_texture_transform?: Transform | undefined } | undefined;
};

/** The number, in the file, of the texture coordinates that a texture asks for. */
export function coordinateSet({ texCoord = 0, extensions }: TextureInfo): number {
  return extensions?.KHR_texture_transform?.texCoord ?? texCoord;
}

/**
 * A texture in its place; its name alone where that says it all.
 *
 * @param uv - which of the mesh's sets it asks for.
 */
export function placedTexture(texture: string, uv: 0 | 1, { extensions }: TextureInfo): TextureReference {
  const { offset, scale, rotation } = extensions?.KHR_texture_transform ?? {};
  const placed = {
    texture,
    ...(uv === 1 && { uv }),
    ...(offset && { offset }),
    ...(scale && { scale }),
    ...(rotation && { rotation: toDegrees(rotation) }),
  };
  return isPlain(placed) ? texture : placed;
}

/** Of an angle in radians, which may be many turns: the scene format has bounds. */
export function toDegrees(radians: number): number {
  return ((radians % (2 * Math.PI)) * 180) / Math.PI;
}
