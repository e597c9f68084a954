import { linkModule } from "../compile/linkProgram";
import { BlitPass } from "../gpu/blitPass";
import type { Film } from "../gpu/film";
import { BufferUsage, MapMode, TextureUsage } from "../gpu/flags";
import { createBlitPipeline } from "../gpu/pipelines";

/** How radiance becomes a picture. */
export type View = {
  /** In stops: each doubles the brightness. Default 0. */
  readonly exposure?: number;
};

const BYTES_PER_PIXEL = 4;
const ROW_ALIGNMENT = 256; // WebGPU's bytesPerRow in texture copies

/** Shows a film on textures of one format. */
export class Display {
  readonly #device: GPUDevice;
  readonly #pipeline: GPURenderPipeline;
  #pass: BlitPass;
  #film: Film;

  static async create(device: GPUDevice, film: Film, format: GPUTextureFormat): Promise<Display> {
    const pipeline = await createBlitPipeline(device, "blit", await linkModule("blit"), format);
    return new Display(device, film, pipeline);
  }

  private constructor(device: GPUDevice, film: Film, pipeline: GPURenderPipeline) {
    this.#device = device;
    this.#pipeline = pipeline;
    this.#film = film;
    this.#pass = new BlitPass(device, pipeline, film);
  }

  /** Draws the film, stretched over the whole texture. */
  draw(film: Film, target: GPUTexture, { exposure = 0 }: View): void {
    if (film !== this.#film) {
      this.#pass.dispose();
      this.#film = film;
      this.#pass = new BlitPass(this.#device, this.#pipeline, film);
    }
    const encoder = this.#device.createCommandEncoder({ label: "present" });
    this.#pass.encode(encoder, target, {
      filmSize: [film.width, film.height],
      targetSize: [target.width, target.height],
      exposure: 2 ** exposure,
    });
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
