import type { ResolvedTexture } from "../scene/schema";
import type { Textures } from "./packTextures";

/** All texels one after the other; undefined if there are none. */
export function packTexels(textures: Textures): ArrayBuffer | undefined {
  const all = Object.values(textures);
  if (all.length === 0) return undefined;
  const bytes = new Uint8Array(all.reduce((sum, { texels }) => sum + texels.length, 0));
  let at = 0;
  for (const { texels } of all) {
    bytes.set(texels, at);
    at += texels.length;
  }
  return bytes.buffer;
}

/** Whether two dictionaries hold the same pictures. */
export function haveSameTexels(a: Textures, b: Textures): boolean {
  const [names, others] = [Object.keys(a), Object.keys(b)];
  return (
    names.length === others.length && names.every((name, i) => name === others[i] && isSamePicture(a[name]!, b[name]!))
  );
}

function isSamePicture(a: ResolvedTexture, b: ResolvedTexture): boolean {
  return (
    a.texels === b.texels ||
    (a.texels.length === b.texels.length && a.texels.every((value, i) => value === b.texels[i]))
  );
}
