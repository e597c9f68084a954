import { beforeAll, describe, expect, test } from "vitest";
import { loadGltf } from "../../../src/loaders/gltf";
import { parseScene } from "../../../src/scene/parseScene";
import { type MeshObject, meshesOf } from "../../support/gltf";
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
