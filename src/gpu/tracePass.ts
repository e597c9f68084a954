import type { CompiledScene } from "../compile/compileScene";
import type { StructValue } from "../compile/defineStruct";
import { FRAME } from "../compile/layouts";
import { checked } from "./errorScope";
import type { Film } from "./film";
import { BufferUsage, ShaderStage } from "./flags";
import { geometryLayout } from "./geometryLayout";
import { createComputePipeline } from "./pipelines";
import type { SceneGeometry } from "./sceneGeometry";
import { BLOCK_STRIPS } from "./strips";

/** One dispatch's camera, strips, samples and settings. */
export type FrameUniforms = StructValue<typeof FRAME.fields>;

/** Dispatches in one submit, at most. */
export const MAX_DISPATCHES = 64;
// Where in the buffer each dispatch has its uniforms: minUniformBufferOffsetAlignment of every WebGPU device.
const FRAME_STRIDE = 256;
// Workgroups in one row of a dispatch: any number up to maxComputeWorkgroupsPerDimension.
const MAX_ROW = 16384;

/** The entry points of a tracer; `emitters` where the scene has any. */
export type TracePipelines = {
  readonly trace: GPUComputePipeline;
  readonly emitters: GPUComputePipeline | undefined;
  /** The part of their bind group that a scene's geometry fills. */
  readonly geometry: readonly GPUBindGroupLayoutEntry[];
};

/** @throws {WebGpuError} with the compiler's messages, or what the device lacks. */
export async function createTracePipelines(
  device: GPUDevice,
  wgsl: string,
  { features, isStored }: Pick<CompiledScene, "features" | "isStored">,
): Promise<TracePipelines> {
  const geometry = geometryLayout(features);
  const layout = await checked(device, () => createTraceLayout(device, isStored, geometry));
  const [trace, emitters] = await Promise.all([
    createComputePipeline(device, "trace", wgsl, "trace", layout),
    features.VISIBLE_EMITTERS ? createComputePipeline(device, "emitters", wgsl, "traceEmitters", layout) : undefined,
  ]);
  return { trace, emitters, geometry };
}

/** Bindings: frame, scene, film, counters, carries, geometry. Not every program reads the scene uniform. */
function createTraceLayout(
  device: GPUDevice,
  isStored: boolean,
  geometry: readonly GPUBindGroupLayoutEntry[],
): GPUPipelineLayout {
  const scene = isStored ? "read-only-storage" : "uniform";
  const types = ["uniform", scene, "storage", "storage", "storage"] as const;
  const own = types.map((type, binding) => ({
    binding,
    visibility: ShaderStage.COMPUTE,
    buffer: { type, hasDynamicOffset: binding === 0 },
  }));
  const group = device.createBindGroupLayout({ label: "trace", entries: [...own, ...geometry] });
  return device.createPipelineLayout({ label: "trace", bindGroupLayouts: [group] });
}

/** What a trace pass reads and writes. */
export type TraceTarget = {
  readonly pipelines: TracePipelines;
  /** The scene's values, for the program's uniform. */
  readonly scene: ArrayBuffer;
  readonly geometry: SceneGeometry | undefined;
  readonly film: Film;
};

/** The compute pass that traces paths, for one compiled program, scene and film. */
export class TracePass {
  readonly #device: GPUDevice;
  readonly #pipelines: TracePipelines;
  readonly #frame: GPUBuffer;
  readonly #scene: GPUBuffer;
  readonly #bindGroup: GPUBindGroup;
  #written: ArrayBuffer | undefined;
  readonly #frameBytes = new DataView(new ArrayBuffer(FRAME_STRIDE * MAX_DISPATCHES));

  constructor(device: GPUDevice, { pipelines, scene, geometry, film }: TraceTarget) {
    this.#device = device;
    this.#pipelines = pipelines;
    const usage = BufferUsage.UNIFORM | BufferUsage.COPY_DST;
    this.#frame = device.createBuffer({ label: "frame uniforms", size: this.#frameBytes.byteLength, usage });
    this.#scene = device.createBuffer({ label: "scene", size: scene.byteLength, usage: usage | BufferUsage.STORAGE });
    this.writeScene(scene);
    this.#bindGroup = device.createBindGroup({
      label: "trace",
      layout: pipelines.trace.getBindGroupLayout(0),
      entries: [
        { binding: 0, resource: { buffer: this.#frame, size: FRAME.bytes } },
        ...[this.#scene, film.sums, film.counters, film.carries].map((buffer, i) => ({
          binding: i + 1,
          resource: { buffer },
        })),
        ...(geometry?.entries(pipelines.geometry) ?? []),
      ],
    });
  }

  /** Replaces the scene's values by others of the same layout. Nothing is sent where they are those that it has. */
  writeScene(scene: ArrayBuffer): void {
    if (scene === this.#written) return;
    this.#written = scene;
    this.#device.queue.writeBuffer(this.#scene, 0, scene);
  }

  /**
   * Traces up to `MAX_DISPATCHES` slices, one after the other. One call per submit: it writes the uniforms of all that is
   * encoded with it.
   */
  encode(
    encoder: GPUCommandEncoder,
    frames: readonly FrameUniforms[],
    timestampWrites?: GPUComputePassTimestampWrites,
  ): void {
    for (const [i, frame] of frames.entries()) FRAME.write(this.#frameBytes, i * FRAME_STRIDE, frame);
    this.#device.queue.writeBuffer(this.#frame, 0, this.#frameBytes.buffer, 0, frames.length * FRAME_STRIDE);
    const pass = encoder.beginComputePass({ label: "trace", ...(timestampWrites && { timestampWrites }) });
    for (const [i, frame] of frames.entries()) {
      pass.setBindGroup(0, this.#bindGroup, [i * FRAME_STRIDE]);
      dispatch(pass, this.#pipelines.trace, frame);
      const seesEmitters = frame.emittersTo[0]! > frame.emittersFrom[0]!;
      if (this.#pipelines.emitters && seesEmitters) dispatch(pass, this.#pipelines.emitters, frame);
    }
    pass.end();
  }

  dispose(): void {
    this.#frame.destroy();
    this.#scene.destroy();
  }
}

/** One workgroup for each block of the film that the slice has strips of. */
function dispatch(pass: GPUComputePassEncoder, pipeline: GPUComputePipeline, frame: FrameUniforms): void {
  const blocks = Math.ceil(frame.endStrip / BLOCK_STRIPS) - Math.floor(frame.firstStrip / BLOCK_STRIPS);
  pass.setPipeline(pipeline);
  pass.dispatchWorkgroups(Math.min(blocks, MAX_ROW), Math.ceil(blocks / MAX_ROW));
}
