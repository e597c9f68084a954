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
  "KHR_materials_anisotropy",
  "KHR_materials_clearcoat",
  "KHR_materials_diffuse_transmission",
  "KHR_materials_dispersion",
  "KHR_materials_emissive_strength",
  "KHR_materials_ior",
  "KHR_materials_iridescence",
  "KHR_materials_pbrSpecularGlossiness",
  "KHR_materials_sheen",
  "KHR_materials_specular",
  "KHR_materials_transmission",
  "KHR_materials_unlit",
  "KHR_materials_variants",
  "KHR_materials_volume",
  "KHR_mesh_quantization",
  "KHR_meshopt_compression",
  "KHR_node_visibility",
  "KHR_texture_basisu",
  "KHR_texture_transform",
]);

/** These say something about the file and nothing about the picture. */
const HARMLESS_EXTENSIONS =
  /^(KHR_xmp|KHR_xmp_json_ld|EXT_structural_metadata|EXT_mesh_features|EXT_instance_features)$/;

/** What is lost, for extensions that are not supported and leave shapes as they are. */
const LOSSES: Readonly<Record<string, string>> = {
  ADOBE_materials_clearcoat_specular: "The specular colour of clear coats is not shown",
  ADOBE_materials_clearcoat_tint: "The tint of clear coats is not shown",
  ADOBE_materials_thin_transparency: "Thin transparency is not shown: surfaces are opaque",
  AGI_articulations: "Articulations are not supported: the pose at rest is shown",
  EXT_lights_ies: "The light profiles (IES) of lamps are not supported",
  EXT_lights_image_based: "The light of the file's surroundings is not shown",
  EXT_texture_astc: "Pictures in ASTC are not shown",
  KHR_animation_pointer: "Animations are not supported: the pose at rest is shown",
  KHR_materials_volume_scatter: "The scattering of light within a material is not shown",
  KHR_techniques_webgl: "Shaders of the file are not run: plain materials are shown",
  MSFT_lod: "Levels of detail are not supported: the first is shown",
  MSFT_texture_dds: "Pictures in DDS are not shown",
};

/** Families of extensions that leave shapes, places and the layout of bytes as they are, and what is lost of each. */
const HARMLESS_FAMILIES: readonly (readonly [RegExp, string])[] = [
  [/^[A-Z]+_materials_/, "What an extension says of materials is not shown"],
  [/^[A-Z]+_lights_/, "Lights of an extension are not shown"],
  [/^[A-Z]+_textures?_/, "Pictures or textures of an extension are not shown"],
  [/^[A-Z]+_animation_/, "Animations are not supported: the pose at rest is shown"],
  [
    /^(KHR|MSFT|OMI|EXT)_(audio|interactivity|behavior|physics|collision|rigid|node_(selectab|hoverab))/,
    "What an extension says of sound, motion or behaviour has no effect",
  ],
  [/^KHR_xmp/, "Metadata of an extension is not read"],
];

/**
 * Warns of each extension that is not supported, and says what is lost.
 *
 * @throws {LoadError} if the file requires one that may change shapes, places or how its bytes are read: without it the picture
 *   could be of anything.
 */
export function checkExtensions({ extensionsRequired, extensionsUsed }: GltfJson, warnings: Warnings): void {
  const isUnknown = (name: string) => !SUPPORTED_EXTENSIONS.has(name) && !HARMLESS_EXTENSIONS.test(name);
  const missing = extensionsRequired.filter((name) => isUnknown(name) && lossOf(name) === undefined).map(show);
  if (missing.length > 0) {
    throw new LoadError(`requires ${listed(missing)}, which is not supported and may change its shapes`);
  }
  for (const name of new Set([...extensionsUsed, ...extensionsRequired].filter(isUnknown))) {
    warnings.add(lossOf(name) ?? "A glTF extension is not supported, and what it says is left out", show(name));
  }
}

function lossOf(name: string): string | undefined {
  return Object.hasOwn(LOSSES, name) ? LOSSES[name] : HARMLESS_FAMILIES.find(([family]) => family.test(name))?.[1];
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
    for (const { targets } of primitives) {
      if (targets !== undefined) warnings.add("Morph targets are not supported: the base shape is shown", place);
    }
  });
}
