// Which pictures are halved so that all fit, and how often.

import { MAX_PICTURE_TEXELS, MAX_TEXTURE_SIDE } from "../pictureLimits";

/** A picture, and in how many textures it is. */
export type Sized = { readonly width: number; readonly height: number; readonly copies: number };

/**
 * How often to halve each picture so that the textures have at most so many bytes: the largest first, and no more than needed.
 * Of pictures of one size those that the file has first are halved first.
 */
export function fitPictures(pictures: readonly Sized[], maxBytes: number): number[] {
  const halvings = pictures.map(({ width, height }) =>
    Math.max(0, Math.ceil(Math.log2(Math.max(width, height) / MAX_TEXTURE_SIDE))),
  );
  const texelsOf = (i: number) => {
    const [width, height] = halved(pictures[i]!, halvings[i]!);
    return width * height;
  };
  let bytes = 0;
  for (const [i, { copies }] of pictures.entries()) bytes += 4 * copies * texelsOf(i);
  // A halving takes a picture below the next threshold, so this looks at each at most 28 times.
  for (let threshold = MAX_PICTURE_TEXELS; threshold > 1; threshold /= 2) {
    for (let i = 0; i < pictures.length && bytes > maxBytes; i++) {
      const before = texelsOf(i);
      if (before < threshold) continue;
      halvings[i]!++;
      bytes -= 4 * pictures[i]!.copies * (before - texelsOf(i));
    }
  }
  return halvings;
}

/** Its width and height then. */
export function halved({ width, height }: Omit<Sized, "copies">, halvings: number): readonly [number, number] {
  return [Math.max(1, Math.floor(width / 2 ** halvings)), Math.max(1, Math.floor(height / 2 ** halvings))];
}
