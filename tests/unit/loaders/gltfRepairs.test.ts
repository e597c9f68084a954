import { encode } from "fast-png";
import { describe, expect, test } from "vitest";
import { decodeImage } from "../../../src/cli/decodeImage";
import { loadGltf } from "../../../src/loaders/gltf";
import { parseScene } from "../../../src/scene/parseScene";
import { meshesOf, type Packer, roundedNumbers, type TriangleJson, triangleFile } from "../../support/gltf";
import { growthOf, LINEAR } from "../../support/growth";

const load = async (change: (json: TriangleJson, packer: Packer) => void) => {
  const { scene, warnings } = await loadGltf(triangleFile(change), { decodeImage });
  parseScene(scene); // what comes out is always valid
  return { scene, warnings, meshes: meshesOf(scene) };
};

const PICTURE = encode({ width: 1, height: 1, channels: 3, data: new Uint8Array(3) });

/** A pyramid's two sides that meet at the edge from 0 to 2: the first looks to +z, the second to −x. */
const FOLD = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, -1);
const SIDES = Uint16Array.of(0, 1, 2, 0, 2, 3);
const TILTED = [0.6, 0, 0.8];

/** Two triangles with these attributes beside their positions. */
const loadFold = (attributes: Record<string, Float32Array>, more: (json: TriangleJson) => void = () => {}) =>
  load((json, packer) => {
    const [primitive] = json.meshes[0].primitives;
    primitive.attributes = { POSITION: packer.add(attributes.POSITION ?? FOLD, "VEC3") };
    primitive.indices = packer.add(SIDES, "SCALAR");
    if (attributes.NORMAL) primitive.attributes.NORMAL = packer.add(attributes.NORMAL, "VEC3");
    if (attributes.TEXCOORD_0) primitive.attributes.TEXCOORD_0 = packer.add(attributes.TEXCOORD_0, "VEC2");
    more(json);
  });

/** Normals of the corners of each triangle. */
function cornerNormals({ indices, normals }: ReturnType<typeof meshesOf>[number]) {
  return Array.from(indices, (index) => roundedNumbers(Array.from(normals!).slice(3 * index, 3 * index + 3)));
}

describe("normals that are none", () => {
  const GIVES_WAY = "Normals that are zero or not finite give way to the normals of their triangles";

  test.each([
    ["NaN", [NaN, 0, 1]],
    ["zero", [0, 0, 0]],
    ["infinite", [0, Infinity, 0]],
    ["huge", [0, 0, 3e38]],
  ])("one that is %s is its triangle's, in each of its triangles", async (_, wrong) => {
    const { meshes, warnings } = await loadFold({ NORMAL: Float32Array.of(...wrong, ...TILTED, ...TILTED, ...TILTED) });
    expect(cornerNormals(meshes[0]!)).toEqual([[0, 0, 1], TILTED, TILTED, [-1, 0, 0], TILTED, TILTED]);
    expect(warnings).toEqual([`${GIVES_WAY} (1 of 4 in meshes[0].primitives[0])`]);
  });

  test("a mirror and a turn take such a normal with them", async () => {
    const normals = Float32Array.of(NaN, 0, 0, ...TILTED, ...TILTED, ...TILTED);
    const { meshes } = await loadFold({ NORMAL: normals }, (json) => {
      json.nodes[0] = { mesh: 0, scale: [-2, 1, 1] };
    });
    // Mirrored in x, and (0.6, 0.8) across what is twice as long in x.
    const tilted = roundedNumbers([-0.3 / Math.hypot(0.3, 0.8), 0, 0.8 / Math.hypot(0.3, 0.8)]);
    expect(cornerNormals(meshes[0]!)).toEqual([[0, 0, 1], tilted, tilted, [1, 0, 0], tilted, tilted]);
  });

  test("a mesh of which none is any is faceted, without more vertices", async () => {
    const { meshes, warnings } = await loadFold({ NORMAL: new Float32Array(12) });
    expect(meshes[0]!.normals).toBeUndefined();
    expect(meshes[0]!.positions).toHaveLength(12);
    expect(warnings).toEqual([`${GIVES_WAY} (4 of 4 in meshes[0].primitives[0])`]);
  });

  test("those that no triangle uses are not counted", async () => {
    const { warnings } = await load((json, packer) => {
      const [primitive] = json.meshes[0].primitives;
      primitive.attributes = {
        POSITION: packer.add(Float32Array.of(...FOLD, 9, 9, 9), "VEC3"),
        NORMAL: packer.add(Float32Array.of(...TILTED, ...TILTED, ...TILTED, ...TILTED, NaN, NaN, NaN), "VEC3"),
      };
    });
    expect(warnings).toEqual([]);
  });
});

describe("texture coordinates", () => {
  const loadTextured = (attributes: Record<string, Float32Array>) =>
    loadFold(attributes, (json) => {
      json.materials = [{ normalTexture: { index: 0 } }];
      json.textures = [{ source: 0 }];
      json.images = [{ uri: `data:image/png;base64,${Buffer.from(PICTURE).toString("base64")}` }];
      json.meshes[0].primitives[0].material = 0;
    });

  test("stay with their vertices where a normal is none", async () => {
    const { meshes } = await loadTextured({
      NORMAL: Float32Array.of(...TILTED, ...TILTED, 0, 0, 0, ...TILTED),
      TEXCOORD_0: Float32Array.of(0, 1, 2, 3, 4, 5, 6, 7),
    });
    const [{ indices, uvs }] = meshes as [(typeof meshes)[number]];
    expect(Array.from(indices, (index) => uvs![2 * index])).toEqual([0, 2, 4, 0, 4, 6]);
  });

  test.each([NaN, -Infinity, 1e20])("that are %d become 0, and that is counted", async (wrong) => {
    const { meshes, warnings } = await loadTextured({ TEXCOORD_0: Float32Array.of(1, 1, 1, wrong, 1, 1, 1, 1) });
    expect([...meshes[0]!.uvs!]).toEqual([1, 1, 0, 0, 1, 1, 1, 1]);
    expect(warnings).toEqual([
      "Texture coordinates that are not finite are taken as 0 (1 of 4 in meshes[0].primitives[0])",
    ]);
  });
});

describe("positions that are none", () => {
  const LEFT_OUT = "Triangles with a corner at no finite place are left out";

  test.each([NaN, Infinity, -1e30])("%d leaves out its triangles, and nothing else", async (wrong) => {
    const { meshes, scene, warnings } = await loadFold({
      POSITION: Float32Array.of(...FOLD.subarray(0, 9), wrong, 0, -1),
    });
    expect([...meshes[0]!.indices]).toEqual([0, 1, 2]);
    expect(roundedNumbers(meshes[0]!.positions)).toEqual([...FOLD.subarray(0, 9)]);
    expect(roundedNumbers(scene.camera.target)).toEqual([0.5, 0.5, 0]);
    expect(warnings).toEqual([`${LEFT_OUT} (1 of 2 in meshes[0].primitives[0])`]);
  });

  test("a mesh without a finite one is not there, and the file is read", async () => {
    const { meshes, warnings } = await loadFold({ POSITION: new Float32Array(12).fill(NaN) });
    expect(meshes).toEqual([]);
    expect(warnings).toEqual([
      `${LEFT_OUT} (2 of 2 in meshes[0].primitives[0])`,
      "The file has no triangles, so there is nothing to see",
    ]);
  });

  test("an instance at no finite place is left out", async () => {
    const { meshes, warnings } = await load((json, packer) => {
      const attributes = { TRANSLATION: packer.add(Float32Array.of(1, 0, 0, NaN, 0, 0, 3, 0, 0), "VEC3") };
      json.nodes[0].extensions = { EXT_mesh_gpu_instancing: { attributes } };
    });
    expect(meshes.map(({ positions }) => positions[0])).toEqual([1, 3]);
    expect(warnings).toEqual(["Instances at no finite place are left out (1 of 3 in nodes[0])"]);
  });

  test("ten thousand primitives that share one broken array take no minutes", async () => {
    const shared = (count: number) =>
      load((json, packer) => {
        const values = new Float32Array(3 * count).map((_, i) => (i < 9 ? FOLD[i]! : NaN));
        const attributes = { POSITION: packer.add(values, "VEC3") };
        const indices = packer.add(Uint16Array.of(0, 1, 2), "SCALAR");
        json.meshes[0].primitives = Array.from({ length: count }, () => ({ attributes, indices }));
      });
    expect(await growthOf(shared, 2000)).toBeLessThan(LINEAR);
  });
});
