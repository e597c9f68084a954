import { encode } from "fast-png";
import { expect, test } from "vitest";
import { decodeImage } from "../../../src/cli/decodeImage";
import { loadGltf } from "../../../src/loaders/gltf";
import { renderScene } from "../../support/device";
import { Packer } from "../../support/gltf";

const SIZE = 32;

type Picture = { readonly bytes: Uint8Array } | { readonly uri: string };

/**
 * A matte quad of 2 × 2 that fills the picture, with a texture in one place of its material. A lamp of π · 10⁴ cd, 100 m in front,
 * makes its radiance its albedo, as near as makes no difference.
 */
function quadFile(picture: Picture, place: "baseColorTexture" | "normalTexture"): Uint8Array {
  const packer = new Packer();
  const attributes = {
    POSITION: packer.add(Float32Array.of(-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0), "VEC3"),
    NORMAL: packer.add(Float32Array.of(0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1), "VEC3"),
    TEXCOORD_0: packer.add(Float32Array.of(0, 1, 1, 1, 1, 0, 0, 0), "VEC2"),
  };
  const indices = packer.add(Uint16Array.of(0, 1, 2, 0, 2, 3), "SCALAR");
  const texture = { index: 0 };
  const isColor = place === "baseColorTexture";
  return packer.file({
    images: ["bytes" in picture ? { bufferView: packer.addView(picture.bytes) } : picture],
    textures: [{ source: 0 }],
    materials: [
      {
        pbrMetallicRoughness: { metallicFactor: 0, roughnessFactor: 1, ...(isColor && { [place]: texture }) },
        ...(!isColor && { [place]: texture }),
        extensions: { KHR_materials_ior: { ior: 1 } },
      },
    ],
    meshes: [{ primitives: [{ attributes, indices, material: 0 }] }],
    cameras: [{ type: "perspective", perspective: { yfov: 2 * Math.atan(1 / 100), znear: 1 } }],
    extensionsUsed: ["KHR_materials_ior", "KHR_lights_punctual"],
    extensions: { KHR_lights_punctual: { lights: [{ type: "point", intensity: Math.PI * 1e4 }] } },
    nodes: [
      { mesh: 0 },
      { camera: 0, translation: [0, 0, 100] },
      { translation: [0, 0, 100], extensions: { KHR_lights_punctual: { light: 0 } } },
    ],
    scenes: [{ nodes: [0, 1, 2] }],
    scene: 0,
  });
}

/** The radiance in the left and in the right half of the picture. */
async function halvesOf(file: Uint8Array, maxTexelBytes?: number) {
  const missing = async () => {
    throw new Error("not there");
  };
  const options = { decodeImage, fetchResource: missing, ...(maxTexelBytes !== undefined && { maxTexelBytes }) };
  const { scene, warnings } = await loadGltf(file, options);
  const { image } = await renderScene(scene, { size: [SIZE, SIZE], samples: 64 });
  const at = (x: number) => [...image.subarray(4 * (SIZE * (SIZE / 2) + x), 4 * (SIZE * (SIZE / 2) + x) + 3)];
  return { left: at(SIZE / 4), right: at((3 * SIZE) / 4), warnings };
}

function expectNear(actual: readonly number[], expected: readonly number[]): void {
  // The lamp is up to 2 · 10⁻⁴ farther from a point of the quad than from its middle: three times that in light.
  for (const [i, value] of expected.entries()) expect(Math.abs(actual[i]! - value)).toBeLessThan(2e-3);
}

test("a quad whose picture is missing is white, whether that was its colour or its normals, seed 1", async () => {
  for (const place of ["baseColorTexture", "normalTexture"] as const) {
    const { left, right, warnings } = await halvesOf(quadFile({ uri: "not-there.png" }, place));
    expectNear(left, [1, 1, 1]);
    expectNear(right, [1, 1, 1]);
    expect(warnings).toEqual([expect.stringMatching(/not there \(images\[0\] "not-there\.png"\)$/)]);
  }
});

test("a picture that was made smaller is as bright as it was, seed 1", async () => {
  const [width, height] = [256, 256];
  // Left every fourth column is white, right every other.
  const lit = (x: number) => (x < 128 ? x % 4 === 0 : x % 2 === 0);
  const data = Uint8Array.from({ length: width * height }, (_, i) => (lit(i % width) ? 255 : 0));
  const file = quadFile({ bytes: encode({ width, height, channels: 1, data }) }, "baseColorTexture");
  const { left, right, warnings } = await halvesOf(file, 4 * 16 * 16);
  expectNear(left, [137, 137, 137].map(linearOf)); // a quarter of the light, and half of it, in the nearest bytes
  expectNear(right, [188, 188, 188].map(linearOf));
  expect(Math.abs(left[0]! - 0.25)).toBeLessThan(0.003);
  expect(Math.abs(right[0]! - 0.5)).toBeLessThan(0.004);
  expect(warnings).toEqual([expect.stringContaining("at 16 × 16 instead of 256 × 256")]);
});

function linearOf(byte: number): number {
  return ((byte / 255 + 0.055) / 1.055) ** 2.4;
}
