import { describe, expect, test } from "vitest";
import { loadScene } from "../../../src/loaders/loadScene";
import { readFiles } from "../../../src/loaders/readFiles";
import { meshesOf, Packer, TRIANGLE, triangleFile } from "../../support/gltf";

const text = (content: string) => new TextEncoder().encode(content);
const { signal } = new AbortController();

describe("a file is told by what is in it", () => {
  test("our JSON passes as it is, right or wrong", async () => {
    const scene = { camera: { position: [0, 0, 1] }, objects: "none" };
    expect(await loadScene(text(`\uFEFF ${JSON.stringify(scene)}`))).toEqual({ scene, warnings: [], variants: [] });
    expect(await loadScene(text("[1]"))).toEqual({ scene: [1], warnings: [], variants: [] });
  });

  test("our JSON has no variants, which is said where one is wanted", async () => {
    const { scene, warnings } = await loadScene(text('{"objects":[]}'), { variant: "Night" });
    expect(scene).toEqual({ objects: [] });
    expect(warnings).toEqual(['The file has no variant "Night": it has none']);
  });

  test("a .glb by its first bytes, a .gltf by its asset", async () => {
    expect(meshesOf((await loadScene(triangleFile())).scene)).toHaveLength(1);
    const { warnings } = await loadScene(text('{"asset": {"version": "2.0"}}'));
    expect(warnings).toEqual(["The file has no triangles, so there is nothing to see"]);
  });

  const foreign = {
    "a PLY file": "ply\nformat ascii 1.0\n",
    "a Wavefront OBJ file": "# Blender 4.5\n\nmtllib cube.mtl\no Cube\nv 1 1 1\n",
    "an STL file": "solid cube\n",
    "an FBX file": "Kaydara FBX Binary  \0",
  };
  test.each(Object.entries(foreign))("%s is named as what it is", async (kind, content) => {
    await expect(loadScene(text(content), { name: "cube.x" })).rejects.toMatchObject({
      name: "LoadError",
      message: `cube.x is ${kind}, which cannot be read; convert it to .glb`,
    });
  });

  test("anything else is not JSON", async () => {
    await expect(loadScene(text("<html>"), { name: "cube.x" })).rejects.toMatchObject({
      name: "LoadError",
      message: expect.stringMatching(/^cube\.x is not JSON: /),
    });
  });

  test("a megabyte of comments is looked at quickly", async () => {
    const start = performance.now();
    await expect(loadScene(text("#\r\n".repeat(350_000)))).rejects.toThrow("is not JSON");
    expect(performance.now() - start).toBeLessThan(4000); // exponential in the lines, if a pattern backtracked
  });
});

describe("files that come together", () => {
  const packer = new Packer();
  const json = {
    asset: { version: "2.0" },
    meshes: [{ primitives: [{ attributes: { POSITION: packer.add(TRIANGLE, "VEC3") } }] }],
    ...packer.json,
    nodes: [{ mesh: 0 }],
    buffers: [{ uri: "data/my%20mesh.bin", byteLength: packer.binary.length }],
  };
  const gltf = new File([JSON.stringify(json)], "model.GLTF");
  const bin = new File([packer.binary as Uint8Array<ArrayBuffer>], "My Mesh.bin");
  const notes = new File(["{}"], "notes.json");

  test("are found by name, whatever folder they are from and whatever their order", async () => {
    const { scene } = await readFiles([notes, bin, gltf], signal);
    expect(meshesOf(scene)).toHaveLength(1);
  });

  test("one that is missing is named", async () => {
    await expect(readFiles([gltf], signal)).rejects.toThrow(
      'model.GLTF: buffers[0]: "data/my%20mesh.bin" is missing: open it together with the scene',
    );
  });

  test("one alone needs no name", async () => {
    const { scene } = await readFiles([new Blob([triangleFile() as Uint8Array<ArrayBuffer>])], signal);
    expect(meshesOf(scene)).toHaveLength(1);
  });

  test("none is an error", async () => {
    await expect(readFiles([], signal)).rejects.toMatchObject({ name: "LoadError" });
  });

  test("a read that is given up rejects with the reason", async () => {
    await expect(readFiles([gltf, bin], AbortSignal.abort())).rejects.toMatchObject({ name: "AbortError" });
  });
});
