// What a material says of a texture: which it is, and where it lies.

import type * as v from "valibot";
import type { TextureReference, TextureReferenceSchema, Vec3 } from "./schema";

/** With everything that a name leaves out. */
export type WholeReference = v.InferOutput<typeof TextureReferenceSchema>;

export function wholeReference(reference: TextureReference): WholeReference {
  const {
    texture,
    uv = 0,
    offset = [0, 0],
    scale = [1, 1],
    rotation = 0,
  } = typeof reference === "string" ? { texture: reference } : reference;
  return { texture, uv, offset, scale, rotation };
}

/** Whether it says no more than a name: the first texture coordinates, as they are. */
export function isPlain(reference: TextureReference): boolean {
  const { uv, offset, scale, rotation } = wholeReference(reference);
  return uv === 0 && offset[0] === 0 && offset[1] === 0 && scale[0] === 1 && scale[1] === 1 && rotation === 0;
}

/** The rows of the matrix that makes the texture's own coordinates of (u, v, 1): they are scaled, then turned, then moved. */
export function uvRows({ offset, scale, rotation }: WholeReference): readonly [Vec3, Vec3] {
  const angle = (rotation * Math.PI) / 180;
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  // Counter-clockwise where v points down.
  return [
    [cos * scale[0], sin * scale[1], offset[0]],
    [-sin * scale[0], cos * scale[1], offset[1]],
  ];
}
