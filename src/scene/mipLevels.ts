// Mip levels: every picture at half its size, at a quarter and so on, for look-ups from afar.

import { COLOR_TEXTURES } from "./names";
import type { ResolvedMaterial, ResolvedTexture } from "./schema";
import { shrinkPicture } from "./shrinkPicture";
import { wholeReference } from "./textureReference";

/** Width and height of every level, the picture itself first. Each has half of the one before, rounded down, down to one texel. */
export function levelSizes(width: number, height: number): (readonly [number, number])[] {
  const sizes: (readonly [number, number])[] = [[width, height]];
  for (let [w, h] = [width, height]; w > 1 || h > 1; ) {
    [w, h] = [Math.max(w >> 1, 1), Math.max(h >> 1, 1)];
    sizes.push([w, h]);
  }
  return sizes;
}

/** Texels of all levels. */
export function texelsOfLevels(width: number, height: number): number {
  let sum = width * height;
  for (let [w, h] = [width, height]; w > 1 || h > 1; sum += w * h) {
    w = Math.max(w >> 1, 1);
    h = Math.max(h >> 1, 1);
  }
  return sum;
}

/**
 * The texels of every level but the picture itself: of each texel the mean of the rectangle of the level before that it covers. Made
 * in slices, a task each.
 *
 * Means of normals are shorter than one where normals differ, as those between texels are: the shader takes their directions. Alpha
 * is data: whether a ray meets a surface is always decided by the picture itself.
 *
 * @param isColor - see `shrinkPicture`.
 * @throws the reason of `signal`.
 */
export async function lesserLevels(
  picture: Pick<ResolvedTexture, "width" | "height" | "texels">,
  isColor: boolean,
  signal: AbortSignal | undefined,
): Promise<Uint8Array[]> {
  const levels: Uint8Array[] = [];
  let last = picture;
  for (const size of levelSizes(picture.width, picture.height).slice(1)) {
    last = await shrinkPicture(last, size, isColor, signal);
    levels.push(last.texels);
  }
  return levels;
}

/** The names of textures that some material reads as colours. What is also read as data is averaged as a colour all the same. */
export function colorTexturesOf(materials: Readonly<Record<string, ResolvedMaterial>>): ReadonlySet<string> {
  const names = new Set<string>();
  for (const material of Object.values(materials)) {
    for (const field of COLOR_TEXTURES) {
      if (material[field] !== undefined) names.add(wholeReference(material[field]).texture);
    }
  }
  return names;
}
