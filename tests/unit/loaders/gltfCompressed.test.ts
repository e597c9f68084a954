import { Document, type Extension, WebIO } from "@gltf-transform/core";
import { EXTMeshoptCompression, KHRDracoMeshCompression } from "@gltf-transform/extensions";
import { createEncoderModule } from "draco3dgltf/draco3dgltf.js";
import { MeshoptEncoder } from "meshoptimizer/encoder";
import { beforeAll, describe, expect, test } from "vitest";
import { loadGltf } from "../../../src/loaders/gltf";
import { parseScene } from "../../../src/scene/parseScene";
import { type MeshObject, meshesOf } from "../../support/gltf";
import { createRandom } from "../../support/random";

/** A bumpy square of 10 × 10 × 2 triangles, with normals and texture coordinates. */
async function pack(extension?: typeof Extension, dependencies: Record<string, unknown> = {}): Promise<Uint8Array> {
  const document = new Document();
  const buffer = document.createBuffer();
  const add = (type: "SCALAR" | "VEC2" | "VEC3", array: Float32Array | Uint16Array) =>
    document.createAccessor().setType(type).setArray(array.slice()).setBuffer(buffer);
  const positions: number[] = [];
  const uvs: number[] = [];
  const indices: number[] = [];
  for (let y = 0; y <= 10; y++) {
    for (let x = 0; x <= 10; x++) {
      positions.push(x / 10, (x % 3) / 10, y / 10);
      uvs.push(x / 10, y / 10);
      const corner = 11 * y + x;
      if (x < 10 && y < 10) indices.push(corner, corner + 11, corner + 1, corner + 1, corner + 11, corner + 12);
    }
  }
  const primitive = document
    .createPrimitive()
    .setAttribute("POSITION", add("VEC3", Float32Array.from(positions)))
    .setAttribute(
      "NORMAL",
      add(
        "VEC3",
        Float32Array.from(positions, (_, i) => (i % 3 === 1 ? 1 : 0)),
      ),
    )
    .setAttribute("TEXCOORD_0", add("VEC2", Float32Array.from(uvs)))
    .setIndices(add("SCALAR", Uint16Array.from(indices)));
  document.createScene().addChild(document.createNode().setMesh(document.createMesh().addPrimitive(primitive)));
  const io = new WebIO();
  if (extension !== undefined) {
    document.createExtension(extension as unknown as new (document: Document) => Extension).setRequired(true);
    io.registerExtensions([extension]).registerDependencies(dependencies);
  }
  return io.writeBinary(document);
}

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

const files: Record<string, Uint8Array> = {};
beforeAll(async () => {
  await MeshoptEncoder.ready;
  files.plain = await pack();
  files.meshopt = await pack(EXTMeshoptCompression, { "meshopt.encoder": MeshoptEncoder });
  files.draco = await pack(KHRDracoMeshCompression, { "draco3d.encoder": await createEncoderModule() });
});

describe.each(["meshopt", "draco"])("a file packed with %s", (kind) => {
  test("has the triangles it was made of", async () => {
    const load = async (bytes: Uint8Array) => meshesOf((await loadGltf(bytes)).scene)[0]!;
    const [plain, packed] = [await load(files.plain!), await load(files[kind]!)];
    expect(new TextDecoder("latin1").decode(files[kind]!)).toContain("_compression");
    expect(corners(packed)).toEqual(corners(plain));
    expect(packed.normals!.length).toBe(packed.positions.length);
  });

  test("gives a scene or a LoadError, whatever byte of it is flipped, seed 5", async () => {
    const random = createRandom(5);
    let failures = 0;
    for (let i = 0; i < 60; i++) {
      const bytes = files[kind]!.slice();
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
