import type { CompiledScene } from "../compile/compileScene";
import { FRAME } from "../compile/layouts";
import { BufferUsage, MapMode, ShaderStage } from "./flags";
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
 * @throws {WebGpuError} with the compiler's messages.
 */
export async function createPickPipeline(
  device: GPUDevice,
  wgsl: string,
  { features, isStored }: Pick<CompiledScene, "features" | "isStored">,
): Promise<PickPipeline> {
  const types = ["uniform", isStored ? "read-only-storage" : "uniform", "storage"] as const;
  const own = types.map((type, binding) => ({ binding, visibility: ShaderStage.COMPUTE, buffer: { type } }));
  const geometry = geometryLayout(features);
  const group = device.createBindGroupLayout({ label: "pick", entries: [...own, ...geometry] });
  const layout = device.createPipelineLayout({ label: "pick", bindGroupLayouts: [group] });
  return { pipeline: await createComputePipeline(device, "pick", wgsl, "pick", layout), geometry };
}

/** Traces the ray through the middle of a picture; `undefined` where it hits nothing. What it makes it frees again. */
export async function runPick(
  device: GPUDevice,
  { pipeline, geometry: layout }: PickPipeline,
  scene: ArrayBuffer,
  geometry: SceneGeometry | undefined,
  frame: FrameUniforms,
): Promise<Found | undefined> {
  const { UNIFORM, STORAGE, COPY_DST, COPY_SRC, MAP_READ } = BufferUsage;
  const create = (label: string, size: number, usage: number) => device.createBuffer({ label, size, usage });
  const frameBytes = new DataView(new ArrayBuffer(FRAME.bytes));
  FRAME.write(frameBytes, 0, frame);
  const frameBuffer = create("pick frame", FRAME.bytes, UNIFORM | COPY_DST);
  const sceneBuffer = create("pick scene", scene.byteLength, UNIFORM | STORAGE | COPY_DST);
  const found = create("pick found", FOUND_BYTES, STORAGE | COPY_SRC);
  const staging = create("pick readback", FOUND_BYTES, COPY_DST | MAP_READ);
  device.queue.writeBuffer(frameBuffer, 0, frameBytes.buffer);
  device.queue.writeBuffer(sceneBuffer, 0, scene);

  const encoder = device.createCommandEncoder({ label: "pick" });
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
  device.queue.submit([encoder.finish()]);
  try {
    await staging.mapAsync(MapMode.READ);
    const view = new DataView(staging.getMappedRange());
    const id = view.getUint32(0, true);
    return id === NONE ? undefined : { id, t: view.getFloat32(4, true) };
  } finally {
    for (const buffer of [frameBuffer, sceneBuffer, found, staging]) buffer.destroy();
  }
}
