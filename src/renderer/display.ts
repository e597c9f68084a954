import { linkModule } from "../compile/linkProgram";
import { BlitPass, type BlitPipelines } from "../gpu/blitPass";
import type { FilmSums } from "../gpu/film";
import { createBlitPipeline } from "../gpu/pipelines";
import { TONE_MAPS, type View } from "./view";

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
    this.#pass.encode(encoder, target, 2 ** exposure, TONE_MAPS.indexOf(toneMap));
  }

  dispose(): void {
    this.#pass?.dispose();
  }
}
