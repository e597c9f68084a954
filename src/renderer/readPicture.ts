import { checkTexture } from "../gpu/blitPass";
import { explainFailure } from "../gpu/device";
import { download } from "../gpu/download";
import { scoped } from "../gpu/errorScope";
import type { Film, FilmSums } from "../gpu/film";
import { TextureUsage } from "../gpu/flags";
import { Display } from "./display";
import type { View } from "./view";

const BYTES_PER_PIXEL = 4;
const ROW_ALIGNMENT = 256; // WebGPU's bytesPerRow in texture copies

/**
 * The film at the moment of the call as it would be shown: sRGB bytes, RGBA, rows from the top.
 *
 * @throws {UnsupportedError} if it is too large for a texture.
 * @throws {WebGpuError} if the device fails, or is lost meanwhile.
 */
export async function readPicture(device: GPUDevice, film: Film, view: View): Promise<Uint8ClampedArray> {
  checkTexture(device, film);
  // A copy, because the film may be cleared or gone by the time there is a pipeline.
  const { value: copy, error } = scoped(device, () => film.copy());
  let display: Display | undefined;
  try {
    display = await Display.create(device, "rgba8unorm");
    const failure = await error;
    if (failure !== undefined) throw failure;
    return await downloadPicture(device, copy, display, view);
  } catch (cause) {
    throw await explainFailure(device, cause);
  } finally {
    copy.sums.destroy();
    display?.dispose();
  }
}

async function downloadPicture(
  device: GPUDevice,
  film: FilmSums,
  display: Display,
  view: View,
): Promise<Uint8ClampedArray> {
  const { width, height } = film;
  const rowBytes = width * BYTES_PER_PIXEL;
  const bytesPerRow = Math.ceil(rowBytes / ROW_ALIGNMENT) * ROW_ALIGNMENT;
  let texture: GPUTexture | undefined;
  const encode = (encoder: GPUCommandEncoder, staging: GPUBuffer) => {
    const usage = TextureUsage.RENDER_ATTACHMENT | TextureUsage.COPY_SRC;
    texture = device.createTexture({ label: "picture", size: [width, height], format: "rgba8unorm", usage });
    display.encode(encoder, film, texture, view);
    encoder.copyTextureToBuffer({ texture }, { buffer: staging, bytesPerRow }, [width, height]);
  };
  const picture = download(device, "picture readback", bytesPerRow * height, encode, (bytes) => {
    const padded = new Uint8Array(bytes);
    const pixels = new Uint8ClampedArray(rowBytes * height);
    for (let y = 0; y < height; y++) {
      pixels.set(padded.subarray(y * bytesPerRow, y * bytesPerRow + rowBytes), y * rowBytes);
    }
    return pixels;
  });
  texture?.destroy();
  return picture;
}
