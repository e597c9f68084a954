import { encode } from "fast-png";
import { Packer, TRIANGLE } from "./gltf";

/**
 * A .glb with one of each thing that the loader reads, and nothing that it does not.
 *
 * @param more - JSON to add.
 */
export function everythingFile(more: Readonly<Record<string, unknown>> = {}): Uint8Array {
  const packer = new Packer();
  const picture = encode({ width: 2, height: 2, channels: 3, data: Uint8Array.from({ length: 12 }, (_, i) => 20 * i) });
  const sparse = {
    count: 1,
    indices: { bufferView: packer.addView(Uint8Array.of(2)), componentType: 5121 },
    values: { bufferView: packer.addView(new Uint8Array(Float32Array.of(0, 2, 0).buffer)) },
  };
  const POSITION = packer.add(TRIANGLE, "VEC3", { sparse });
  const NORMAL = packer.add(Int8Array.of(0, 0, 127, 0, 0, 127, 0, 0, 127), "VEC3", {
    normalized: true,
  });
  const TEXCOORD_0 = packer.add(Uint16Array.of(0, 0, 65535, 0, 0, 65535), "VEC2", { normalized: true });
  const indices = packer.add(Uint16Array.of(0, 1, 2), "SCALAR");
  const TRANSLATION = packer.add(Float32Array.of(1, 0, 0, 0, 1, 0), "VEC3");
  const ROTATION = packer.add(Float32Array.of(0, 0, 0, 1, 0, 1, 0, 1), "VEC4");
  const transform = { KHR_texture_transform: { offset: [0.5, 0], rotation: 1, scale: [2, 2] } };
  return packer.file({
    extensionsUsed: ["KHR_lights_punctual", "KHR_materials_ior", "KHR_texture_transform", "EXT_mesh_gpu_instancing"],
    images: [{ bufferView: packer.addView(picture), mimeType: "image/png" }],
    samplers: [{ wrapS: 33071, wrapT: 10497, magFilter: 9729 }],
    textures: [{ source: 0, sampler: 0 }],
    materials: [
      {
        name: "textured",
        pbrMetallicRoughness: {
          baseColorFactor: [0.5, 0.6, 0.7, 1],
          metallicFactor: 0,
          baseColorTexture: { index: 0, extensions: transform },
          metallicRoughnessTexture: { index: 0, extensions: transform },
        },
        normalTexture: { index: 0, scale: 0.5, extensions: transform },
      },
      {
        name: "lamp",
        emissiveFactor: [1, 1, 1],
        extensions: { KHR_materials_emissive_strength: { emissiveStrength: 5 }, KHR_materials_ior: { ior: 1.4 } },
      },
    ],
    meshes: [
      { primitives: [{ attributes: { POSITION, NORMAL, TEXCOORD_0 }, indices, material: 0 }] },
      { primitives: [{ attributes: { POSITION }, material: 1, mode: 5 }] },
    ],
    cameras: [{ type: "perspective", perspective: { yfov: 0.7, znear: 0.1 } }],
    extensions: { KHR_lights_punctual: { lights: [{ type: "point", intensity: 5, color: [1, 1, 1] }] } },
    nodes: [
      { children: [1, 2], scale: [1, 1, -1] },
      { mesh: 0, rotation: [0, 1, 0, 1] },
      { mesh: 1, extensions: { EXT_mesh_gpu_instancing: { attributes: { TRANSLATION, ROTATION } } } },
      { mesh: 0, matrix: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 3, 0, 0, 1] },
      { camera: 0, translation: [0, 0, 5] },
      { extensions: { KHR_lights_punctual: { light: 0 } } },
    ],
    scenes: [{ nodes: [0, 3, 4, 5] }],
    scene: 0,
    ...more,
  });
}
