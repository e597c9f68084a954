import type { StructValue } from "../compile/defineStruct";
import { VIEW } from "../compile/layouts";
import type { Film, FilmSums } from "./film";
import { BufferUsage, TextureUsage } from "./flags";
import { checkCount } from "./limits";

type ViewUniforms = StructValue<typeof VIEW.fields>;

/** For targets of one format. */
export type BlitPipelines = { readonly show: GPURenderPipeline; readonly stretch: GPURenderPipeline };

/** Shows a film: in one render pass on a target of its size, and in two, smoothly, on one of another size. */
export class BlitPass {
  readonly #device: GPUDevice;
  readonly #pipelines: BlitPipelines;
  readonly #film: FilmSums;
  readonly #uniforms: GPUBuffer;
  readonly #showGroup: GPUBindGroup;
  readonly #bytes = new DataView(new ArrayBuffer(VIEW.bytes));
  /** What is stretched, of the film's size; only once it is needed. */
  #picture: GPUTexture | undefined;
  #stretchGroup: GPUBindGroup | undefined;

  constructor(device: GPUDevice, pipelines: BlitPipelines, film: FilmSums) {
    this.#device = device;
    this.#pipelines = pipelines;
    this.#film = film;
    this.#uniforms = device.createBuffer({
      label: "view",
      size: VIEW.bytes,
      usage: BufferUsage.UNIFORM | BufferUsage.COPY_DST,
    });
    this.#showGroup = device.createBindGroup({
      label: "blit",
      layout: pipelines.show.getBindGroupLayout(0),
      entries: [this.#uniforms, film.sums].map((buffer, binding) => ({ binding, resource: { buffer } })),
    });
  }

  /**
   * @param exposure - factor on radiance.
   * @param toneMap - as `displayed` in `wgsl/tonemap.wgsl` counts them.
   * @throws {UnsupportedError} if the target, or a film that is stretched over it, is too large for a texture.
   */
  encode(encoder: GPUCommandEncoder, target: GPUTexture, exposure: number, toneMap: number): void {
    const { width, height } = this.#film;
    const isStretched = width !== target.width || height !== target.height;
    checkTexture(this.#device, target);
    if (isStretched) checkTexture(this.#device, this.#film);
    const view: ViewUniforms = {
      filmSize: [width, height],
      targetSize: [target.width, target.height],
      exposure,
      toneMap,
    };
    VIEW.write(this.#bytes, 0, view);
    this.#device.queue.writeBuffer(this.#uniforms, 0, this.#bytes.buffer);
    const { show, stretch } = this.#pipelines;
    if (isStretched) this.#picture ??= this.#createPicture(target.format);
    draw(encoder, show, this.#showGroup, isStretched ? this.#picture! : target);
    if (isStretched) draw(encoder, stretch, this.#stretchGroup!, target);
  }

  dispose(): void {
    this.#uniforms.destroy();
    this.#picture?.destroy();
  }

  #createPicture(format: GPUTextureFormat): GPUTexture {
    const { RENDER_ATTACHMENT, TEXTURE_BINDING } = TextureUsage;
    const size = [this.#film.width, this.#film.height];
    const picture = this.#device.createTexture({
      label: "picture",
      size,
      format,
      usage: RENDER_ATTACHMENT | TEXTURE_BINDING,
    });
    this.#stretchGroup = this.#device.createBindGroup({
      label: "blit",
      layout: this.#pipelines.stretch.getBindGroupLayout(0),
      entries: [
        { binding: 0, resource: { buffer: this.#uniforms } },
        { binding: 2, resource: picture.createView() },
        { binding: 3, resource: this.#device.createSampler({ magFilter: "linear", minFilter: "linear" }) },
      ],
    });
    return picture;
  }
}

/** @throws {UnsupportedError} if no texture of the device can have so many pixels on a side. */
export function checkTexture({ limits }: GPUDevice, { width, height }: Pick<Film, "width" | "height">): void {
  const what = `a picture of ${width} × ${height} pixels`;
  checkCount(limits, "maxTextureDimension2D", Math.max(width, height), what);
}

/** One triangle over the whole target. */
function draw(encoder: GPUCommandEncoder, pipeline: GPURenderPipeline, group: GPUBindGroup, target: GPUTexture): void {
  const pass = encoder.beginRenderPass({
    label: "blit",
    colorAttachments: [{ view: target.createView(), loadOp: "clear", storeOp: "store" }],
  });
  pass.setPipeline(pipeline);
  pass.setBindGroup(0, group);
  pass.draw(3);
  pass.end();
}
