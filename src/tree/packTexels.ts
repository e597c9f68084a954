import type { ResolvedScene, ResolvedTexture } from "../scene/schema";

/** Pictures by name. */
export type Textures = ResolvedScene["textures"];

/** The texels of all pictures, as they are; undefined if there are none. One after the other they are what the shader reads. */
export function texelParts(textures: Textures): readonly Uint8Array[] | undefined {
  const parts = Object.values(textures).map(({ texels }) => texels);
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
