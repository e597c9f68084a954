// The part of glTF 2.0 that is read. Parsing drops everything else, so that nothing unchecked goes further.
//
// Names of extensions are keys here; what they hold is described in the Khronos registry.

import * as v from "valibot";
import { LoadError } from "../../errors";
import { formatPath, show } from "../../scene/describe";
import { MaterialSchema } from "./materialSchema";
import { color, count, finite, index, isFlagged, name, nonNegative, vec3, vec4 } from "./schemaParts";

const MAX_STRIDE = 252; // the specification's; also what meshopt can have

const Buffer = v.object({ uri: v.optional(v.string()), byteLength: count });

const MeshoptView = v.object({
  buffer: index,
  byteOffset: v.optional(index, 0),
  byteLength: count,
  byteStride: v.pipe(count, v.maxValue(256)),
  count,
  mode: v.picklist(["ATTRIBUTES", "TRIANGLES", "INDICES"]),
  filter: v.optional(v.picklist(["NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL", "COLOR"])),
});

const BufferView = v.object({
  buffer: index,
  byteOffset: v.optional(index, 0),
  byteLength: count,
  byteStride: v.optional(v.pipe(count, v.maxValue(MAX_STRIDE))),
  // What KHR_meshopt_compression holds is read by the same decoder: under one name, the rest of the loader sees one extension.
  extensions: v.optional(
    v.pipe(
      v.object({
        EXT_meshopt_compression: v.optional(MeshoptView),
        KHR_meshopt_compression: v.optional(MeshoptView),
      }),
      v.transform(({ EXT_meshopt_compression: ext, KHR_meshopt_compression: khr }) => ({
        EXT_meshopt_compression: ext ?? khr,
      })),
    ),
  ),
});

const SparsePart = { bufferView: index, byteOffset: v.optional(index, 0) };
const Accessor = v.object({
  bufferView: v.optional(index),
  byteOffset: v.optional(index, 0),
  componentType: v.picklist([5120, 5121, 5122, 5123, 5125, 5126]),
  normalized: isFlagged,
  count,
  type: v.picklist(["SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"]),
  sparse: v.optional(
    v.object({
      count,
      indices: v.object({ ...SparsePart, componentType: v.picklist([5121, 5123, 5125]) }),
      values: v.object(SparsePart),
    }),
  ),
});

const Image = v.object({
  name,
  uri: v.optional(v.string()),
  mimeType: v.optional(v.string()),
  bufferView: v.optional(index),
});
const Sampler = v.object({
  magFilter: v.optional(index),
  minFilter: v.optional(index),
  wrapS: v.optional(v.picklist([33071, 33648, 10497])),
  wrapT: v.optional(v.picklist([33071, 33648, 10497])),
});
const TextureSource = v.optional(v.object({ source: index }));
const Texture = v.object({
  sampler: v.optional(index),
  source: v.optional(index),
  extensions: v.optional(
    v.object({ EXT_texture_webp: TextureSource, EXT_texture_avif: TextureSource, KHR_texture_basisu: TextureSource }),
  ),
});

const Attributes = v.record(v.string(), index);
const Primitive = v.object({
  attributes: Attributes,
  indices: v.optional(index),
  material: v.optional(index),
  mode: v.optional(v.pipe(index, v.maxValue(6)), 4),
  targets: v.optional(v.unknown()),
  extensions: v.optional(
    v.object({
      KHR_draco_mesh_compression: v.optional(v.object({ bufferView: index, attributes: Attributes })),
      KHR_materials_variants: v.optional(
        v.object({ mappings: v.array(v.object({ material: index, variants: v.array(index) })) }),
      ),
    }),
  ),
});
const Mesh = v.object({ name, primitives: v.array(Primitive) });

const Camera = v.object({
  name,
  type: v.picklist(["perspective", "orthographic"]),
  perspective: v.optional(
    v.object({ yfov: v.pipe(finite, v.gtValue(0), v.ltValue(Math.PI)), znear: v.optional(finite) }),
  ),
  orthographic: v.optional(v.object({ ymag: v.optional(finite, 0), znear: v.optional(finite, 0) })),
});

const Node = v.object({
  name,
  children: v.optional(v.array(index)),
  mesh: v.optional(index),
  camera: v.optional(index),
  skin: v.optional(v.unknown()),
  matrix: v.optional(v.pipe(v.array(finite), v.length(16))),
  translation: v.optional(vec3),
  rotation: v.optional(vec4),
  scale: v.optional(vec3),
  extensions: v.optional(
    v.object({
      KHR_lights_punctual: v.optional(v.object({ light: index })),
      EXT_mesh_gpu_instancing: v.optional(v.object({ attributes: Attributes })),
      KHR_node_visibility: v.optional(v.object({ visible: isFlagged })),
    }),
  ),
});

const Light = v.object({
  name,
  type: v.picklist(["point", "spot", "directional"]),
  color: v.optional(color),
  intensity: v.optional(nonNegative),
  range: v.optional(finite),
  spot: v.optional(v.object({ innerConeAngle: v.optional(finite), outerConeAngle: v.optional(finite) })),
});

const list = <T extends v.GenericSchema>(item: T) => v.optional(v.array(item), []);

const GltfSchema = v.object({
  asset: v.object({ version: v.string(), minVersion: v.optional(v.string()) }),
  extensionsUsed: list(v.string()),
  extensionsRequired: list(v.string()),
  buffers: list(Buffer),
  bufferViews: list(BufferView),
  accessors: list(Accessor),
  images: list(Image),
  samplers: list(Sampler),
  textures: list(Texture),
  materials: list(MaterialSchema),
  meshes: list(Mesh),
  cameras: list(Camera),
  nodes: list(Node),
  scenes: list(v.object({ nodes: v.optional(v.array(index), []) })),
  scene: v.optional(index),
  animations: v.optional(v.unknown()),
  extensions: v.optional(
    v.object({
      KHR_lights_punctual: v.optional(v.object({ lights: v.array(Light) })),
      KHR_materials_variants: v.optional(v.object({ variants: v.array(v.object({ name: v.string() })) })),
    }),
  ),
});

/** A glTF file's JSON: well-formed, though what it refers to may not be there. */
export type GltfJson = v.InferOutput<typeof GltfSchema>;
export type GltfAccessor = GltfJson["accessors"][number];
export type GltfPrimitive = GltfJson["meshes"][number]["primitives"][number];

/**
 * Checks the form of a glTF file's JSON.
 *
 * @throws {LoadError} with the first thing that is wrong, and its path.
 */
export function parseGltfJson(input: unknown): GltfJson {
  const parsed = v.safeParse(GltfSchema, input, { abortEarly: true });
  if (!parsed.success) {
    const [{ path, expected, type, input: value }] = parsed.issues;
    const what = value === undefined ? "is missing" : `expected ${expected ?? type}, got ${show(value)}`;
    throw new LoadError(`${formatPath((path ?? []).map(({ key }) => key)) || "JSON"}: ${what}`);
  }
  const { version, minVersion = "2.0" } = parsed.output.asset;
  if (!version.startsWith("2.") || minVersion !== "2.0") {
    throw new LoadError(`is glTF of version ${version}; only version 2.0 can be read`);
  }
  return parsed.output;
}
