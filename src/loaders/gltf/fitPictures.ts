// Which pictures are halved so that all fit, and how often.

import { texelsOfLevels } from "../../scene/mipLevels";
import { MAX_PICTURE_TEXELS, MAX_TEXTURE_SIDE } from "../pictureLimits";

/** A picture, and in how many textures it is. */
export type Sized = { readonly width: number; readonly height: number; readonly copies: number };

/**
 * How often to halve each picture so that the textures, with their mip levels, have at most so many bytes: the largest first, and
 * no more than needed. Of pictures of one size those that the file has first are halved first.
 */
export function fitPictures(pictures: readonly Sized[], maxBytes: number): number[] {
  const halvings = pictures.map(({ width, height }) =>
    Math.max(0, Math.ceil(Math.log2(Math.max(width, height) / MAX_TEXTURE_SIDE))),
  );
  const sizes = pictures.map((picture, i) => sizeOf(picture, halvings[i]!));
  let bytes = 0;
  for (const size of sizes) bytes += size.bytes;
  // A halving takes a picture below the next threshold, so this looks at each at most 28 times.
  for (let threshold = MAX_PICTURE_TEXELS; threshold > 1; threshold /= 2) {
    for (let i = 0; i < pictures.length && bytes > maxBytes; i++) {
      const before = sizes[i]!;
      if (before.texels < threshold) continue;
      sizes[i] = sizeOf(pictures[i]!, ++halvings[i]!);
      bytes -= before.bytes - sizes[i]!.bytes;
    }
  }
  return halvings;
}

/** Of a picture that was halved so often: its texels, and all bytes of it. */
function sizeOf(picture: Sized, halvings: number) {
  const [width, height] = halved(picture, halvings);
  return { texels: width * height, bytes: 4 * picture.copies * texelsOfLevels(width, height) };
}

/** Its width and height then. */
export function halved({ width, height }: Omit<Sized, "copies">, halvings: number): readonly [number, number] {
  return [Math.max(1, Math.floor(width / 2 ** halvings)), Math.max(1, Math.floor(height / 2 ** halvings))];
}
