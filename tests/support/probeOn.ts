import type { Features } from "../../src/compile/features";
import { type Conditions, link, parseModule } from "../../src/compile/link";
import { BufferUsage, MapMode, ShaderStage } from "../../src/gpu/flags";
import { geometryLayout } from "../../src/gpu/geometryLayout";
import { createComputePipeline } from "../../src/gpu/pipelines";
import { SceneGeometry } from "../../src/gpu/sceneGeometry";
import type { Geometry } from "../../src/tree/geometry";
import { SHADER_MODULES } from "./shaderModules";

export type Probe = {
  /**
   * WGSL with the imports it needs and a function `fn probe(index: u32)`, called once for every index below `count`. It
   * reads `inputs: array<vec4u>` and writes `outputs: array<vec4u>`.
   */
  readonly wgsl: string;
  readonly conditions?: Conditions | undefined;
  readonly count: number;
  readonly inputs: Uint32Array | Float32Array;
  /** Rows of `outputs`, four words each. */
  readonly outputRows: number;
  /** More modules by their paths: the generated `scene`, say. */
  readonly modules?: Readonly<Record<string, string>>;
  /** Contents of the uniform `scene`, where `wgsl` reads it. */
  readonly scene?: ArrayBuffer;
  /** Of a scene with meshes; `conditions` are its features then. */
  readonly geometry?: Geometry | undefined;
  /** Whether `scene` is in a storage buffer. */
  readonly isStored?: boolean;
};

const WORKGROUP = 64;
// Workgroups in a row of the dispatch, of which a device takes 65,535 at least in each direction.
const ROW = 32768;
// Beyond the bindings of the modules themselves.
const INPUTS = 20;
const OUTPUTS = 21;

/** Runs functions of the shader modules on a device, each on its own, and returns the words that they wrote. */
export async function probeOn(
  device: GPUDevice,
  { wgsl, conditions, count, inputs, outputRows, modules, scene, geometry, isStored }: Probe,
): Promise<Uint32Array> {
  const texts: Readonly<Record<string, string>> = {
    ...SHADER_MODULES,
    ...modules,
    probe: `${wgsl}\n${harness(count)}`,
  };
  const parsed = new Map(Object.entries(texts).map(([path, text]) => [path, parseModule(text)]));
  const code = link((path) => parsed.get(path), "probe", conditions ?? {});
  const geometryEntries = geometry ? geometryLayout(conditions as Features) : [];
  const visibility = ShaderStage.COMPUTE;
  const layout = device.createBindGroupLayout({
    label: "probe",
    entries: [
      ...(scene
        ? [
            {
              binding: 1,
              visibility,
              buffer: { type: isStored ? ("read-only-storage" as const) : ("uniform" as const) },
            },
          ]
        : []),
      ...geometryEntries,
      { binding: INPUTS, visibility, buffer: { type: "read-only-storage" } },
      { binding: OUTPUTS, visibility, buffer: { type: "storage" } },
    ],
  });
  const pipelineLayout = device.createPipelineLayout({ label: "probe", bindGroupLayouts: [layout] });
  const pipeline = await createComputePipeline(device, "probe", code, "main", pipelineLayout);

  const bytes = 16 * outputRows;
  const { STORAGE, UNIFORM, COPY_DST, COPY_SRC, MAP_READ } = BufferUsage;
  const create = (label: string, size: number, usage: number) => device.createBuffer({ label, size, usage });
  const input = create("probe inputs", Math.max(inputs.byteLength, 16), STORAGE | COPY_DST);
  const output = create("probe outputs", bytes, STORAGE | COPY_SRC);
  const staging = create("probe readback", bytes, COPY_DST | MAP_READ);
  const sceneGeometry = geometry && new SceneGeometry(device, geometry);
  const uniform = scene && create("scene", scene.byteLength, UNIFORM | STORAGE | COPY_DST);
  device.queue.writeBuffer(input, 0, inputs.buffer as ArrayBuffer, inputs.byteOffset, inputs.byteLength);
  if (scene && uniform) device.queue.writeBuffer(uniform, 0, scene);

  const encoder = device.createCommandEncoder({ label: "probe" });
  const pass = encoder.beginComputePass({ label: "probe" });
  pass.setPipeline(pipeline);
  const entries = [
    ...(uniform ? [{ binding: 1, resource: { buffer: uniform } }] : []),
    ...(sceneGeometry?.entries(geometryEntries) ?? []),
    { binding: INPUTS, resource: { buffer: input } },
    { binding: OUTPUTS, resource: { buffer: output } },
  ];
  pass.setBindGroup(0, device.createBindGroup({ label: "probe", layout, entries }));
  const groups = Math.ceil(count / WORKGROUP);
  pass.dispatchWorkgroups(Math.min(groups, ROW), Math.ceil(groups / ROW));
  pass.end();
  encoder.copyBufferToBuffer(output, 0, staging, 0, bytes);
  device.queue.submit([encoder.finish()]);
  await staging.mapAsync(MapMode.READ);
  const words = new Uint32Array(staging.getMappedRange().slice(0));
  for (const buffer of [input, output, staging, uniform]) buffer?.destroy();
  sceneGeometry?.dispose();
  return words;
}

function harness(count: number): string {
  return `
@group(0) @binding(${INPUTS}) var<storage, read> inputs: array<vec4u>;
@group(0) @binding(${OUTPUTS}) var<storage, read_write> outputs: array<vec4u>;

@compute @workgroup_size(${WORKGROUP})
fn main(@builtin(global_invocation_id) id: vec3u) {
  let index = id.x + id.y * ${WORKGROUP * ROW}u;
  if (index < ${count}u) { probe(index); }
}
`;
}
