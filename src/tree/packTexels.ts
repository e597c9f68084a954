import { lesserLevels } from "../scene/mipLevels";
import type { ResolvedScene, ResolvedTexture } from "../scene/schema";

/** Pictures by name. */
export type Textures = ResolvedScene["textures"];

/**
 * The texels of all pictures, of each all mip levels; undefined if there are none. One after the other they are what the shader reads.
 *
 * @param colors - names of those that are colours.
 * @throws the reason of `signal`.
 */
export async function texelParts(
  textures: Textures,
  colors: ReadonlySet<string>,
  signal: AbortSignal | undefined,
): Promise<readonly Uint8Array[] | undefined> {
  const parts: Uint8Array[] = [];
  for (const [name, texture] of Object.entries(textures)) {
    parts.push(texture.texels, ...(await lesserLevels(texture, colors.has(name), signal)));
  }
  return parts.length === 0 ? undefined : parts;
}

/** Whether two dictionaries hold the same pictures. */
export function haveSameTexels(a: Textures, b: Textures): boolean {
  const [names, others] = [Object.keys(a), Object.keys(b)];
  return (
    names.length === others.length && names.every((name, i) => name === others[i] && isSamePicture(a[name]!, b[name]!))
  );
}

function isSamePicture({ texels: a }: ResolvedTexture, { texels: b }: ResolvedTexture): boolean {
  if (a === b) return true;
  if (a.length !== b.length) return false;
  const [words, others] = [wordsOf(a), wordsOf(b)];
  for (let i = 0; i < words.length; i++) if (words[i] !== others[i]) return false;
  return true;
}

/** Texels as numbers, four bytes each: a picture can be a quarter of a gigabyte. */
function wordsOf(texels: Uint8Array): Uint32Array {
  const { buffer, byteOffset, length } = texels.byteOffset % 4 === 0 ? texels : texels.slice();
  return new Uint32Array(buffer, byteOffset, length / 4);
}
