// The entry `rt-viewer/gltf`: glTF 2.0 files as scenes.

import type { Scene } from "../scene/schema";
import type { Bounds } from "./bounds";
import { frameBounds, IDLE_CAMERA, setTable } from "./frameModel";
import { checkReferences } from "./gltf/checkReferences";
import { readContainer } from "./gltf/container";
import { convertCamera } from "./gltf/convertCamera";
import { convertLights, warnOfBrightness } from "./gltf/convertLights";
import { Materials, withoutMissing } from "./gltf/materials";
import { placeNodes } from "./gltf/nodes";
import { MeshPlacer } from "./gltf/placeMeshes";
import { Resources } from "./gltf/resources";
import { parseGltfJson } from "./gltf/schema";
import { Textures } from "./gltf/textures";
import { unpackAccessors } from "./gltf/unpackAccessors";
import { checkExtensions, warnOfUnsupported } from "./gltf/unsupported";
import { applyVariant, variantNames } from "./gltf/variants";
import { isLit } from "./isLit";
import type { LoadedScene, LoadOptions } from "./loadedScene";
import { reportingAs } from "./reportingAs";
import { Warnings } from "./warnings";

export { LoadError } from "../errors";
export type { DecodedImage, DecodeImage, LoadedScene, LoadOptions } from "./loadedScene";

/**
 * Makes a scene of a glTF 2.0 file, `.glb` or `.gltf`.
 *
 * The scene has the meshes in their places, surfaces with their textures, the lights and the first camera. A file
 * without a camera gets one that has everything in view; one that nothing lights enough to be seen gets a ground, a lamp and a
 * dim sky beside what it has. It counts as lit if its lights and what emits in it give a quarter of what the camera sees at least
 * 0.11 W·m⁻², five stops less than that lamp, or if half of what the camera sees emits as much as white would reflect then. So a
 * small or dim emitter does not leave a model in the dark. Shadows are not reckoned with.
 * Light's units are taken one to one: 1 cd is 1 W·sr⁻¹, 1 lx is 1 W·m⁻², and an emission of 1 is 1 W·sr⁻¹·m⁻².
 *
 * @param bytes - of the file; not kept, not changed.
 * @throws {LoadError} if the file is damaged or truncated, needs something that is not supported, or has more than 8 million
 *   triangles. Nothing else is thrown, but the signal's reason.
 */
export async function loadGltf(bytes: Uint8Array, options: LoadOptions = {}): Promise<LoadedScene> {
  return reportingAs(options.name ?? "the file", options.signal, () => convert(bytes, options));
}

async function convert(bytes: Uint8Array, options: LoadOptions): Promise<LoadedScene> {
  const { signal } = options;
  const warnings = new Warnings();
  const { json: untrusted, binary } = readContainer(bytes);
  const parsed = parseGltfJson(untrusted);
  checkExtensions(parsed, warnings);
  checkReferences(parsed);
  const json = applyVariant(parsed, options.variant, warnings);
  warnOfUnsupported(json, warnings);

  const resources = new Resources(json, binary, options);
  const accessors = await unpackAccessors(json, resources);
  signal?.throwIfAborted();
  const textures = new Textures(json, warnings);
  const materials = new Materials(json, textures, warnings);
  const placer = new MeshPlacer(json, accessors, materials, warnings);
  const nodes = placeNodes(json, warnings);
  const visible = nodes.filter(({ isVisible }) => isVisible);
  for (const node of visible) placer.place(node);
  placer.warnOfLeftOut();
  const { objects, bounds } = placer;
  if (bounds.isEmpty) warnings.add("The file has no triangles, so there is nothing to see");

  const camera = convertCamera(json, nodes, bounds, warnings) ?? (bounds.isEmpty ? IDLE_CAMERA : frameBounds(bounds));
  const lights = convertLights(json, visible, warnings);
  warnOfBrightness(lights, bounds, warnings);
  const pictures = await textures.decode(resources, options);
  const scene: Scene = {
    camera,
    materials: withoutMissing(materials.all, pictures),
    textures: pictures,
    objects,
    lights,
  };
  signal?.throwIfAborted();
  return {
    scene: bounds.isEmpty || isLit(scene) ? scene : onTable(scene, bounds),
    warnings: warnings.list(),
    variants: variantNames(json),
  };
}

function onTable(scene: Scene, bounds: Bounds): Scene {
  const { materials = {}, objects, lights = [] } = scene;
  let name = "ground";
  while (Object.hasOwn(materials, name)) name += "'";
  const { ground, groundMaterial, light, environment } = setTable(bounds, name);
  return {
    ...scene,
    materials: { ...materials, [name]: groundMaterial },
    objects: [...objects, ground],
    lights: [...lights, light],
    environment,
  };
}
