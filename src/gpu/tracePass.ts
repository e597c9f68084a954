import type { CompiledScene } from "../compile/compileScene";
import type { StructValue } from "../compile/defineStruct";
import { FRAME } from "../compile/layouts";
import type { Film } from "./film";
import { BufferUsage, ShaderStage } from "./flags";
import { geometryLayout } from "./geometryLayout";
import { createComputePipeline } from "./pipelines";
import type { SceneGeometry } from "./sceneGeometry";

/** One dispatch's camera, tile, samples and settings. */
export type FrameUniforms = StructValue<typeof FRAME.fields>;

const WORKGROUP = 8; // @workgroup_size of trace() and traceLamps()

/** The entry points of a tracer; `lamps` where the scene has any. */
export type TracePipelines = {
  readonly trace: GPUComputePipeline;
  readonly lamps: GPUComputePipeline | undefined;
  /** The part of their bind group that a scene's geometry fills. */
  readonly geometry: readonly GPUBindGroupLayoutEntry[];
};

/** @throws {WebGpuError} with the compiler's messages. */
export async function createTracePipelines(
  device: GPUDevice,
  wgsl: string,
  { features, isStored }: Pick<CompiledScene, "features" | "isStored">,
): Promise<TracePipelines> {
  const geometry = geometryLayout(features);
  const layout = createTraceLayout(device, isStored, geometry);
  const [trace, lamps] = await Promise.all([
    createComputePipeline(device, "trace", wgsl, "trace", layout),
    features.LAMPS ? createComputePipeline(device, "lamps", wgsl, "traceLamps", layout) : undefined,
  ]);
  return { trace, lamps, geometry };
}

/** Bindings: frame, scene, film, counters, carries, geometry. Not every program reads the scene uniform. */
function createTraceLayout(
  device: GPUDevice,
  isStored: boolean,
  geometry: readonly GPUBindGroupLayoutEntry[],
): GPUPipelineLayout {
  const scene = isStored ? "read-only-storage" : "uniform";
  const types = ["uniform", scene, "storage", "storage", "storage"] as const;
  const own = types.map((type, binding) => ({ binding, visibility: ShaderStage.COMPUTE, buffer: { type } }));
  const group = device.createBindGroupLayout({ label: "trace", entries: [...own, ...geometry] });
  return device.createPipelineLayout({ label: "trace", bindGroupLayouts: [group] });
}

/** The compute pass that traces paths, for one compiled program, scene and film. */
export class TracePass {
  readonly #device: GPUDevice;
  readonly #pipelines: TracePipelines;
  readonly #frame: GPUBuffer;
  readonly #scene: GPUBuffer;
  readonly #bindGroup: GPUBindGroup;
  #written: ArrayBuffer | undefined;
  readonly #frameBytes = new DataView(new ArrayBuffer(FRAME.bytes));

  constructor(
    device: GPUDevice,
    pipelines: TracePipelines,
    scene: ArrayBuffer,
    geometry: SceneGeometry | undefined,
    film: Film,
  ) {
    this.#device = device;
    this.#pipelines = pipelines;
    const usage = BufferUsage.UNIFORM | BufferUsage.COPY_DST;
    this.#frame = device.createBuffer({ label: "frame uniforms", size: FRAME.bytes, usage });
    this.#scene = device.createBuffer({ label: "scene", size: scene.byteLength, usage: usage | BufferUsage.STORAGE });
    this.writeScene(scene);
    this.#bindGroup = device.createBindGroup({
      label: "trace",
      layout: pipelines.trace.getBindGroupLayout(0),
      entries: [
        ...[this.#frame, this.#scene, film.sums, film.counters, film.carries].map((buffer, binding) => ({
          binding,
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

  /** Traces rows `firstRow` to `endRow`. One call per submit: the uniforms are shared by all that is encoded with it. */
  encode(encoder: GPUCommandEncoder, frame: FrameUniforms, timestampWrites?: GPUComputePassTimestampWrites): void {
    FRAME.write(this.#frameBytes, 0, frame);
    this.#device.queue.writeBuffer(this.#frame, 0, this.#frameBytes.buffer);
    const pass = encoder.beginComputePass({ label: "trace", ...(timestampWrites && { timestampWrites }) });
    pass.setBindGroup(0, this.#bindGroup);
    dispatch(pass, this.#pipelines.trace, frame.size[0]!, frame.endRow - frame.firstRow);
    const { lampsFrom: from, lampsTo: to } = frame;
    const lampRows = Math.min(to[1]!, frame.endRow) - Math.max(from[1]!, frame.firstRow);
    if (this.#pipelines.lamps && lampRows > 0) dispatch(pass, this.#pipelines.lamps, to[0]! - from[0]!, lampRows);
    pass.end();
  }

  dispose(): void {
    this.#frame.destroy();
    this.#scene.destroy();
  }
}

/** One invocation for each of `width · rows` pixels. */
function dispatch(pass: GPUComputePassEncoder, pipeline: GPUComputePipeline, width: number, rows: number): void {
  pass.setPipeline(pipeline);
  pass.dispatchWorkgroups(Math.ceil(width / WORKGROUP), Math.ceil(rows / WORKGROUP));
}
