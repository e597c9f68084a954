import type { View } from "../renderer/display";
import type { PathTracer } from "../renderer/pathTracer";
import { encodePfm } from "../renderer/pfm";

/** The type of a Portable FloatMap. */
export const PFM_TYPE = "image/x-portable-floatmap";

/**
 * Puts what has been sampled into a file.
 *
 * @param type - an image type that the browser's canvas encodes, with tone mapping, 8 bits and sRGB; or `PFM_TYPE`: linear
 * float, as sampled.
 * @param quality - 0…1, for types that have one.
 */
export async function encodePicture(tracer: PathTracer, view: View, type: string, quality?: number): Promise<Blob> {
  const { width, height } = tracer;
  if (type === PFM_TYPE) {
    const bytes = encodePfm(await tracer.readRadiance(), width, height);
    return new Blob([bytes as Uint8Array<ArrayBuffer>], { type });
  }
  const pixels = (await tracer.readPicture(view)) as Uint8ClampedArray<ArrayBuffer>;
  const canvas = new OffscreenCanvas(width, height);
  canvas.getContext("2d")!.putImageData(new ImageData(pixels, width, height), 0, 0);
  return canvas.convertToBlob({ type, ...(quality !== undefined && { quality }) });
}
