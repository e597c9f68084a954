import type { CompiledScene } from "../compile/compileScene";
import { FRAME } from "../compile/layouts";
import { download } from "./download";
import { checked } from "./errorScope";
import { BufferUsage, ShaderStage } from "./flags";
import { geometryLayout } from "./geometryLayout";
import { createComputePipeline } from "./pipelines";
import type { SceneGeometry } from "./sceneGeometry";
import type { FrameUniforms } from "./tracePass";

const NONE = 0xffffffff;
const FOUND_BYTES = 8;

/** What a ray hits first: a primitive's id, and the distance from the ray's start. */
export type Found = { readonly id: number; readonly t: number };

/** What `pick` in `wgsl/pick.wgsl` is compiled to, for all scenes that need the same features. */
export type PickPipeline = {
  readonly pipeline: GPUComputePipeline;
  /** The part of its bind group that a scene's geometry fills. */
  readonly geometry: readonly GPUBindGroupLayoutEntry[];
};

/**
 * Bindings: frame, scene, found, geometry. Not every program reads the scene uniform.
 *
 * @throws {WebGpuError} with the compiler's messages, or what the device lacks.
 */
export async function createPickPipeline(
  device: GPUDevice,
  wgsl: string,
  { features, isStored }: Pick<CompiledScene, "features" | "isStored">,
): Promise<PickPipeline> {
  const types = ["uniform", isStored ? "read-only-storage" : "uniform", "storage"] as const;
  const own = types.map((type, binding) => ({ binding, visibility: ShaderStage.COMPUTE, buffer: { type } }));
  const geometry = geometryLayout(features);
  const layout = await checked(device, () => {
    const group = device.createBindGroupLayout({ label: "pick", entries: [...own, ...geometry] });
    return device.createPipelineLayout({ label: "pick", bindGroupLayouts: [group] });
  });
  return { pipeline: await createComputePipeline(device, "pick", wgsl, "pick", layout), geometry };
}

/**
 * Traces the ray through the middle of a picture; `undefined` where it hits nothing. The geometry is not needed any more as
 * soon as this has returned.
 *
 * @throws {WebGpuError} if that fails, or the device is lost meanwhile.
 */
export function runPick(
  device: GPUDevice,
  { pipeline, geometry: layout }: PickPipeline,
  scene: ArrayBuffer,
  geometry: SceneGeometry | undefined,
  frame: FrameUniforms,
): Promise<Found | undefined> {
  const { UNIFORM, STORAGE, COPY_DST, COPY_SRC } = BufferUsage;
  const buffers: GPUBuffer[] = [];
  const create = (label: string, size: number, usage: number) => {
    const buffer = device.createBuffer({ label, size, usage });
    buffers.push(buffer);
    return buffer;
  };
  const encode = (encoder: GPUCommandEncoder, staging: GPUBuffer) => {
    const frameBytes = new DataView(new ArrayBuffer(FRAME.bytes));
    FRAME.write(frameBytes, 0, frame);
    const frameBuffer = create("pick frame", FRAME.bytes, UNIFORM | COPY_DST);
    const sceneBuffer = create("pick scene", scene.byteLength, UNIFORM | STORAGE | COPY_DST);
    const found = create("pick found", FOUND_BYTES, STORAGE | COPY_SRC);
    device.queue.writeBuffer(frameBuffer, 0, frameBytes.buffer);
    device.queue.writeBuffer(sceneBuffer, 0, scene);

    const pass = encoder.beginComputePass({ label: "pick" });
    pass.setPipeline(pipeline);
    const bindGroup = device.createBindGroup({
      label: "pick",
      layout: pipeline.getBindGroupLayout(0),
      entries: [
        ...[frameBuffer, sceneBuffer, found].map((buffer, binding) => ({ binding, resource: { buffer } })),
        ...(geometry?.entries(layout) ?? []),
      ],
    });
    pass.setBindGroup(0, bindGroup);
    pass.dispatchWorkgroups(1);
    pass.end();
    encoder.copyBufferToBuffer(found, 0, staging, 0, FOUND_BYTES);
  };
  const found = download(device, "pick readback", FOUND_BYTES, encode, (bytes) => {
    const view = new DataView(bytes);
    const id = view.getUint32(0, true);
    return id === NONE ? undefined : { id, t: view.getFloat32(4, true) };
  });
  for (const buffer of buffers) buffer.destroy(); // what was submitted is done all the same
  return found;
}
