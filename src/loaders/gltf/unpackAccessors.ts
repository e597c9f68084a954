// Vertex data and indices as typed arrays, however a file packs them: interleaved, sparse, quantised, meshopt or Draco.
// glTF-Transform does the work; it is given only what was checked, and nothing that no mesh uses.

import { type Accessor, type Extension, type GLTF, type JSONDocument, Logger, WebIO } from "@gltf-transform/core";
import { LoadError } from "../../errors";
import { isRead } from "./primitive";
import type { Resources } from "./resources";
import type { GltfJson } from "./schema";

/** What unpacking needs beyond glTF-Transform's core. Each is loaded for files that use it only. */
type Decoder = { readonly extension: typeof Extension; readonly dependency: Readonly<Record<string, unknown>> };

/** Takes the place of an accessor that no mesh uses. */
const UNUSED: GltfJson["accessors"][number] = { componentType: 5121, count: 1, type: "SCALAR", byteOffset: 0 };

/**
 * @returns the accessors, by their index in the file; those that no mesh uses are not to be read.
 * @throws {LoadError} if a buffer is not there or packed data is damaged.
 */
export async function unpackAccessors(json: GltfJson, resources: Resources): Promise<readonly Accessor[]> {
  const io = new WebIO().setLogger(new Logger(Logger.Verbosity.SILENT));
  const decoders = await loadDecoders(json);
  for (const { extension, dependency } of decoders) {
    io.registerExtensions([extension]).registerDependencies(dependency);
  }
  const names = decoders.map(({ extension }) => extension.EXTENSION_NAME);
  const document = await io.readJSON(await lean(json, resources, names)).catch((cause: unknown) => {
    if (cause instanceof LoadError) throw cause;
    throw new LoadError(`has vertex data that can't be unpacked: ${cause instanceof Error ? cause.message : cause}`, {
      cause,
    });
  });
  const accessors = document.getRoot().listAccessors();
  for (const index of usedAccessors(json)) fillWithZeros(accessors[index]!, json.accessors[index]!.count);
  return accessors;
}

/** glTF 2.0, 3.6.2: an accessor without data is all zeros. */
function fillWithZeros(accessor: Accessor, count: number): void {
  if (accessor.getArray() === null) accessor.setArray(new Uint8Array(count * accessor.getElementSize()));
}

async function loadDecoders(json: GltfJson): Promise<Decoder[]> {
  const isDraco = primitivesOf(json).some(({ extensions }) => extensions?.KHR_draco_mesh_compression !== undefined);
  const isMeshopt = json.bufferViews.some(({ extensions }) => extensions?.EXT_meshopt_compression !== undefined);
  const decoders = [
    ...(isDraco ? [import("./draco").then(({ loadDraco }) => loadDraco())] : []),
    ...(isMeshopt ? [import("./meshopt").then(({ loadMeshopt }) => loadMeshopt())] : []),
  ];
  return Promise.all(decoders);
}

/** The file with its buffers at hand, and without all that is not vertex data. */
async function lean(json: GltfJson, resources: Resources, extensions: readonly string[]): Promise<JSONDocument> {
  const accessors = usedAccessors(json);
  const views = usedViews(json, accessors);
  const isWanted = new Set<number>();
  for (const index of views) {
    const { buffer, extensions } = json.bufferViews[index]!;
    isWanted.add(extensions?.EXT_meshopt_compression?.buffer ?? buffer);
  }
  const buffers = json.buffers.map((_, i) => (isWanted.has(i) ? resources.buffer(i) : new Uint8Array()));
  const files = (await Promise.all(buffers)).map((bytes, i) => [`buffer${i}`, bytes]);
  const leanJson = {
    asset: { version: "2.0" },
    extensionsUsed: [...extensions],
    buffers: json.buffers.map(({ byteLength }, i) => ({ byteLength, uri: `buffer${i}` })),
    bufferViews: json.bufferViews.map((view, i) => (views.has(i) ? view : { buffer: view.buffer, byteLength: 0 })),
    accessors: json.accessors.map((accessor, i) => (accessors.has(i) ? accessor : UNUSED)),
    meshes: json.meshes.map(({ primitives }) => ({
      primitives: primitives.map(({ attributes, indices, extensions }) => {
        const { KHR_draco_mesh_compression: draco } = extensions ?? {};
        const packed = draco && { ...draco, attributes: onlyRead(draco.attributes) };
        return {
          attributes: onlyRead(attributes),
          indices,
          ...(packed && { extensions: { KHR_draco_mesh_compression: packed } }),
        };
      }),
    })),
  };
  // Its types also say which combinations of fields make sense.
  return { json: leanJson as unknown as GLTF.IGLTF, resources: Object.fromEntries(files) };
}

function usedAccessors(json: GltfJson): ReadonlySet<number> {
  const used = new Set<number>();
  for (const { attributes, indices } of primitivesOf(json)) {
    for (const index of Object.values(onlyRead(attributes))) used.add(index);
    if (indices !== undefined) used.add(indices);
  }
  for (const { extensions } of json.nodes) {
    for (const index of Object.values(extensions?.EXT_mesh_gpu_instancing?.attributes ?? {})) used.add(index);
  }
  return used;
}

function usedViews(json: GltfJson, accessors: ReadonlySet<number>): ReadonlySet<number> {
  const used = new Set<number | undefined>();
  for (const index of accessors) {
    const { bufferView, sparse } = json.accessors[index]!;
    used.add(bufferView).add(sparse?.indices.bufferView).add(sparse?.values.bufferView);
  }
  for (const { extensions } of primitivesOf(json)) used.add(extensions?.KHR_draco_mesh_compression?.bufferView);
  used.delete(undefined);
  return used as ReadonlySet<number>;
}

function onlyRead(attributes: Readonly<Record<string, number>>): Record<string, number> {
  return Object.fromEntries(Object.entries(attributes).filter(([semantic]) => isRead(semantic)));
}

function primitivesOf(json: GltfJson) {
  return json.meshes.flatMap(({ primitives }) => primitives);
}
