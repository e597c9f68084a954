import { RtViewerError } from "../errors";
import type { DecodedImage } from "./loadedScene";

/**
 * Decodes a picture as the browser can, to the values in the file: no colour management, and colours stay where alpha is 0.
 *
 * That is why the texels go through WebGL: a 2D canvas multiplies them by alpha.
 *
 * @throws {RtViewerError} if the browser can't.
 */
export async function decodeInPage(bytes: Uint8Array, mimeType: string): Promise<DecodedImage> {
  if (globalThis.createImageBitmap === undefined || globalThis.OffscreenCanvas === undefined) {
    throw new RtViewerError(
      "there is no decoder for pictures outside of a browser; give one in the option decodeImage",
    );
  }
  const blob = new Blob([bytes as Uint8Array<ArrayBuffer>], { type: mimeType });
  const bitmap = await createImageBitmap(blob, { colorSpaceConversion: "none", premultiplyAlpha: "none" });
  try {
    const { width, height } = bitmap;
    return { width, height, texels: readTexels(bitmap) };
  } finally {
    bitmap.close();
  }
}

function readTexels(bitmap: ImageBitmap): Uint8Array {
  const { width, height } = bitmap;
  const gl = new OffscreenCanvas(1, 1).getContext("webgl2");
  if (gl === null) throw new RtViewerError("WebGL, which reads pictures, is not available");
  try {
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
    gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, bitmap);
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    if (gl.getError() !== gl.NO_ERROR) throw new RtViewerError(`WebGL can't hold ${width} × ${height} texels`);
    const texels = new Uint8Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, texels);
    return texels;
  } finally {
    gl.getExtension("WEBGL_lose_context")?.loseContext();
  }
}
