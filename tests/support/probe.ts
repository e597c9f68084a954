import { type LinkParams, link } from "wesl/core";
import { BufferUsage, MapMode } from "../../src/gpu/flags";
import { createComputePipeline } from "../../src/gpu/pipelines";
import { testDevice } from "./device";

/** The shader modules of `src/wgsl`, as `compile/linkProgram.ts` names them. */
const MODULES: Readonly<Record<string, string>> = Object.fromEntries(
  Object.entries(
    import.meta.glob<string>("../../src/wgsl/*.wgsl", { query: "?raw", import: "default", eager: true }),
  ).map(([path, text]) => [path.replace("../../src/wgsl/", "./"), text]),
);

export type Probe = {
  /**
   * WGSL with the imports it needs and a function `fn probe(index: u32)`, called once for every index below `count`. It
   * reads `inputs: array<vec4u>` and writes `outputs: array<vec4u>`.
   */
  readonly wgsl: string;
  readonly conditions: LinkParams["conditions"];
  readonly count: number;
  readonly inputs: Uint32Array | Float32Array;
  /** Rows of `outputs`, four words each. */
  readonly outputRows: number;
  /** More modules: the generated `scene`, say. */
  readonly modules?: Readonly<Record<string, string>>;
  /** Contents of the uniform `scene`, where `wgsl` reads it. */
  readonly scene?: ArrayBuffer;
};

const WORKGROUP = 64;

/** Runs functions of the shader modules on the device, each on its own, and returns the words that they wrote. */
export async function runProbe({ wgsl, conditions, count, inputs, outputRows, modules, scene }: Probe) {
  const device = await testDevice();
  const { dest } = await link({
    weslSrc: { ...MODULES, ...modules, "./probe.wgsl": `${wgsl}\n${harness(count)}` },
    rootModuleName: "probe",
    ...(conditions && { conditions }),
  });
  const pipeline = await createComputePipeline(device, "probe", dest, "main");

  const bytes = 16 * outputRows;
  const { STORAGE, UNIFORM, COPY_DST, COPY_SRC, MAP_READ } = BufferUsage;
  const create = (label: string, size: number, usage: number) => device.createBuffer({ label, size, usage });
  const input = create("probe inputs", Math.max(inputs.byteLength, 16), STORAGE | COPY_DST);
  const output = create("probe outputs", bytes, STORAGE | COPY_SRC);
  const staging = create("probe readback", bytes, COPY_DST | MAP_READ);
  const uniform = scene && create("scene", scene.byteLength, UNIFORM | COPY_DST);
  device.queue.writeBuffer(input, 0, inputs.buffer as ArrayBuffer, inputs.byteOffset, inputs.byteLength);
  if (scene && uniform) device.queue.writeBuffer(uniform, 0, scene);

  const encoder = device.createCommandEncoder({ label: "probe" });
  const pass = encoder.beginComputePass({ label: "probe" });
  pass.setPipeline(pipeline);
  const entries = [
    ...(uniform ? [{ binding: 1, resource: { buffer: uniform } }] : []),
    { binding: 8, resource: { buffer: input } },
    { binding: 9, resource: { buffer: output } },
  ];
  pass.setBindGroup(0, device.createBindGroup({ label: "probe", layout: pipeline.getBindGroupLayout(0), entries }));
  pass.dispatchWorkgroups(Math.ceil(count / WORKGROUP));
  pass.end();
  encoder.copyBufferToBuffer(output, 0, staging, 0, bytes);
  device.queue.submit([encoder.finish()]);
  await staging.mapAsync(MapMode.READ);
  const words = new Uint32Array(staging.getMappedRange().slice(0));
  for (const buffer of [input, output, staging, uniform]) buffer?.destroy();
  return words;
}

function harness(count: number): string {
  return `
@group(0) @binding(8) var<storage, read> inputs: array<vec4u>;
@group(0) @binding(9) var<storage, read_write> outputs: array<vec4u>;

@compute @workgroup_size(${WORKGROUP})
fn main(@builtin(global_invocation_id) id: vec3u) {
  if (id.x < ${count}u) { probe(id.x); }
}
`;
}
