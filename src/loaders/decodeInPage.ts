import { RtViewerError } from "../errors";
import { nextTask } from "../nextTask";
import { keep } from "../scene/keptBytes";
import type { DecodedImage } from "./loadedScene";

/** Texels that are read in one task: 2 MiB take 5 to 20 ms on a software adapter, most of them for the first time. */
const SLICE_TEXELS = 2 ** 19;

/**
 * Decodes a picture as the browser can, to the values in the file: no colour management, and colours stay where alpha is 0.
 *
 * That is why the texels go through WebGL: a 2D canvas multiplies them by alpha. The browser decodes in a thread of its own, and
 * the texels are read in slices, so that the page stays responsive.
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
    return { width, height, texels: keep(await readTexels(bitmap)) };
  } finally {
    bitmap.close();
  }
}

async function readTexels(bitmap: ImageBitmap): Promise<Uint8Array> {
  const { width, height } = bitmap;
  await nextTask(); // the browser has used its time for handing over the bitmap
  const gl = new OffscreenCanvas(1, 1).getContext("webgl2");
  if (gl === null) throw new RtViewerError("WebGL, which reads pictures, is not available");
  try {
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
    gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, gl.createBuffer());
    const texels = new Uint8Array(4 * width * height);
    const sliceRows = Math.max(1, Math.floor(SLICE_TEXELS / width));
    for (let row = 0; row < height; row += sliceRows) {
      await nextTask();
      const rows = Math.min(sliceRows, height - row);
      const bytes = 4 * width * rows;
      gl.pixelStorei(gl.UNPACK_SKIP_ROWS, row);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, width, rows, 0, gl.RGBA, gl.UNSIGNED_BYTE, bitmap);
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
      gl.bufferData(gl.PIXEL_PACK_BUFFER, bytes, gl.STREAM_READ);
      gl.readPixels(0, 0, width, rows, gl.RGBA, gl.UNSIGNED_BYTE, 0);
      if (gl.getError() !== gl.NO_ERROR) throw new RtViewerError(`WebGL can't hold ${width} texels in a row`);
      await isDone(gl);
      gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 0, texels, 4 * width * row, bytes);
    }
    return texels;
  } finally {
    gl.getExtension("WEBGL_lose_context")?.loseContext();
  }
}

/** Resolves when the GPU has done what it was given. To read at once would block the page until then. */
async function isDone(gl: WebGL2RenderingContext): Promise<void> {
  const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  if (fence === null) throw new RtViewerError("WebGL, which reads pictures, was lost");
  gl.flush();
  while (gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED) {
    await nextTask();
    if (gl.isContextLost()) throw new RtViewerError("WebGL, which reads pictures, was lost");
  }
  gl.deleteSync(fence);
}
