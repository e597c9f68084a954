import { RtViewerError } from "../errors";
import { encodePfm } from "../renderer/encodePfm";

/**
 * Puts a picture into a file: radiance as a Portable FloatMap, sRGB bytes as what the browser's canvas encodes.
 *
 * @param pixels - RGBA, top row first.
 * @param type - of the file; for radiance it is only its name.
 * @param quality - 0…1, for types that have one.
 * @throws {RtViewerError} if the browser cannot encode so large a picture.
 */
export async function encodePicture(
  pixels: Float32Array | Uint8ClampedArray,
  width: number,
  height: number,
  type: string,
  quality?: number,
): Promise<Blob> {
  if (pixels instanceof Float32Array) {
    return new Blob([encodePfm(pixels, width, height) as Uint8Array<ArrayBuffer>], { type });
  }
  try {
    const canvas = new OffscreenCanvas(width, height);
    const image = new ImageData(pixels as Uint8ClampedArray<ArrayBuffer>, width, height);
    canvas.getContext("2d")!.putImageData(image, 0, 0);
    return await canvas.convertToBlob({ type, ...(quality !== undefined && { quality }) });
  } catch (cause) {
    throw new RtViewerError(`the browser could not encode ${width} × ${height} pixels as ${type}`, { cause });
  }
}
