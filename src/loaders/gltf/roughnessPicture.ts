import { nextTask } from "../../nextTask";
import { keep } from "../../scene/keptBytes";
import type { DecodedImage } from "../loadedScene";

/** Texels that are written in one task: they take a few milliseconds. */
const SLICE_TEXELS = 2 ** 20;
const OPAQUE = Uint8Array.of(255, 255, 255, 255);

/**
 * A picture with roughness in its green, as `metallicRoughnessTexture` has it, of one with glossiness in its alpha:
 * 1 − `glossiness` · alpha. Where that is the same everywhere it is a single texel.
 *
 * @param image - one that could not be read, `undefined`, counts as white.
 */
export async function roughnessPicture(
  image: DecodedImage | undefined,
  glossiness: number,
  signal: AbortSignal | undefined,
): Promise<DecodedImage> {
  const { width, height, texels } = image === undefined || hasOneAlpha(image) ? firstTexel(image) : image;
  const roughness = Uint8Array.from({ length: 256 }, (_, alpha) => Math.round(255 - glossiness * alpha));
  const made = new Uint8Array(texels.length).fill(255);
  for (let i = 0; i < made.length; i += 4) {
    if (i > 0 && i % (4 * SLICE_TEXELS) === 0) {
      await nextTask();
      signal?.throwIfAborted();
    }
    made[i + 1] = roughness[texels[i + 3]!]!;
  }
  return { width, height, texels: keep(made) };
}

function hasOneAlpha({ texels }: DecodedImage): boolean {
  for (let i = 3; i < texels.length; i += 4) if (texels[i] !== texels[3]) return false;
  return true;
}

function firstTexel(image: DecodedImage | undefined): DecodedImage {
  return { width: 1, height: 1, texels: image?.texels.subarray(0, 4) ?? OPAQUE };
}
