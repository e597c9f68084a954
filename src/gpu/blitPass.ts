import type { StructValue } from "../compile/defineStruct";
import { VIEW } from "../compile/layouts";
import type { Film } from "./film";
import { BufferUsage } from "./flags";

export type ViewUniforms = StructValue<typeof VIEW.fields>;

/** The render pass that shows a film. */
export class BlitPass {
  readonly #device: GPUDevice;
  readonly #pipeline: GPURenderPipeline;
  readonly #uniforms: GPUBuffer;
  readonly #bindGroup: GPUBindGroup;
  readonly #bytes = new DataView(new ArrayBuffer(VIEW.bytes));

  constructor(device: GPUDevice, pipeline: GPURenderPipeline, film: Film) {
    this.#device = device;
    this.#pipeline = pipeline;
    this.#uniforms = device.createBuffer({
      label: "view",
      size: VIEW.bytes,
      usage: BufferUsage.UNIFORM | BufferUsage.COPY_DST,
    });
    this.#bindGroup = device.createBindGroup({
      label: "blit",
      layout: pipeline.getBindGroupLayout(0),
      entries: [this.#uniforms, film.sums].map((buffer, binding) => ({ binding, resource: { buffer } })),
    });
  }

  encode(encoder: GPUCommandEncoder, target: GPUTexture, view: ViewUniforms): void {
    VIEW.write(this.#bytes, 0, view);
    this.#device.queue.writeBuffer(this.#uniforms, 0, this.#bytes.buffer);
    const pass = encoder.beginRenderPass({
      label: "blit",
      colorAttachments: [{ view: target.createView(), loadOp: "clear", storeOp: "store" }],
    });
    pass.setPipeline(this.#pipeline);
    pass.setBindGroup(0, this.#bindGroup);
    pass.draw(3);
    pass.end();
  }

  dispose(): void {
    this.#uniforms.destroy();
  }
}
