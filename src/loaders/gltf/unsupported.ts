// What a file has that the scene format lacks. Each is said; none stops the rest from being shown.

import { LoadError } from "../../errors";
import { show } from "../../scene/describe";
import { listed, type Warnings } from "../warnings";
import { placeOf } from "./materials";
import type { GltfJson } from "./schema";

const SUPPORTED_EXTENSIONS = new Set([
  "EXT_mesh_gpu_instancing",
  "EXT_meshopt_compression",
  "EXT_texture_avif",
  "EXT_texture_webp",
  "KHR_draco_mesh_compression",
  "KHR_lights_punctual",
  "KHR_materials_emissive_strength",
  "KHR_materials_ior",
  "KHR_materials_unlit",
  "KHR_mesh_quantization",
  "KHR_node_visibility",
  "KHR_texture_transform",
]);

/** These say something about the file and nothing about the picture. */
const HARMLESS_EXTENSIONS = new Set(["KHR_xmp", "KHR_xmp_json_ld", "EXT_structural_metadata", "EXT_mesh_features"]);

/** @throws {LoadError} if the file says that it can't be shown without an extension that is not supported. */
export function checkExtensions({ extensionsRequired, extensionsUsed }: GltfJson, warnings: Warnings): void {
  const isUnknown = (name: string) => !SUPPORTED_EXTENSIONS.has(name) && !HARMLESS_EXTENSIONS.has(name);
  const missing = extensionsRequired.filter(isUnknown).map(show);
  if (missing.length > 0) throw new LoadError(`requires ${listed(missing)}, which is not supported`);
  for (const name of extensionsUsed.filter(isUnknown)) {
    warnings.add("A glTF extension is not supported, and what it says is left out", show(name));
  }
}

export function warnOfUnsupported(json: GltfJson, warnings: Warnings): void {
  if (json.animations !== undefined) warnings.add("Animations are not supported: the pose at rest is shown");
  if (json.scenes.length > 1) warnings.add(`Of ${json.scenes.length} scenes only the default one is shown`);
  json.nodes.forEach(({ name, skin }, i) => {
    if (skin !== undefined)
      warnings.add("Skins are not supported: the mesh is shown unbent", placeOf("nodes", i, name));
  });
  json.meshes.forEach(({ name, primitives }, i) => {
    const place = placeOf("meshes", i, name);
    for (const primitive of primitives) {
      const { attributes, targets, material } = primitive;
      const has = (semantic: string) => attributes[semantic] !== undefined;
      if (targets !== undefined) warnings.add("Morph targets are not supported: the base shape is shown", place);
      if (has("COLOR_0")) warnings.add("Vertex colours are not supported: the material's own is shown", place);
      if (has("TANGENT") && has("NORMAL") && json.materials[material ?? -1]?.normalTexture) {
        warnings.add("Tangents are computed from the texture coordinates, not read from the file", place);
      }
    }
  });
}
