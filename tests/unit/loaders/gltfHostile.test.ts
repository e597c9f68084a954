import { encode } from "fast-png";
import { describe, expect, test, vi } from "vitest";
import { decodeImage } from "../../../src/cli/decodeImage";
import { loadGltf } from "../../../src/loaders/gltf";
import { loadScene } from "../../../src/loaders/loadScene";
import { parseScene } from "../../../src/scene/parseScene";
import { container, glb, meshesOf, type Packer, type TriangleJson, triangleFile } from "../../support/gltf";
import { everythingFile } from "../../support/gltfEverything";
import { createRandom } from "../../support/random";

// A damaged file takes milliseconds, the largest of these, of a few megabytes of JSON, half a second; eight times that is for
// a machine with other things to do. One that began to do what the file asks for would take minutes, or the memory.
const QUICK_MS = 4000;

/** What is said of a file, or "" if it is read. */
async function complaintAbout(bytes: Uint8Array): Promise<string> {
  const start = performance.now();
  try {
    const { scene } = await loadGltf(bytes, { name: "x.glb", decodeImage });
    parseScene(scene);
    return "";
  } catch (error) {
    expect(error).toMatchObject({ name: "LoadError" });
    expect((error as Error).message.length).toBeLessThan(300);
    return (error as Error).message;
  } finally {
    expect(performance.now() - start).toBeLessThan(QUICK_MS);
  }
}

describe("what the JSON says and the file does not have", () => {
  type Change = (json: TriangleJson, packer: Packer) => void;
  const cases: Readonly<Record<string, readonly [Change, string]>> = {
    "a count of 2³²": [(_, { accessors }) => Object.assign(accessors[0]!, { count: 2 ** 32 }), "accessors[0].count"],
    "a count past the data": [
      (_, { accessors }) => Object.assign(accessors[0]!, { count: 4 }),
      "accessors[0]: ends at byte 48",
    ],
    "an offset past the data": [
      (_, { accessors }) => Object.assign(accessors[0]!, { byteOffset: 2 ** 53 }),
      "accessors[0]: ends at byte",
    ],
    "a negative offset": [
      (_, { accessors }) => Object.assign(accessors[0]!, { byteOffset: -4 }),
      "accessors[0].byteOffset: expected >=0, got -4",
    ],
    "a view past its buffer": [
      (_, { bufferViews }) => Object.assign(bufferViews[0]!, { byteOffset: 4 }),
      "bufferViews[0]: ends at byte 40 of a buffer of 36",
    ],
    "a stride past its view": [
      (_, { bufferViews }) => Object.assign(bufferViews[0]!, { byteStride: 252 }),
      "accessors[0]: ends at byte 516",
    ],
    "a buffer larger than the file": [
      (json) => Object.assign(json, { buffers: [{ byteLength: 1e15 }] }),
      "buffers[0]: should",
    ],
    "a mesh that is not there": [(json) => Object.assign(json.nodes[0], { mesh: 7 }), "nodes[0].mesh: expected"],
    "a fraction for an index": [
      (json) => Object.assign(json.nodes[0], { mesh: 0.5 }),
      "nodes[0].mesh: expected integer",
    ],
    "an attribute that is not there": [
      (json) => Object.assign(json.meshes[0].primitives[0].attributes, { NORMAL: 9 }),
      "meshes[0].primitives[0].attributes.NORMAL: expected",
    ],
    "fewer normals than positions": [
      (json, packer) => {
        json.meshes[0].primitives[0].attributes.NORMAL = packer.add(new Float32Array(6), "VEC3");
      },
      "meshes[0].primitives[0]: has 3 positions, but 2 of NORMAL",
    ],
    "an index of no vertex": [
      (json, packer) => {
        json.meshes[0].primitives[0].indices = packer.add(Uint32Array.of(0, 1, 0xffffffff), "SCALAR");
      },
      "meshes[0].primitives[0].indices: vertex 4294967295 is not one of 3",
    ],
    "indices that are floats": [
      (json, packer) => {
        json.meshes[0].primitives[0].indices = packer.add(new Float32Array(3), "SCALAR");
      },
      "accessors[1]: expected unsigned integers",
    ],
    "a scale beyond reckoning": [
      (json) => Object.assign(json.nodes[0], { scale: [1e18, 1, 1] }),
      "nodes[0]: its place or scale in the world is larger",
    ],
    "an extension that it requires": [
      (json) => Object.assign(json, { extensionsRequired: ["KHR_mesh_primitive_restart"] }),
      'x.glb requires "KHR_mesh_primitive_restart", which is not supported and may change its shapes',
    ],
    "a material of a variant that is not there": [
      (json) => {
        const mappings = [{ material: 3, variants: [0] }];
        json.meshes[0].primitives[0].extensions = { KHR_materials_variants: { mappings } };
      },
      "meshes[0].primitives[0].extensions.KHR_materials_variants: expected the index of one of 0 materials, got 3",
    ],
    "the wrong version": [(json) => Object.assign(json, { asset: { version: "1.0" } }), "x.glb is glTF of version 1.0"],
    "numbers for lists": [(json) => Object.assign(json, { nodes: 5 }), "x.glb: nodes: expected Array, got 5"],
    "nothing for a node": [
      (json) => Object.assign(json, { nodes: [null] }),
      "x.glb: nodes[0]: expected Object, got null",
    ],
    "a meshopt view of 2³² bytes": [
      (_, { bufferViews }) => {
        const packed = { buffer: 0, byteLength: 36, byteStride: 256, count: 2 ** 24, mode: "ATTRIBUTES" };
        Object.assign(bufferViews[0]!, { byteLength: 2 ** 32, extensions: { EXT_meshopt_compression: packed } });
      },
      "bufferViews[0]: ends at byte 4294967296",
    ],
  };

  test.each(Object.keys(cases))("%s", async (name) => {
    const [change, complaint] = cases[name]!;
    expect(await complaintAbout(triangleFile(change))).toContain(complaint);
  });

  test("a key of a prototype is no attribute, and no resource", async () => {
    const file = triangleFile((json) => {
      json.meshes[0].primitives[0].attributes = JSON.parse('{"POSITION": 0, "__proto__": 0, "constructor": 0}');
    });
    await complaintAbout(file);
    for (const uri of ["__proto__", "constructor", "toString"]) {
      const text = JSON.stringify({ asset: { version: "2.0" }, buffers: [{ uri, byteLength: 1 }] });
      await complaintAbout(new TextEncoder().encode(text));
    }
    expect(Reflect.has({}, "POSITION")).toBe(false);
  });
});

describe("a small file that would become a large scene", () => {
  test("by a mesh in thirty thousand places", async () => {
    const file = triangleFile((json, packer) => {
      const indices = new Uint8Array(999);
      json.meshes[0].primitives[0].indices = packer.add(indices, "SCALAR");
      json.nodes = Array.from({ length: 30_000 }, () => ({ mesh: 0 }));
      json.scenes = [{ nodes: [...json.nodes.keys()] }];
    });
    expect(await complaintAbout(file)).toContain("x.glb has more than 8388608 triangles");
  });

  test("by accessors that share bytes", async () => {
    const file = triangleFile((json, packer) => {
      const view = packer.addView(new Uint8Array(60_000));
      const count = 5_000;
      packer.accessors.push(
        ...Array.from({ length: 30_000 }, () => ({ bufferView: view, componentType: 5126, type: "VEC3", count })),
      );
      json.meshes[0].primitives = Array.from({ length: 30_000 }, (_, i) => ({ attributes: { POSITION: i + 1 } }));
    });
    expect(await complaintAbout(file)).toContain("x.glb has meshes that would unpack to 1800000000 bytes");
  });

  test("by primitives that share one large array, all of it or its two ends", async () => {
    const shared = (isIndexed: boolean) =>
      triangleFile((json, packer) => {
        const POSITION = packer.add(new Float32Array(3 * 50_000), "VEC3");
        const ends = packer.add(Uint16Array.of(0, 1, 49_999), "SCALAR");
        const primitive = { attributes: { POSITION }, ...(isIndexed && { indices: ends }) };
        json.meshes[0].primitives = Array.from({ length: 2_000 }, () => primitive);
      });
    for (const isIndexed of [false, true]) {
      expect(await complaintAbout(shared(isIndexed))).toContain("x.glb has more than 16777216 vertices");
    }
  });

  test("by a picture of 30000 × 30000, before it is decoded", async () => {
    const png = encode({ width: 1, height: 1, channels: 1, data: new Uint8Array(1) });
    const view = new DataView(png.buffer, png.byteOffset);
    view.setUint32(16, 30_000);
    view.setUint32(20, 30_000);
    const decoded = vi.fn(decodeImage);
    const { scene, warnings } = await loadGltf(texturedFile([png]), { decodeImage: decoded });
    expect(scene.textures).toEqual({});
    expect(warnings[0]).toContain("it is 30000 × 30000, which is more than 268435456 texels");
    expect(decoded).not.toHaveBeenCalled();
  });

  test("by many pictures, of which two are decoded at a time", async () => {
    const png = encode({ width: 2, height: 2, channels: 1, data: new Uint8Array(4) });
    let now = 0;
    let most = 0;
    const slowly = vi.fn(async () => {
      most = Math.max(most, ++now);
      await new Promise((resolve) => setTimeout(resolve, 5));
      now--;
      return { width: 2, height: 2, texels: new Uint8Array(16) };
    });
    const { scene } = await loadGltf(texturedFile(Array(9).fill(png)), { decodeImage: slowly });
    expect(Object.keys(scene.textures!)).toHaveLength(9);
    expect(slowly).toHaveBeenCalledTimes(9);
    expect(most).toBe(2);
  });

  test("by views that meshopt unpacks from the same bytes", async () => {
    const file = triangleFile((json, packer) => {
      const byteLength = 2 ** 28;
      const packed = { buffer: 0, byteLength: 36, byteStride: 256, count: 2 ** 20, mode: "ATTRIBUTES" };
      json.buffers = [{ byteLength: packer.binary.length }, { byteLength }];
      json.extensionsUsed = ["EXT_meshopt_compression"];
      for (let i = 0; i < 5; i++) {
        packer.bufferViews.push({ buffer: 1, byteLength, extensions: { EXT_meshopt_compression: packed } });
      }
    });
    expect(await complaintAbout(file)).toContain("has data packed by meshopt that would unpack to 1342177280 bytes");
  });

  test("by fifty million places of a mesh without triangles", async () => {
    const file = triangleFile((json, packer) => {
      const count = 3 * 2 ** 24;
      const sparse = { count: 1, indices: { bufferView: 0, componentType: 5121 }, values: { bufferView: 0 } };
      packer.accessors.push({ componentType: 5121, type: "VEC3", normalized: true, count, sparse });
      json.meshes[0].primitives[0].mode = 0;
      const attributes = { TRANSLATION: packer.accessors.length - 1 };
      json.nodes = [{ mesh: 0, extensions: { EXT_mesh_gpu_instancing: { attributes } } }];
    });
    expect(await complaintAbout(file)).toBe("");
  });

  test("by a chain of a hundred thousand nodes, which is only deep", async () => {
    const file = triangleFile((json) => {
      json.nodes = Array.from({ length: 100_000 }, (_, i) => (i < 99_999 ? { children: [i + 1] } : { mesh: 0 }));
    });
    expect(await complaintAbout(file)).toBe("");
  });
});

describe("a file with a lot to say", () => {
  const many = (length: number, text: (i: number) => unknown) => Array.from({ length }, (_, i) => text(i));

  test("is not quoted at length", async () => {
    const long = "x".repeat(1e6);
    const required = triangleFile((json) => Object.assign(json, { extensionsRequired: many(1e5, (i) => `EXT_${i}`) }));
    expect(await complaintAbout(required)).toBe(
      'x.glb requires "EXT_0", "EXT_1", "EXT_2" and 99997 more, which is not supported and may change its shapes',
    );
    const set = `TEXCOORD_${"1".repeat(1e6)}`;
    const attribute = triangleFile((json) => Object.assign(json.meshes[0].primitives[0].attributes, { [set]: 9 }));
    await expect(loadGltf(attribute)).rejects.toThrow(/^.{900,1100}…$/);
    const buffers = [{ uri: long, byteLength: 1 }];
    const { message } = await loadGltf(triangleFile((json) => Object.assign(json, { buffers }))).catch(
      (error) => error,
    );
    expect(message.length).toBeLessThan(1100);
  });

  test("gives a hundred warnings, and their number", async () => {
    const file = triangleFile((json) => {
      const extensions = (i: number) => ({ KHR_materials_ior: { ior: (i + 1) / 1000 } });
      json.materials = many(500, (i) => ({ extensions: extensions(i) }));
      const [primitive] = json.meshes[0].primitives;
      json.meshes[0].primitives = many(500, (material) => ({ ...primitive, material }));
    });
    const { warnings } = await loadGltf(file);
    expect(warnings).toHaveLength(101);
    expect(warnings.at(-1)).toBe("… and 400 more");
  });

  test("in base64 is decoded in slices, as a whole", async () => {
    const bytes = new Uint8Array(3e6).map((_, i) => i * 7);
    const base64 = Buffer.from(bytes).toString("base64");
    const withUri = (uri: string) => {
      const buffers = [{ uri, byteLength: bytes.length }];
      const bufferViews = [{ buffer: 0, byteLength: bytes.length }];
      const accessors = [{ bufferView: 0, componentType: 5121, type: "VEC3", count: 1e6 }];
      const meshes = [{ primitives: [{ attributes: { POSITION: 0 } }] }];
      const json = { asset: { version: "2.0" }, buffers, bufferViews, accessors, meshes, nodes: [{ mesh: 0 }] };
      return new TextEncoder().encode(JSON.stringify(json));
    };
    const start = "data:application/octet-stream;base64,";
    const { scene } = await loadGltf(withUri(start + base64));
    const [mesh] = meshesOf(scene);
    const expected = Float32Array.from(bytes.subarray(0, mesh!.positions.length));
    expect(Buffer.compare(Buffer.from(expected.buffer), Buffer.from(Float32Array.from(mesh!.positions).buffer))).toBe(
      0,
    );
    await loadGltf(withUri(`${start}${base64.slice(0, 5)}\n ${base64.slice(5)}`));
    const early = `${base64.slice(0, 2 ** 20 - 2)}==${base64.slice(0, 2 ** 20)}`;
    await expect(loadGltf(withUri(start + early))).rejects.toThrow("buffers[0]: its data URI is not base64");
  });
});

describe("a broken container", () => {
  const file = triangleFile();
  const patched = (offset: number, word: number) => {
    const bytes = file.slice();
    new DataView(bytes.buffer).setUint32(offset, word, true);
    return bytes;
  };
  const cases: Readonly<Record<string, readonly [Uint8Array, string]>> = {
    "nothing at all": [new Uint8Array(), "x.glb is not JSON"],
    "the magic alone": [file.subarray(0, 4), "x.glb is cut off after 4 bytes"],
    "half of it": [file.subarray(0, file.length / 2), "x.glb is cut off: it should have"],
    "a chunk of 4 GiB": [patched(12, 0xffffffff), "x.glb: byte 12: a chunk of 4294967295 bytes goes"],
    "a chunk of another kind": [patched(16, 0), "x.glb: byte 16: expected a JSON chunk"],
    "version 1": [patched(4, 1), "x.glb is glTF of version 1"],
    "JSON that ends early": [container('{"asset":', new Uint8Array()), "x.glb is not JSON"],
    "JSON that is a list": [container("[1]", new Uint8Array()), "x.glb: asset: is missing"],
    "JSON a million levels deep": [container("[".repeat(1e6), new Uint8Array()), "x.glb is not JSON"],
    "no binary chunk": [
      glb({ ...JSON.parse('{"buffers":[{"byteLength":4}]}'), ...viewOfNothing() }),
      "buffers[0]: has no data",
    ],
  };

  test.each(Object.keys(cases))("%s", async (name) => {
    const [bytes, complaint] = cases[name]!;
    expect(await complaintAbout(bytes)).toContain(complaint);
  });
});

/** A file whose triangle has as many materials as there are pictures, and each the picture of its number. */
function texturedFile(pictures: readonly Uint8Array[]): Uint8Array {
  return triangleFile((json, packer) => {
    json.images = pictures.map((picture) => ({ bufferView: packer.addView(picture) }));
    json.textures = pictures.map((_, source) => ({ source }));
    json.materials = pictures.map((_, index) => ({ normalTexture: { index } }));
    const attributes = {
      ...json.meshes[0].primitives[0].attributes,
      TEXCOORD_0: packer.add(new Float32Array(6), "VEC2"),
    };
    json.meshes[0].primitives = pictures.map((_, material) => ({ attributes, material }));
  });
}

function viewOfNothing() {
  return {
    bufferViews: [{ buffer: 0, byteLength: 4 }],
    accessors: [{ bufferView: 0, componentType: 5121, type: "SCALAR", count: 4 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
  };
}

describe("a file that has everything, damaged", () => {
  test("is read undamaged", async () => {
    const { scene, warnings } = await loadGltf(everythingFile(), { decodeImage });
    expect(meshesOf(scene).length).toBeGreaterThan(3);
    expect(warnings).toEqual([]);
  });

  test("gives a scene or a LoadError with any byte flipped, seed 3", async () => {
    const file = everythingFile();
    const random = createRandom(3);
    const complaints = new Set<string>();
    for (let i = 0; i < 300; i++) {
      const bytes = file.slice();
      bytes[Math.floor(random() * bytes.length)]! ^= 1 << Math.floor(random() * 8);
      complaints.add((await complaintAbout(bytes)).replaceAll(/[\d"'“].*/g, ""));
    }
    expect(complaints.size).toBeGreaterThan(10); // it got further than the first check
  });

  test("gives a LoadError when it is cut off anywhere, seed 4", async () => {
    const file = everythingFile();
    const random = createRandom(4);
    for (let i = 0; i < 100; i++) {
      const length = Math.floor(random() * file.length);
      expect(await complaintAbout(file.subarray(0, length))).not.toBe("");
    }
  });

  test("gives a scene or a LoadError with any value of its JSON replaced, seed 6", async () => {
    const file = everythingFile();
    const view = new DataView(file.buffer);
    const jsonEnd = 20 + view.getUint32(12, true);
    const text = new TextDecoder().decode(file.subarray(20, jsonEnd));
    const binary = file.subarray(jsonEnd + 8);
    const random = createRandom(6);
    const odd = [-1, 1e300, 2 ** 32, 0.5, null, "", "x", [], {}, [[]], true, 99];
    for (let i = 0; i < 300; i++) {
      const json = JSON.parse(text);
      const slots = slotsOf(json);
      const { container: holder, key } = slots[Math.floor(random() * slots.length)]!;
      Reflect.set(holder, key, odd[Math.floor(random() * odd.length)]);
      await complaintAbout(container(JSON.stringify(json), binary));
    }
  });

  test("is no danger to loadScene either, seed 8", async () => {
    const file = everythingFile();
    const random = createRandom(8);
    for (let i = 0; i < 30; i++) {
      const bytes = file.slice();
      bytes[Math.floor(random() * 40)]! ^= 1 << Math.floor(random() * 8);
      await loadScene(bytes, { decodeImage }).catch((error) => expect(error).toMatchObject({ name: "LoadError" }));
    }
  });
});

/** Every place in some JSON where a value is. */
function slotsOf(json: object): { container: object; key: string }[] {
  return Object.entries(json).flatMap(([key, value]) => {
    const within = typeof value === "object" && value !== null ? slotsOf(value) : [];
    return [{ container: json, key }, ...within];
  });
}
