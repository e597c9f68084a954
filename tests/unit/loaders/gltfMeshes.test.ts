import { describe, expect, test } from "vitest";
import { loadGltf } from "../../../src/loaders/gltf";
import { meshesOf, Packer, roundedNumbers, TRIANGLE, triangleFile } from "../../support/gltf";

const load = async (...change: Parameters<typeof triangleFile>) => {
  const { scene, warnings } = await loadGltf(triangleFile(...change));
  return { scene, warnings, meshes: meshesOf(scene) };
};

const HALF = Math.SQRT1_2;

describe("places", () => {
  test("a mesh at the origin keeps its vertices", async () => {
    const { meshes, warnings } = await load();
    expect(meshes).toHaveLength(1);
    expect(roundedNumbers(meshes[0]!.positions)).toEqual([...TRIANGLE]);
    expect([...meshes[0]!.indices]).toEqual([0, 1, 2]);
    expect(meshes[0]!.normals).toBeUndefined();
    expect(warnings).toEqual([]);
  });

  test("a node scales, then turns, then moves; its parent does so after it", async () => {
    const { meshes } = await load((json) => {
      json.nodes = [
        { mesh: 0, scale: [2, 3, 1], rotation: [0, 0, HALF, HALF], translation: [10, 0, 0] },
        { children: [0], matrix: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 5, 1] },
      ];
      json.scenes = [{ nodes: [1] }];
    });
    // A quarter turn around z takes (x, y) to (−y, x).
    expect(roundedNumbers(meshes[0]!.positions)).toEqual([10, 0, 5, 10, 2, 5, 7, 0, 5]);
  });

  test("a quaternion of any length turns alike", async () => {
    const { meshes } = await load((json) => {
      json.nodes[0].rotation = [0, 0, 3, 3];
    });
    expect(roundedNumbers(meshes[0]!.positions)).toEqual([0, 0, 0, 0, 1, 0, -1, 0, 0]);
  });

  test("far from the origin the shape keeps its size", async () => {
    const { meshes } = await load((json) => {
      json.nodes[0].translation = [1e9, 0, 0];
    });
    const { positions } = meshes[0]!;
    expect(positions[3]! - positions[0]!).toBe(1);
  });

  test("a mirror turns the winding around, so that fronts stay fronts", async () => {
    const { meshes } = await load((json, packer) => {
      json.nodes[0].scale = [-1, 1, 1];
      json.meshes[0].primitives[0].attributes.NORMAL = packer.add(Float32Array.of(0, 0, 1, 0, 0, 1, 0, 0, 1), "VEC3");
    });
    expect(roundedNumbers(meshes[0]!.positions)).toEqual([0, 0, 0, -1, 0, 0, 0, 1, 0]);
    expect([...meshes[0]!.indices]).toEqual([0, 2, 1]);
    expect(roundedNumbers(meshes[0]!.normals)).toEqual([0, 0, 1, 0, 0, 1, 0, 0, 1]);
  });

  test("two mirrors make none", async () => {
    const { meshes } = await load((json) => {
      json.nodes[0].scale = [-1, -1, 1];
    });
    expect([...meshes[0]!.indices]).toEqual([0, 1, 2]);
  });

  test("normals stay across a surface that is stretched", async () => {
    const { meshes } = await load((json, packer) => {
      json.nodes[0].scale = [2, 1, 1];
      const normals = Float32Array.of(HALF, HALF, 0, 0, 0, 1, 0, 0, 2);
      json.meshes[0].primitives[0].attributes.NORMAL = packer.add(normals, "VEC3");
    });
    // (1, 1) is across (1, −1), which becomes (2, −1): (1, 2) is across that.
    const [x, y] = [1 / Math.sqrt(5), 2 / Math.sqrt(5)];
    expect(roundedNumbers(meshes[0]!.normals)).toEqual(roundedNumbers([x, y, 0, 0, 0, 1, 0, 0, 1]));
  });

  test("a mesh that is flattened keeps normals across its plane", async () => {
    const { meshes } = await load((json, packer) => {
      json.nodes[0].scale = [1, 1, 0];
      json.meshes[0].primitives[0].attributes.NORMAL = packer.add(Float32Array.of(0, 0, 1, 0, 0, 1, 0, 0, 1), "VEC3");
    });
    expect(roundedNumbers(meshes[0]!.normals)).toEqual([0, 0, 1, 0, 0, 1, 0, 0, 1]);
  });

  test("a mesh of two nodes is there twice", async () => {
    const { meshes } = await load((json) => {
      json.nodes = [{ mesh: 0 }, { mesh: 0, translation: [0, 0, 7] }];
      json.scenes = [{ nodes: [0, 1] }];
    });
    expect(meshes.map(({ positions }) => positions[2])).toEqual([0, 7]);
  });

  test("EXT_mesh_gpu_instancing places a mesh where each instance is, in the node's space", async () => {
    const { meshes, warnings } = await load((json, packer) => {
      const attributes = {
        TRANSLATION: packer.add(Float32Array.of(1, 0, 0, 2, 0, 0), "VEC3"),
        SCALE: packer.add(Float32Array.of(1, 1, 1, 3, 3, 3), "VEC3"),
      };
      json.extensionsUsed = ["EXT_mesh_gpu_instancing"];
      json.nodes[0] = { mesh: 0, translation: [0, 5, 0], extensions: { EXT_mesh_gpu_instancing: { attributes } } };
    });
    expect(meshes.map(({ positions }) => roundedNumbers(positions))).toEqual([
      [1, 5, 0, 2, 5, 0, 1, 6, 0],
      [2, 5, 0, 5, 5, 0, 2, 8, 0],
    ]);
    expect(warnings).toEqual([]);
  });

  test("only the default scene is shown, and that is said", async () => {
    const { meshes, warnings } = await load((json) => {
      json.nodes.push({ mesh: 0 });
      json.scenes.push({ nodes: [1] });
      json.scene = 1;
    });
    expect(meshes).toHaveLength(1);
    expect(warnings).toEqual(["Of 2 scenes only the default one is shown"]);
  });

  test("without a scene every root is shown", async () => {
    const { meshes } = await load((json) => {
      json.nodes = [{ mesh: 0 }, { children: [0] }, { mesh: 0 }];
      json.scenes = undefined;
      json.scene = undefined;
    });
    expect(meshes).toHaveLength(2);
  });
});

describe("vertex data", () => {
  const SQUARE = Float32Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0);
  const withMode = (mode: number, indices?: Uint8Array | Uint16Array) =>
    load((json, packer) => {
      const primitive = { attributes: { POSITION: packer.add(SQUARE, "VEC3") }, mode };
      json.meshes[0].primitives = [{ ...primitive, ...(indices && { indices: packer.add(indices, "SCALAR") }) }];
    });

  test("strips become triangles that all face the same way", async () => {
    const { meshes } = await withMode(5, Uint8Array.of(0, 1, 3, 2));
    expect([...meshes[0]!.indices]).toEqual([0, 1, 3, 1, 2, 3]);
  });

  test("fans become triangles around their first vertex", async () => {
    const { meshes } = await withMode(6);
    expect([...meshes[0]!.indices]).toEqual([1, 2, 0, 2, 3, 0]);
  });

  test("an incomplete triangle at the end is dropped", async () => {
    const { meshes } = await withMode(4, Uint16Array.of(0, 1, 2, 0, 2));
    expect([...meshes[0]!.indices]).toEqual([0, 1, 2]);
  });

  test.each([0, 1, 2, 3])("points and lines, mode %i, are left out, and that is said", async (mode) => {
    const { meshes, warnings } = await withMode(mode);
    expect(meshes).toEqual([]);
    expect(warnings).toContain("Points and lines are not shown: 1 primitive of 4 vertices left out (meshes[0])");
    expect(warnings).toContain("The file has no triangles, so there is nothing to see");
  });

  test("points and lines beside triangles are counted, once for each mesh that is shown", async () => {
    const { meshes, warnings } = await load((json, packer) => {
      const attributes = { POSITION: packer.add(SQUARE, "VEC3") };
      json.meshes[0].primitives.push({ attributes, mode: 0 }, { attributes, mode: 3 });
      json.meshes.push(
        { primitives: [{ attributes, mode: 1 }], name: "wire" },
        { primitives: [{ attributes, mode: 1 }] },
      );
      json.nodes = [{ mesh: 0 }, { mesh: 1 }, { mesh: 0 }, { mesh: 2 }];
      json.scenes = [{ nodes: [0, 1, 2] }];
    });
    expect(meshes).toHaveLength(2);
    expect(warnings).toEqual([
      'Points and lines are not shown: 3 primitives of 12 vertices left out (meshes[0], meshes[1] "wire")',
    ]);
  });

  test("of vertices that several primitives share, each gets its own", async () => {
    const { meshes } = await load((json, packer) => {
      const POSITION = packer.add(Float32Array.of(...SQUARE, ...SQUARE), "VEC3");
      const part = (...indices: number[]) => ({
        attributes: { POSITION },
        indices: packer.add(Uint16Array.from(indices), "SCALAR"),
      });
      json.meshes[0].primitives = [part(0, 1, 2), part(5, 6, 7)];
    });
    expect(meshes.map(({ positions }) => positions.length)).toEqual([9, 9]);
    expect(roundedNumbers(meshes[1]!.positions)).toEqual([1, 0, 0, 1, 1, 0, 0, 1, 0]);
    expect([...meshes[1]!.indices]).toEqual([0, 1, 2]);
  });

  test("interleaved data is taken apart", async () => {
    const { meshes } = await load((json, packer) => {
      const floats = Float32Array.of(0, 0, 0, 9, 9, 1, 0, 0, 9, 9, 0, 1, 0, 9, 9);
      const bufferView = packer.addView(new Uint8Array(floats.buffer), { byteStride: 20 });
      packer.accessors.push({ bufferView, componentType: 5126, type: "VEC3", count: 3 });
      json.meshes[0].primitives[0].attributes.POSITION = packer.accessors.length - 1;
    });
    expect(roundedNumbers(meshes[0]!.positions)).toEqual([...TRIANGLE]);
  });

  test("sparse data replaces what it is said to", async () => {
    const { meshes } = await load((_, packer) => {
      const indices = { bufferView: packer.addView(Uint8Array.of(1)), componentType: 5121 };
      const values = { bufferView: packer.addView(new Uint8Array(Float32Array.of(4, 5, 6).buffer)) };
      packer.accessors[0]!.sparse = { count: 1, indices, values };
    });
    expect(roundedNumbers(meshes[0]!.positions)).toEqual([0, 0, 0, 4, 5, 6, 0, 1, 0]);
  });

  test("an accessor without data is zeros, which sparse data may replace", async () => {
    const { meshes, warnings } = await load((json, packer) => {
      const indices = { bufferView: packer.addView(Uint8Array.of(1, 2)), componentType: 5121 };
      const values = { bufferView: packer.addView(new Uint8Array(Float32Array.of(4, 5, 6, 7, 8, 9).buffer)) };
      const accessor = { componentType: 5126, type: "VEC3", count: 3 };
      packer.accessors.push({ ...accessor, sparse: { count: 2, indices, values } }, { ...accessor, type: "VEC2" });
      json.meshes[0].primitives[0].attributes = { POSITION: 1, TEXCOORD_0: 2 };
      json.materials = [{ normalTexture: { index: 0 } }];
      json.textures = [{}];
      packer.accessors.push({ componentType: 5123, type: "SCALAR", count: 3 });
      json.meshes[0].primitives.push({ attributes: { POSITION: 0 }, indices: 3 });
    });
    expect(roundedNumbers(meshes[0]!.positions)).toEqual([0, 0, 0, 4, 5, 6, 7, 8, 9]);
    expect([...meshes[1]!.indices]).toEqual([0, 0, 0]);
    expect(warnings).toEqual([]);
  });

  test("attributes that have no part in the picture are not looked at", async () => {
    const { meshes, warnings } = await load((json, packer) => {
      packer.accessors.push({ componentType: 5123, type: "VEC4", count: 4e9, bufferView: 77 });
      Object.assign(json.meshes[0].primitives[0].attributes, { JOINTS_0: 1, WEIGHTS_0: 99, _BATCHID: 2 });
    });
    expect(meshes).toHaveLength(1);
    expect(warnings).toEqual([]);
  });

  test.each<[string, Float32Array | Uint8Array | Uint16Array, "VEC3" | "VEC4", number[]]>([
    ["floats", Float32Array.of(0, 0.25, 2, 1, 1, 1, 0.5, 0.5, 0.5), "VEC3", [0, 0.25, 1, 1]],
    ["bytes", Uint8Array.of(0, 51, 255, 102, 0, 0, 0, 0, 0, 0, 0, 0), "VEC4", [0, 0.2, 1, 0.4]],
    ["shorts", Uint16Array.of(0, 13107, 65535, 1, 1, 1, 0, 0, 0), "VEC3", [0, 0.2, 1, 1]],
  ])("colours of vertices may be %s", async (_name, colors, type, first) => {
    const { meshes } = await load((json, packer) => {
      const { attributes } = json.meshes[0].primitives[0];
      attributes.COLOR_0 = packer.add(colors, type);
      if (!(colors instanceof Float32Array)) packer.accessors[attributes.COLOR_0]!.normalized = true;
    });
    expect([...meshes[0]!.colors!].slice(0, 4).map((value) => Number(value.toFixed(6)))).toEqual(first);
    expect(meshes[0]!.colors).toHaveLength(12);
  });

  test("a colour that is no number is white", async () => {
    const { meshes } = await load((json, packer) => {
      const colors = Float32Array.of(Number.NaN, 0, 0, 0.5, 0.5, 0.5, 0, 0, 0);
      json.meshes[0].primitives[0].attributes.COLOR_0 = packer.add(colors, "VEC3");
    });
    expect([...meshes[0]!.colors!]).toEqual([1, 1, 1, 1, 0.5, 0.5, 0.5, 1, 0, 0, 0, 1]);
  });

  test("tangents go with their nodes, and turn over in a mirror", async () => {
    const { meshes } = await load((json, packer) => {
      const { attributes } = json.meshes[0].primitives[0];
      attributes.NORMAL = packer.add(Float32Array.of(0, 0, 1, 0, 0, 1, 0, 0, 1), "VEC3");
      attributes.TANGENT = packer.add(Float32Array.of(1, 0, 0, 1, 0, 1, 0, -1, 0, 0, 0, 1), "VEC4");
      json.nodes[0].scale = [-2, 3, 1];
    });
    expect([...meshes[0]!.tangents!].map((value) => value + 0)).toEqual([-1, 0, 0, -1, 0, 1, 0, 1, 0, 0, 0, 0]);
  });

  test("quantised positions and normals, KHR_mesh_quantization, are what they stand for", async () => {
    const { meshes, warnings } = await load((json, packer) => {
      json.extensionsUsed = json.extensionsRequired = ["KHR_mesh_quantization"];
      const positions = Int16Array.of(0, 0, 0, 300, 0, 0, 0, -300, 0);
      const normals = Int8Array.of(0, 0, 127, 0, 0, -127, -128, 0, 0);
      json.meshes[0].primitives[0].attributes = {
        POSITION: packer.add(positions, "VEC3"),
        NORMAL: packer.add(normals, "VEC3", { normalized: true }),
      };
    });
    expect([...meshes[0]!.positions]).toEqual([...Int16Array.of(0, 0, 0, 300, 0, 0, 0, -300, 0)]);
    expect([...meshes[0]!.normals!]).toEqual([0, 0, 1, 0, 0, -1, -1, 0, 0]);
    expect(warnings).toEqual([]);
  });

  test("accessors that no mesh uses are not looked at", async () => {
    const { meshes } = await load((_, packer) => {
      packer.accessors.push({ componentType: 5126, type: "MAT4", count: 4_000_000_000 });
    });
    expect(meshes).toHaveLength(1);
  });
});

describe("files", () => {
  const packer = new Packer();
  const meshes = [{ primitives: [{ attributes: { POSITION: packer.add(TRIANGLE, "VEC3") } }] }];
  const { byteLength } = packer.binary;
  const gltf = (uri: string) =>
    new TextEncoder().encode(
      JSON.stringify({
        asset: { version: "2.0" },
        ...packer.json,
        buffers: [{ uri, byteLength }],
        meshes,
        nodes: [{ mesh: 0 }],
        scenes: [{ nodes: [0] }],
      }),
    );

  test("a .gltf has its data within", async () => {
    const base64 = btoa(String.fromCharCode(...packer.binary));
    const { scene } = await loadGltf(gltf(`data:application/octet-stream;base64,${base64}`));
    expect(roundedNumbers(meshesOf(scene)[0]!.positions)).toEqual([...TRIANGLE]);
  });

  test.each(["DATA:application/octet-stream;BASE64,", "Data:;Base64,", "dATA:application/gltf-buffer;x=y;bAsE64,"])(
    "%s begins such data too: neither word has a case",
    async (start) => {
      const base64 = btoa(String.fromCharCode(...packer.binary));
      const { scene } = await loadGltf(gltf(start + base64));
      expect(roundedNumbers(meshesOf(scene)[0]!.positions)).toEqual([...TRIANGLE]);
    },
  );

  test("or beside it, relative to its own address", async () => {
    const asked: string[] = [];
    const fetchResource = async (url: string) => {
      asked.push(url);
      return packer.binary;
    };
    const { scene } = await loadGltf(gltf("a%20b.bin"), { baseUrl: "https://x.org/m/a.gltf", fetchResource });
    expect(asked).toEqual(["https://x.org/m/a%20b.bin"]);
    expect(meshesOf(scene)).toHaveLength(1);
  });

  test("what is not there is named", async () => {
    const fetchResource = async () => {
      throw new Error("a.bin: 404");
    };
    await expect(loadGltf(gltf("a.bin"), { name: "m.gltf", fetchResource })).rejects.toMatchObject({
      name: "LoadError",
      message: "m.gltf: buffers[0]: a.bin: 404",
    });
  });

  test("an aborted load rejects with the reason", async () => {
    const controller = new AbortController();
    const fetchResource = async () => {
      controller.abort(new Error("changed my mind"));
      return packer.binary;
    };
    const load = loadGltf(gltf("a.bin"), { fetchResource, signal: controller.signal });
    await expect(load).rejects.toThrow("changed my mind");
    await expect(load).rejects.not.toMatchObject({ name: "LoadError" });
  });
});
