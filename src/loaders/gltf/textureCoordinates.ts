// Which texture coordinates a texture asks for. A mesh of ours has one set, so the textures of a material have to agree.

/** The number of a set in the file, and what KHR_texture_transform does to it. */
export type CoordinateSource = {
  readonly set: number;
  readonly offset: readonly [number, number];
  readonly rotation: number;
  readonly scale: readonly [number, number];
};

type TextureInfo = {
  readonly texCoord?: number | undefined;
  readonly extensions?:
    | {
        readonly KHR_texture_transform?:
          | (Partial<{ readonly [K in keyof CoordinateSource]: CoordinateSource[K] | undefined }> & {
              readonly texCoord?: number | undefined;
            })
          | undefined;
      }
    | undefined;
};

export function coordinateSource({ texCoord = 0, extensions }: TextureInfo): CoordinateSource {
  const transform = extensions?.KHR_texture_transform ?? {};
  const { offset = [0, 0], rotation = 0, scale = [1, 1], texCoord: override = texCoord } = transform;
  return { set: override, offset, rotation, scale };
}

export function isSameSource(a: CoordinateSource, b: CoordinateSource): boolean {
  return JSON.stringify(a) === JSON.stringify(b);
}

/**
 * Texture coordinates with the transform applied: scaled, then turned counter-clockwise (v points down), then moved.
 *
 * @returns `uvs` itself where there is no transform.
 */
export function transformUvs(uvs: Float32Array, { offset, rotation, scale }: CoordinateSource): Float32Array {
  if (rotation === 0 && offset[0] === 0 && offset[1] === 0 && scale[0] === 1 && scale[1] === 1) return uvs;
  const [cos, sin] = [Math.cos(rotation), Math.sin(rotation)];
  const out = new Float32Array(uvs.length);
  for (let i = 0; i < out.length; i += 2) {
    const u = uvs[i]! * scale[0];
    const v = uvs[i + 1]! * scale[1];
    out[i] = cos * u + sin * v + offset[0];
    out[i + 1] = cos * v - sin * u + offset[1];
  }
  return out;
}
