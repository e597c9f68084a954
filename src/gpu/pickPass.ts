import { FRAME } from "../compile/layouts";
import { BufferUsage, MapMode, ShaderStage } from "./flags";
import { createComputePipeline } from "./pipelines";
import type { FrameUniforms } from "./tracePass";

const NONE = 0xffffffff;
const FOUND_BYTES = 8;

/** What a ray hits first: a primitive's id, and the distance from the ray's start. */
export type Found = { readonly id: number; readonly t: number };

/**
 * Compiles the entry point `pick` of `wgsl/pick.wgsl`. Bindings: frame, scene, found.
 *
 * @throws {WebGpuError} with the compiler's messages.
 */
export function createPickPipeline(device: GPUDevice, wgsl: string): Promise<GPUComputePipeline> {
  // Not every program reads the scene uniform, so that the layout has to be told.
  const types = ["uniform", "uniform", "storage"] as const;
  const group = device.createBindGroupLayout({
    label: "pick",
    entries: types.map((type, binding) => ({ binding, visibility: ShaderStage.COMPUTE, buffer: { type } })),
  });
  const layout = device.createPipelineLayout({ label: "pick", bindGroupLayouts: [group] });
  return createComputePipeline(device, "pick", wgsl, "pick", layout);
}

/** Traces the ray through the middle of a picture; `undefined` where it hits nothing. What it needs it frees again. */
export async function runPick(
  device: GPUDevice,
  pipeline: GPUComputePipeline,
  scene: ArrayBuffer,
  frame: FrameUniforms,
): Promise<Found | undefined> {
  const { UNIFORM, STORAGE, COPY_DST, COPY_SRC, MAP_READ } = BufferUsage;
  const create = (label: string, size: number, usage: number) => device.createBuffer({ label, size, usage });
  const frameBytes = new DataView(new ArrayBuffer(FRAME.bytes));
  FRAME.write(frameBytes, 0, frame);
  const frameBuffer = create("pick frame", FRAME.bytes, UNIFORM | COPY_DST);
  const sceneBuffer = create("pick scene", scene.byteLength, UNIFORM | COPY_DST);
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
    entries: [frameBuffer, sceneBuffer, found].map((buffer, binding) => ({ binding, resource: { buffer } })),
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
