import { Document, type Extension, WebIO } from "@gltf-transform/core";
import { EXTMeshoptCompression, KHRDracoMeshCompression } from "@gltf-transform/extensions";
import { createEncoderModule } from "draco3dgltf/draco3dgltf.js";
import { MeshoptEncoder } from "meshoptimizer/encoder";

/** The same .glb three times: as it is, and packed as two extensions have it. */
export async function packedFiles(): Promise<Record<"plain" | "meshopt" | "draco", Uint8Array>> {
  await MeshoptEncoder.ready;
  return {
    plain: await pack(),
    meshopt: await pack(EXTMeshoptCompression, { "meshopt.encoder": MeshoptEncoder }),
    draco: await pack(KHRDracoMeshCompression, { "draco3d.encoder": await createEncoderModule() }),
  };
}

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
