import { LoadError, RtViewerError } from "../errors";
import { nextTask } from "../nextTask";
import { keep } from "../scene/keptBytes";
import { readHeader } from "./gltf/imageFile";
import type { DecodedImage } from "./loadedScene";
import { withoutExif } from "./withoutExif";

/** Texels that are read in one task: 2 MiB take 5 to 20 ms on a software adapter, most of them for the first time. */
const SLICE_TEXELS = 2 ** 19;

/** Texels that the browser hands over in one task: 32 MiB take it 30 ms. */
const MAX_BITMAP_TEXELS = 2 ** 23;
const AS_STORED = { colorSpaceConversion: "none", premultiplyAlpha: "none", imageOrientation: "none" } as const;

/** @throws {LoadError} outside of a browser, where `decodeInPage` can decode nothing. */
export function checkPageDecodes(): void {
  if (globalThis.createImageBitmap !== undefined && globalThis.OffscreenCanvas !== undefined) return;
  throw new LoadError(
    "has pictures, for which there is no decoder outside of a browser; give one in the option decodeImage",
  );
}

/**
 * Decodes a picture as the browser can, to the values in the file: no colour management, colours stay where alpha is 0, and what
 * Exif metadata says of the orientation is not followed.
 *
 * That is why the texels go through WebGL: a 2D canvas multiplies them by alpha. The browser decodes in a thread of its own, and
 * the texels are read in slices, so that the page stays responsive.
 *
 * @throws {RtViewerError} if the browser can't.
 */
export async function decodeInPage(bytes: Uint8Array, mimeType: string): Promise<DecodedImage> {
  const blob = new Blob(withoutExif(bytes as Uint8Array<ArrayBuffer>, mimeType), { type: mimeType });
  const { width, height } = await readHeader(bytes);
  // What an AVIF's header says may be turned.
  if (width * height <= MAX_BITMAP_TEXELS || mimeType === "image/avif") {
    const bitmap = await createImageBitmap(blob, AS_STORED);
    const size = { width: bitmap.width, height: bitmap.height };
    const texels = new Uint8Array(4 * size.width * size.height);
    await readTexels([bitmap], texels);
    return { ...size, texels: keep(texels) };
  }
  const texels = new Uint8Array(4 * width * height);
  await readTexels(stripsOf(blob, width, height), texels);
  return { width, height, texels: keep(texels) };
}

/** Decodes a large picture again for each strip: to hand over all of it would block the page. */
async function* stripsOf(blob: Blob, width: number, height: number): AsyncGenerator<ImageBitmap> {
  const stripRows = Math.max(1, Math.floor(MAX_BITMAP_TEXELS / width));
  for (let row = 0; row < height; row += stripRows) {
    yield createImageBitmap(blob, 0, row, width, Math.min(stripRows, height - row), AS_STORED);
  }
}

/** Writes the texels of bitmaps that lie one above the other, and closes them. */
async function readTexels(
  bitmaps: AsyncIterable<ImageBitmap> | Iterable<ImageBitmap>,
  texels: Uint8Array,
): Promise<void> {
  let gl: WebGL2RenderingContext | undefined;
  let start = 0;
  try {
    for await (const bitmap of bitmaps) {
      try {
        await nextTask(); // the browser has used its time for handing over the bitmap
        gl ??= openReader();
        await readBitmap(gl, bitmap, texels.subarray(start));
        start += 4 * bitmap.width * bitmap.height;
      } finally {
        bitmap.close();
      }
    }
  } finally {
    gl?.getExtension("WEBGL_lose_context")?.loseContext();
  }
}

function openReader(): WebGL2RenderingContext {
  const gl = new OffscreenCanvas(1, 1).getContext("webgl2");
  if (gl === null) throw new RtViewerError("WebGL, which reads pictures, is not available");
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
  gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
  gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  gl.bindBuffer(gl.PIXEL_PACK_BUFFER, gl.createBuffer());
  return gl;
}

async function readBitmap(gl: WebGL2RenderingContext, bitmap: ImageBitmap, texels: Uint8Array): Promise<void> {
  const { width, height } = bitmap;
  for (const { x, y, columns, rows } of slicesOf(width, height, gl.getParameter(gl.MAX_TEXTURE_SIZE))) {
    await nextTask();
    const bytes = 4 * columns * rows;
    // Given the whole with UNPACK_SKIP_ROWS, Chromium copies all of it each time.
    const slice = await createImageBitmap(bitmap, x, y, columns, rows, AS_STORED);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, columns, rows, 0, gl.RGBA, gl.UNSIGNED_BYTE, slice);
    slice.close();
    gl.bufferData(gl.PIXEL_PACK_BUFFER, bytes, gl.STREAM_READ);
    gl.readPixels(0, 0, columns, rows, gl.RGBA, gl.UNSIGNED_BYTE, 0);
    const error = gl.getError();
    if (error !== gl.NO_ERROR) throw new RtViewerError(`WebGL, which reads pictures, reports error ${error}`);
    await isDone(gl);
    if (columns === width) gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 0, texels, 4 * width * y, bytes);
    else {
      for (let row = 0; row < rows; row++) {
        const to = 4 * (width * (y + row) + x);
        gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 4 * columns * row, texels, to, 4 * columns);
      }
    }
  }
}

type Slice = { readonly x: number; readonly y: number; readonly columns: number; readonly rows: number };

/** As many rows as fit a task; of a picture that is wider than a texture can be, a part of them. */
function* slicesOf(width: number, height: number, maxColumns: number): Generator<Slice> {
  const sliceRows = Math.max(1, Math.floor(SLICE_TEXELS / Math.min(width, maxColumns)));
  for (let x = 0; x < width; x += maxColumns) {
    const columns = Math.min(maxColumns, width - x);
    for (let y = 0; y < height; y += sliceRows) yield { x, y, columns, rows: Math.min(sliceRows, height - y) };
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
