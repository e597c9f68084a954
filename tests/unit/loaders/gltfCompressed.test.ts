import { MeshoptEncoder } from "meshoptimizer/encoder";
import { beforeAll, describe, expect, test } from "vitest";
import { loadGltf } from "../../../src/loaders/gltf";
import { parseScene } from "../../../src/scene/parseScene";
import { type MeshObject, meshesOf, triangleFile } from "../../support/gltf";
import { packedFiles } from "../../support/packedGltf";
import { createRandom } from "../../support/random";

/** The corners of every triangle, in an order that does not depend on how vertices and triangles are numbered. */
function corners({ positions, indices }: MeshObject): string[] {
  const point = (index: number) => [0, 1, 2].map((axis) => (positions[3 * index + axis]! + 2).toFixed(2)).join(" ");
  const triangles: string[] = [];
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [point(indices[i]!), point(indices[i + 1]!), point(indices[i + 2]!)] as [string, string, string];
    triangles.push([`${a},${b},${c}`, `${b},${c},${a}`, `${c},${a},${b}`].sort()[0]!);
  }
  return triangles.sort();
}

let files: Awaited<ReturnType<typeof packedFiles>>;
beforeAll(async () => {
  files = await packedFiles();
});

/** The same file with the name that Khronos gave the extension, which is as long. */
function withKhrName(bytes: Uint8Array): Buffer {
  const text = Buffer.from(bytes).toString("latin1");
  return Buffer.from(text.replaceAll("EXT_meshopt_compression", "KHR_meshopt_compression"), "latin1");
}

describe("KHR_meshopt_compression", () => {
  test("is read as EXT_meshopt_compression is", async () => {
    const khr = withKhrName(files.meshopt);
    expect(khr.includes("EXT_meshopt_compression")).toBe(false);
    const { scene, warnings } = await loadGltf(khr);
    expect(corners(meshesOf(scene)[0]!)).toEqual(corners(meshesOf((await loadGltf(files.plain)).scene)[0]!));
    expect(warnings).toEqual([]);
  });

  test.each([0, 1])("has vertices in streams of version %i", async (version) => {
    await MeshoptEncoder.ready;
    const random = createRandom(9);
    const count = 300;
    const positions = Float32Array.from({ length: 3 * count }, () => random());
    const packed = MeshoptEncoder.encodeGltfBuffer(new Uint8Array(positions.buffer), count, 12, "ATTRIBUTES", version);
    expect(packed[0]! & 0xf).toBe(version);
    const bytes = triangleFile((json, packer) => {
      packer.addView(packed);
      const { byteOffset, byteLength } = packer.bufferViews.pop() as { byteOffset: number; byteLength: number };
      const meshopt = { buffer: 0, byteOffset, byteLength, byteStride: 12, count, mode: "ATTRIBUTES" };
      packer.bufferViews.push({
        buffer: 1,
        byteLength: 12 * count,
        extensions: { KHR_meshopt_compression: meshopt },
      });
      packer.accessors.push({ bufferView: packer.bufferViews.length - 1, componentType: 5126, type: "VEC3", count });
      json.meshes[0].primitives[0].attributes.POSITION = packer.accessors.length - 1;
      json.extensionsRequired = ["KHR_meshopt_compression"];
      json.buffers = [
        { byteLength: packer.binary.length },
        { byteLength: 12 * count, extensions: { KHR_meshopt_compression: { fallback: true } } },
      ];
    });
    expect([...meshesOf((await loadGltf(bytes)).scene)[0]!.positions]).toEqual([...positions]);
  });
});

describe.each(["meshopt", "draco"] as const)("a file packed with %s", (kind) => {
  test("has the triangles it was made of", async () => {
    const load = async (bytes: Uint8Array) => meshesOf((await loadGltf(bytes)).scene)[0]!;
    const [plain, packed] = [await load(files.plain), await load(files[kind])];
    expect(new TextDecoder("latin1").decode(files[kind])).toContain("_compression");
    expect(corners(packed)).toEqual(corners(plain));
    expect(packed.normals!.length).toBe(packed.positions.length);
  });

  test("gives a scene or a LoadError, whatever byte of it is flipped, seed 5", async () => {
    const random = createRandom(5);
    let failures = 0;
    for (let i = 0; i < 60; i++) {
      const bytes = files[kind].slice();
      bytes[Math.floor(random() * bytes.length)]! ^= 1 << Math.floor(random() * 8);
      try {
        parseScene((await loadGltf(bytes)).scene);
      } catch (error) {
        expect(error).toMatchObject({ name: "LoadError" });
        failures += 1;
      }
    }
    expect(failures).toBeGreaterThan(10);
  });
});
