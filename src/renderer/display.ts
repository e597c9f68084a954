import { linkModule } from "../compile/linkProgram";
import { BlitPass, type BlitPipelines, type ToneMap } from "../gpu/blitPass";
import type { Film } from "../gpu/film";
import { BufferUsage, MapMode, TextureUsage } from "../gpu/flags";
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

/** Shows a film on textures of one format. */
export class Display {
  readonly #device: GPUDevice;
  readonly #pipelines: BlitPipelines;
  #pass: BlitPass;
  #film: Film;

  static async create(device: GPUDevice, film: Film, format: GPUTextureFormat): Promise<Display> {
    const code = await linkModule("blit");
    const create = (entryPoint: string) => createBlitPipeline(device, "blit", code, entryPoint, format);
    const [show, stretch] = await Promise.all([create("show"), create("stretch")]);
    return new Display(device, film, { show, stretch });
  }

  private constructor(device: GPUDevice, film: Film, pipelines: BlitPipelines) {
    this.#device = device;
    this.#pipelines = pipelines;
    this.#film = film;
    this.#pass = new BlitPass(device, pipelines, film);
  }

  /** Draws the film, stretched smoothly over the whole texture. */
  draw(film: Film, target: GPUTexture, { exposure = 0, toneMap = "aces" }: View): void {
    if (film !== this.#film) {
      this.#pass.dispose();
      this.#film = film;
      this.#pass = new BlitPass(this.#device, this.#pipelines, film);
    }
    const encoder = this.#device.createCommandEncoder({ label: "present" });
    this.#pass.encode(encoder, target, 2 ** exposure, toneMap);
    this.#device.queue.submit([encoder.finish()]);
  }

  dispose(): void {
    this.#pass.dispose();
  }
}

/** The film as it would be shown: sRGB bytes, RGBA, rows from the top. */
export async function readPicture(device: GPUDevice, film: Film, view: View): Promise<Uint8ClampedArray> {
  const { width, height } = film;
  const display = await Display.create(device, film, "rgba8unorm");
  const { RENDER_ATTACHMENT, COPY_SRC } = TextureUsage;
  const texture = device.createTexture({
    label: "picture",
    size: [width, height],
    format: "rgba8unorm",
    usage: RENDER_ATTACHMENT | COPY_SRC,
  });
  display.draw(film, texture, view);

  const bytesPerRow = Math.ceil((width * BYTES_PER_PIXEL) / ROW_ALIGNMENT) * ROW_ALIGNMENT;
  const staging = device.createBuffer({
    label: "picture readback",
    size: bytesPerRow * height,
    usage: BufferUsage.COPY_DST | BufferUsage.MAP_READ,
  });
  const encoder = device.createCommandEncoder({ label: "read picture" });
  encoder.copyTextureToBuffer({ texture }, { buffer: staging, bytesPerRow }, [width, height]);
  device.queue.submit([encoder.finish()]);
  await staging.mapAsync(MapMode.READ);

  const padded = new Uint8Array(staging.getMappedRange());
  const pixels = new Uint8ClampedArray(width * height * BYTES_PER_PIXEL);
  const rowBytes = width * BYTES_PER_PIXEL;
  for (let y = 0; y < height; y++) {
    pixels.set(padded.subarray(y * bytesPerRow, y * bytesPerRow + rowBytes), y * rowBytes);
  }
  staging.destroy();
  texture.destroy();
  display.dispose();
  return pixels;
}
