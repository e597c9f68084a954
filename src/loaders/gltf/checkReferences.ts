// Whether everything that a glTF file refers to is there: the rest of the loader trusts it.

import { LoadError } from "../../errors";
import { MAX_UNPACKED_BYTES, MAX_VERTICES } from "../limits";
import type { GltfTextureInfo } from "./materialSchema";
import { isRead } from "./primitive";
import type { GltfAccessor, GltfJson, GltfPrimitive } from "./schema";

const COMPONENT_BYTES: Readonly<Record<GltfAccessor["componentType"], number>> = {
  5120: 1,
  5121: 1,
  5122: 2,
  5123: 2,
  5125: 4,
  5126: 4,
};
const COMPONENTS: Readonly<Record<GltfAccessor["type"], number>> = {
  SCALAR: 1,
  VEC2: 2,
  VEC3: 3,
  VEC4: 4,
  MAT2: 4,
  MAT3: 9,
  MAT4: 16,
};

/**
 * Checks every index and every range of bytes. The nodes need not be a forest.
 *
 * @throws {LoadError} with the first thing that is wrong, and its path.
 */
export function checkReferences(json: GltfJson): void {
  json.bufferViews.forEach((_, i) => void checkBufferView(json, i));
  const packed = json.bufferViews.filter(({ extensions }) => extensions?.EXT_meshopt_compression !== undefined);
  checkUnpacked(
    "data packed by meshopt",
    packed.reduce((sum, { byteLength }) => sum + byteLength, 0),
  );
  json.textures.forEach(({ source, sampler, extensions }, i) => {
    checkIndex(json, "images", source, `textures[${i}].source`);
    checkIndex(json, "images", extensions?.EXT_texture_webp?.source, `textures[${i}].extensions.EXT_texture_webp`);
    checkIndex(json, "images", extensions?.EXT_texture_avif?.source, `textures[${i}].extensions.EXT_texture_avif`);
    checkIndex(json, "images", extensions?.KHR_texture_basisu?.source, `textures[${i}].extensions.KHR_texture_basisu`);
    checkIndex(json, "samplers", sampler, `textures[${i}].sampler`);
  });
  json.images.forEach(({ bufferView }, i) => {
    checkIndex(json, "bufferViews", bufferView, `images[${i}].bufferView`);
  });
  json.materials.forEach((material, i) => {
    for (const [path, index] of texturesOf(material, `materials[${i}]`)) checkIndex(json, "textures", index, path);
  });
  checkMeshes(json);
  checkScenes(json);
}

/** The index of every texture below a part of a material, with its path. */
function* texturesOf(part: object, path: string): Generator<readonly [path: string, index: number]> {
  for (const [key, value] of Object.entries(part) as [string, unknown][]) {
    if (typeof value !== "object" || value === null) continue;
    if (key.endsWith("Texture")) yield [`${path}.${key}.index`, (value as GltfTextureInfo).index];
    else yield* texturesOf(value, `${path}.${key}`);
  }
}

type Lists = "buffers" | "bufferViews" | "accessors" | "images" | "samplers" | "textures" | "materials" | "meshes";

function checkIndex(json: GltfJson, list: Lists | "cameras" | "nodes", index: number | undefined, path: string): void {
  if (index === undefined || index < json[list].length) return;
  throw new LoadError(`${path}: expected the index of one of ${json[list].length} ${list}, got ${index}`);
}

function checkBufferView(json: GltfJson, i: number): void {
  const view = json.bufferViews[i]!;
  const path = `bufferViews[${i}]`;
  checkRange(json, view, path);
  const packed = view.extensions?.EXT_meshopt_compression;
  if (packed === undefined) return;
  checkRange(json, packed, `${path}, packed by meshopt`);
  if (packed.count * packed.byteStride === view.byteLength) return;
  throw new LoadError(`${path}: ${packed.count} × ${packed.byteStride} unpacked bytes don't fit ${view.byteLength}`);
}

function checkRange(
  json: GltfJson,
  range: { readonly buffer: number; readonly byteOffset: number; readonly byteLength: number },
  path: string,
): void {
  checkIndex(json, "buffers", range.buffer, `${path}.buffer`);
  const { byteLength } = json.buffers[range.buffer]!;
  const end = range.byteOffset + range.byteLength;
  if (end > byteLength) throw new LoadError(`${path}: ends at byte ${end} of a buffer of ${byteLength}`);
}

function checkMeshes(json: GltfJson): void {
  const unpacked = new Set<number>();
  const use = (index: number, path: string) => {
    checkIndex(json, "accessors", index, path);
    if (!unpacked.has(index)) checkAccessor(json, index);
    unpacked.add(index);
  };
  json.meshes.forEach(({ primitives }, i) => {
    primitives.forEach((primitive, j) => void checkPrimitive(json, primitive, `meshes[${i}].primitives[${j}]`, use));
  });
  json.nodes.forEach(({ extensions }, i) => {
    for (const accessor of Object.values(extensions?.EXT_mesh_gpu_instancing?.attributes ?? {})) {
      use(accessor, `nodes[${i}].extensions.EXT_mesh_gpu_instancing`);
    }
  });
  let bytes = 0;
  for (const index of unpacked) bytes += unpackedBytes(json.accessors[index]!);
  checkUnpacked("meshes", bytes);
}

function checkUnpacked(what: string, bytes: number): void {
  if (bytes <= MAX_UNPACKED_BYTES) return;
  throw new LoadError(`has ${what} that would unpack to ${bytes} bytes; at most ${MAX_UNPACKED_BYTES} are read`);
}

function checkPrimitive(
  json: GltfJson,
  { attributes, indices, material, extensions }: GltfPrimitive,
  path: string,
  use: (accessor: number, path: string) => void,
): void {
  const draco = extensions?.KHR_draco_mesh_compression;
  checkIndex(json, "materials", material, `${path}.material`);
  for (const mapping of extensions?.KHR_materials_variants?.mappings ?? []) {
    checkIndex(json, "materials", mapping.material, `${path}.extensions.KHR_materials_variants`);
  }
  checkIndex(json, "bufferViews", draco?.bufferView, `${path}.extensions.KHR_draco_mesh_compression`);
  for (const semantic of Object.keys(draco?.attributes ?? {})) {
    if (!(semantic in attributes)) throw new LoadError(`${path}: packs ${semantic}, which is not among its attributes`);
  }
  const vertexCount = json.accessors[attributes.POSITION ?? -1]?.count;
  for (const [semantic, accessor] of Object.entries(attributes)) {
    if (!isRead(semantic)) continue;
    use(accessor, `${path}.attributes.${semantic}`);
    const { count } = json.accessors[accessor]!;
    if (count === vertexCount) continue;
    throw new LoadError(`${path}: has ${vertexCount ?? "no"} positions, but ${count} of ${semantic}`);
  }
  if (indices === undefined) return;
  use(indices, `${path}.indices`);
  const { type, componentType } = json.accessors[indices]!;
  if (type === "SCALAR" && [5121, 5123, 5125].includes(componentType)) return;
  throw new LoadError(`accessors[${indices}]: expected unsigned integers for the indices of ${path}`);
}

function checkAccessor(json: GltfJson, index: number): void {
  const accessor = json.accessors[index]!;
  const path = `accessors[${index}]`;
  const { bufferView, count, sparse } = accessor;
  if (count > 3 * MAX_VERTICES)
    throw new LoadError(`${path}.count: at most ${3 * MAX_VERTICES} are read, got ${count}`);
  if (bufferView !== undefined) checkElements(json, bufferView, accessor, path);
  if (sparse === undefined) return;
  if (sparse.count > count) throw new LoadError(`${path}.sparse.count: expected at most ${count}, got ${sparse.count}`);
  const { indices, values } = sparse;
  const items = { type: "SCALAR", count: sparse.count, ...indices } as const;
  checkElements(json, indices.bufferView, items, `${path}.sparse.indices`);
  checkElements(json, values.bufferView, { ...accessor, ...values, count: sparse.count }, `${path}.sparse.values`);
}

type Elements = Pick<GltfAccessor, "byteOffset" | "count" | "type" | "componentType">;

/** Whether the elements lie in their bufferView. */
function checkElements(json: GltfJson, bufferView: number, elements: Elements, path: string): void {
  checkIndex(json, "bufferViews", bufferView, `${path}.bufferView`);
  const { byteLength, byteStride } = json.bufferViews[bufferView]!;
  const size = elementBytes(elements);
  const end = elements.byteOffset + (elements.count - 1) * (byteStride ?? size) + size;
  if (end > byteLength) throw new LoadError(`${path}: ends at byte ${end} of a bufferView of ${byteLength}`);
}

function elementBytes({ type, componentType }: Pick<GltfAccessor, "type" | "componentType">): number {
  return COMPONENTS[type] * COMPONENT_BYTES[componentType];
}

function unpackedBytes(accessor: GltfAccessor): number {
  return accessor.count * elementBytes(accessor);
}

function checkScenes(json: GltfJson): void {
  const { nodes, scenes, scene = 0, extensions } = json;
  const lightCount = extensions?.KHR_lights_punctual?.lights.length ?? 0;
  nodes.forEach((node, i) => {
    checkIndex(json, "meshes", node.mesh, `nodes[${i}].mesh`);
    checkIndex(json, "cameras", node.camera, `nodes[${i}].camera`);
    const light = node.extensions?.KHR_lights_punctual?.light;
    if (light !== undefined && light >= lightCount) {
      throw new LoadError(`nodes[${i}]: expected the index of one of ${lightCount} lights, got ${light}`);
    }
    for (const child of node.children ?? []) checkIndex(json, "nodes", child, `nodes[${i}].children`);
  });
  if (scenes.length > 0 && scene >= scenes.length) {
    throw new LoadError(`scene: expected the index of one of ${scenes.length} scenes, got ${scene}`);
  }
  scenes.forEach(({ nodes: roots }, i) => {
    for (const root of roots) checkIndex(json, "nodes", root, `scenes[${i}].nodes`);
  });
}
