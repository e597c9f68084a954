import { encode } from "fast-png";
import type { Packer, TriangleJson } from "./gltf";

/** The picture of each texture of `fullMaterial`: its index is that of the texture, and so is its name. */
const TEXTURES = [
  "transmission",
  "diffuseTransmission",
  "diffuseTransmissionColor",
  "specular",
  "specularColor",
  "clearcoat",
  "clearcoatRoughness",
  "clearcoatNormal",
  "sheenColor",
  "sheenRoughness",
  "anisotropy",
  "iridescence",
  "iridescenceThickness",
] as const;

const textureOf = (name: (typeof TEXTURES)[number]) => ({ index: TEXTURES.indexOf(name) });

/** What each extension of materials can say, with a texture wherever there can be one. */
export const FULL_EXTENSIONS = {
  KHR_materials_ior: { ior: 1.7 },
  KHR_materials_transmission: { transmissionFactor: 0.9, transmissionTexture: textureOf("transmission") },
  KHR_materials_volume: {
    thicknessFactor: 0.02,
    thicknessTexture: textureOf("transmission"),
    attenuationDistance: 0.5,
    attenuationColor: [0.9, 0.5, 0.1],
  },
  KHR_materials_dispersion: { dispersion: 0.36 },
  KHR_materials_diffuse_transmission: {
    diffuseTransmissionFactor: 0.25,
    diffuseTransmissionTexture: textureOf("diffuseTransmission"),
    diffuseTransmissionColorFactor: [1, 0.9, 0.8],
    diffuseTransmissionColorTexture: textureOf("diffuseTransmissionColor"),
  },
  KHR_materials_specular: {
    specularFactor: 0.75,
    specularTexture: textureOf("specular"),
    specularColorFactor: [2, 1, 0.5],
    specularColorTexture: textureOf("specularColor"),
  },
  KHR_materials_clearcoat: {
    clearcoatFactor: 0.6,
    clearcoatTexture: textureOf("clearcoat"),
    clearcoatRoughnessFactor: 0.3,
    clearcoatRoughnessTexture: textureOf("clearcoatRoughness"),
    clearcoatNormalTexture: { ...textureOf("clearcoatNormal"), scale: 0.5 },
  },
  KHR_materials_sheen: {
    sheenColorFactor: [0.1, 0.2, 0.3],
    sheenColorTexture: textureOf("sheenColor"),
    sheenRoughnessFactor: 0.4,
    sheenRoughnessTexture: textureOf("sheenRoughness"),
  },
  KHR_materials_anisotropy: {
    anisotropyStrength: 0.7,
    anisotropyRotation: Math.PI / 2,
    anisotropyTexture: textureOf("anisotropy"),
  },
  KHR_materials_iridescence: {
    iridescenceFactor: 0.8,
    iridescenceTexture: textureOf("iridescence"),
    iridescenceIor: 1.8,
    iridescenceThicknessMinimum: 200,
    iridescenceThicknessMaximum: 700,
    iridescenceThicknessTexture: textureOf("iridescenceThickness"),
  },
};

export type Extensions = Readonly<Record<string, object>>;

/** Gives a file's triangle texture coordinates, and a material with these extensions, of which each texture has its own picture. */
export function addSurface(json: TriangleJson, packer: Packer, extensions: Extensions, more: object = {}): void {
  const names = Object.keys(extensions);
  json.extensionsUsed = json.extensionsRequired = names;
  const data = Uint8Array.of(0, 0, 0, 0, 255, 255, 255, 255); // black and transparent above white
  const picture = encode({ width: 1, height: 2, channels: 4, data });
  json.images = TEXTURES.map((name) => ({ name, bufferView: packer.addView(picture) }));
  json.textures = TEXTURES.map((_, source) => ({ source }));
  json.materials = [{ extensions, ...more }];
  const [primitive] = json.meshes[0].primitives;
  primitive.material = 0;
  primitive.attributes.TEXCOORD_0 = packer.add(Float32Array.of(0, 0, 1, 0, 0, 1), "VEC2");
  primitive.attributes.TEXCOORD_1 = packer.add(Float32Array.of(5, 5, 6, 6, 7, 7), "VEC2");
}
