import type { StructValue } from "../compile/defineStruct";
import { FRAME } from "../compile/layouts";
import type { Film } from "./film";
import { BufferUsage, ShaderStage } from "./flags";

/** One dispatch's camera, tile, samples and settings. */
export type FrameUniforms = StructValue<typeof FRAME.fields>;

const WORKGROUP = 8; // @workgroup_size of trace()

/** Bindings of the trace pass: frame, scene, film, counters, carries. Not every program reads the scene uniform. */
export function createTraceLayout(device: GPUDevice): GPUPipelineLayout {
  const types = ["uniform", "uniform", "storage", "storage", "storage"] as const;
  const group = device.createBindGroupLayout({
    label: "trace",
    entries: types.map((type, binding) => ({ binding, visibility: ShaderStage.COMPUTE, buffer: { type } })),
  });
  return device.createPipelineLayout({ label: "trace", bindGroupLayouts: [group] });
}

/** The compute pass that traces paths, for one compiled program, scene and film. */
export class TracePass {
  readonly #device: GPUDevice;
  readonly #pipeline: GPUComputePipeline;
  readonly #frame: GPUBuffer;
  readonly #scene: GPUBuffer;
  readonly #bindGroup: GPUBindGroup;
  readonly #frameBytes = new DataView(new ArrayBuffer(FRAME.bytes));

  constructor(device: GPUDevice, pipeline: GPUComputePipeline, scene: ArrayBuffer, film: Film) {
    this.#device = device;
    this.#pipeline = pipeline;
    const usage = BufferUsage.UNIFORM | BufferUsage.COPY_DST;
    this.#frame = device.createBuffer({ label: "frame uniforms", size: FRAME.bytes, usage });
    this.#scene = device.createBuffer({ label: "scene", size: scene.byteLength, usage });
    this.writeScene(scene);
    this.#bindGroup = device.createBindGroup({
      label: "trace",
      layout: pipeline.getBindGroupLayout(0),
      entries: [this.#frame, this.#scene, film.sums, film.counters, film.carries].map((buffer, binding) => ({
        binding,
        resource: { buffer },
      })),
    });
  }

  /** Replaces the scene's values by others of the same layout. */
  writeScene(scene: ArrayBuffer): void {
    this.#device.queue.writeBuffer(this.#scene, 0, scene);
  }

  /** Traces rows `firstRow` to `endRow`. One call per submit: the uniforms are shared by all that is encoded with it. */
  encode(encoder: GPUCommandEncoder, frame: FrameUniforms, timestampWrites?: GPUComputePassTimestampWrites): void {
    FRAME.write(this.#frameBytes, 0, frame);
    this.#device.queue.writeBuffer(this.#frame, 0, this.#frameBytes.buffer);
    const pass = encoder.beginComputePass({ label: "trace", ...(timestampWrites && { timestampWrites }) });
    pass.setPipeline(this.#pipeline);
    pass.setBindGroup(0, this.#bindGroup);
    const rows = frame.endRow - frame.firstRow;
    pass.dispatchWorkgroups(Math.ceil(frame.size[0]! / WORKGROUP), Math.ceil(rows / WORKGROUP));
    pass.end();
  }

  dispose(): void {
    this.#frame.destroy();
    this.#scene.destroy();
  }
}
