import { linkModule } from "../compile/linkProgram";
import { BlitPass, type BlitPipelines, checkTexture, type ToneMap } from "../gpu/blitPass";
import { explainFailure } from "../gpu/device";
import { download } from "../gpu/download";
import { scoped } from "../gpu/errorScope";
import type { Film, FilmSums } from "../gpu/film";
import { TextureUsage } from "../gpu/flags";
import { createBlitPipeline } from "../gpu/pipelines";

/** How radiance becomes a picture. */
export type View = {
  /** In stops: each doubles the brightness. Default 0. */
  readonly exposure?: number;
  /**
   * `"aces"`, the default: Hill's fit of the ACES transforms. `"agx"`: Sobotka's AgX in Wrensch's fit, whose bright
   * colours turn white more gently. `"none"`: what is brighter than 1 is cut off. The papers are cited in `tonemap.wgsl`.
   */
  readonly toneMap?: ToneMap;
};

const BYTES_PER_PIXEL = 4;
const ROW_ALIGNMENT = 256; // WebGPU's bytesPerRow in texture copies

/** Shows films on textures of one format. */
export class Display {
  readonly #device: GPUDevice;
  readonly #pipelines: BlitPipelines;
  /** For the film that was shown last. */
  #pass: BlitPass | undefined;
  #film: FilmSums | undefined;

  /** @throws {WebGpuError} with the compiler's messages. */
  static async create(device: GPUDevice, format: GPUTextureFormat): Promise<Display> {
    const code = await linkModule("blit");
    const create = (entryPoint: string) => createBlitPipeline(device, "blit", code, entryPoint, format);
    const [show, stretch] = await Promise.all([create("show"), create("stretch")]);
    return new Display(device, { show, stretch });
  }

  private constructor(device: GPUDevice, pipelines: BlitPipelines) {
    this.#device = device;
    this.#pipelines = pipelines;
  }

  /**
   * Draws the film, stretched smoothly over the whole texture.
   *
   * @throws {UnsupportedError} if either is too large for a texture.
   */
  draw(film: FilmSums, target: GPUTexture, view: View): void {
    const encoder = this.#device.createCommandEncoder({ label: "present" });
    this.encode(encoder, film, target, view);
    this.#device.queue.submit([encoder.finish()]);
  }

  /** The same, to be submitted with other work. */
  encode(
    encoder: GPUCommandEncoder,
    film: FilmSums,
    target: GPUTexture,
    { exposure = 0, toneMap = "aces" }: View,
  ): void {
    if (this.#pass === undefined || film !== this.#film) {
      this.#pass?.dispose();
      this.#film = film;
      this.#pass = new BlitPass(this.#device, this.#pipelines, film);
    }
    this.#pass.encode(encoder, target, 2 ** exposure, toneMap);
  }

  dispose(): void {
    this.#pass?.dispose();
  }
}

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
