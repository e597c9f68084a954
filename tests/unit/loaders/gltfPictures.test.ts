import { encode } from "fast-png";
import { describe, expect, test, vi } from "vitest";
import { decodeImage } from "../../../src/cli/decodeImage";
import { type LoadOptions, loadGltf } from "../../../src/loaders/gltf";
import { parseScene } from "../../../src/scene/parseScene";
import { container, meshesOf, type TriangleJson, triangleFile } from "../../support/gltf";
import { ktx2Picture, texelsOfKtx2Blocks } from "../../support/ktx2Pictures";
import { pngFile } from "../../support/png";
import { smallPicture } from "../../support/smallPictures";

const RED = encode({ width: 1, height: 1, channels: 3, data: Uint8Array.of(255, 0, 0) });
const BASE = { metallicFactor: 0, roughnessFactor: 1 };

type Picture = Uint8Array | { readonly uri?: string; readonly name?: string };

/** A triangle for each picture, with a material of its own: `field` has the picture as its texture. */
function pictureFile(
  pictures: readonly Picture[],
  materialOf: (index: number) => object = (index) => ({
    pbrMetallicRoughness: { ...BASE, baseColorTexture: { index } },
  }),
  change: (json: TriangleJson) => void = () => {},
): Uint8Array {
  return triangleFile((json, packer) => {
    json.images = pictures.map((picture) =>
      picture instanceof Uint8Array ? { bufferView: packer.addView(picture) } : picture,
    );
    json.textures = pictures.map((_, source) => ({ source }));
    json.materials = pictures.map((_, index) => materialOf(index));
    const TEXCOORD_0 = packer.add(Float32Array.of(0, 0, 1, 0, 0, 1), "VEC2");
    const attributes = { ...json.meshes[0].primitives[0].attributes, TEXCOORD_0 };
    json.meshes[0].primitives = pictures.map((_, material) => ({ attributes, material }));
    change(json);
  });
}

async function load(file: Uint8Array, options: LoadOptions = {}) {
  const { scene, warnings } = await loadGltf(file, { decodeImage, ...options });
  parseScene(scene); // what comes out is always valid
  const materials = meshesOf(scene).map(({ material }) => scene.materials![material]!);
  return { scene, warnings, materials };
}

const LEFT_OUT = "A picture is left out, and its texture is white: ";

describe("a picture that can't be read leaves its texture white, and is named with the reason", () => {
  const missing = async () => {
    throw new Error("not-there.png could not be fetched: 404 Not Found");
  };

  test("because it is not there", async () => {
    const { scene, warnings, materials } = await load(pictureFile([{ uri: "not-there.png" }, RED]), {
      fetchResource: missing,
    });
    expect(materials[0]).toEqual({ baseColor: [1, 1, 1], metallic: 0, roughness: 1, ior: 1.5 });
    expect(materials[1]!.baseColorTexture).toBe("image 1");
    expect(Object.keys(scene.textures!)).toEqual(["image 1"]);
    expect(warnings).toEqual([
      `${LEFT_OUT}not-there.png could not be fetched: 404 Not Found (images[0] "not-there.png")`,
    ]);
  });

  const text = (content: string) => new TextEncoder().encode(content);
  const damaged = encode({ width: 9, height: 9, channels: 3, data: new Uint8Array(243).map((_, i) => i * i) });
  damaged[damaged.length - 30]! ^= 255;
  const cases: Readonly<Record<string, readonly [Picture, string, string?]>> = {
    "because it is a web page": [text("\ufeff\n<!DOCTYPE html><p>404"), "it is a web page (HTML), not a picture"],
    "because it is empty": [{ uri: "data:image/png;base64," }, "it is empty"],
    "because it is of a format that nobody knows": [text("hello"), "it is not PNG, JPEG, WebP, AVIF or KTX2"],
    "because it is a GIF": [text("GIF89a"), "it is GIF, which can't be read"],
    "because it is an SVG": [text('<svg xmlns="http://www.w3.org/2000/svg"/>'), "it is SVG, which can't be read"],
    "because its header is cut off": [RED.slice(0, 18), "its header is damaged"],
    "because its data is damaged": [damaged, "its data is damaged"],
    "because it is cut off": [smallPicture("avif").slice(0, 450), "it is damaged, or of a kind that can't be decoded"],
    "because it is no base64": [
      { uri: "data:image/png;base64,%%%", name: "bark" },
      "its data URI is not base64",
      ' "bark"',
    ],
    "because the file does not say where it is": [{ name: "bark" }, "it has no uri and no bufferView", ' "bark"'],
    "because it would have a billion texels": [
      pngFile([40_000, 30_000], [8, 2, 0, 0, 0], []),
      "it is 40000 × 30000, which is more than 268435456 texels",
    ],
  };
  test.each(Object.keys(cases))("%s", async (name) => {
    const [picture, reason, called = ""] = cases[name]!;
    const { warnings, materials } = await load(pictureFile([picture]));
    expect(materials[0]!.baseColorTexture).toBeUndefined();
    expect(warnings).toEqual([`${LEFT_OUT}${reason} (images[0]${called})`]);
  });

  test("because it is in a buffer that is not there", async () => {
    // The view of the picture is the second of the file.
    const moved = rewritten(pictureFile([RED]), (json) => {
      json.bufferViews[1] = { buffer: 1, byteLength: 10 };
      json.buffers.push({ uri: "gone.bin", byteLength: 10 });
    });
    const { warnings } = await load(moved, { fetchResource: missing });
    expect(warnings).toEqual([`${LEFT_OUT}buffers[1]: not-there.png could not be fetched: 404 Not Found (images[0])`]);
  });

  test("because its size is not what its header says", async () => {
    const decode = async () => ({ width: 2, height: 1, texels: new Uint8Array(8) });
    const { warnings } = await load(pictureFile([RED]), { decodeImage: decode });
    expect(warnings).toEqual([`${LEFT_OUT}it is 2 × 1, though its header says 1 × 1 (images[0])`]);
  });

  test("in every place of a material, and nothing is bent, dimmed or tinted", async () => {
    const file = pictureFile([{}], (index) => ({
      pbrMetallicRoughness: { metallicFactor: 0.25, baseColorTexture: { index }, metallicRoughnessTexture: { index } },
      normalTexture: { index, scale: 2 },
      emissiveTexture: { index },
      emissiveFactor: [1, 0.5, 0],
    }));
    const { scene, materials } = await load(file);
    expect(scene.textures).toEqual({});
    expect(materials[0]).toEqual({
      baseColor: [1, 1, 1],
      metallic: 0.25,
      roughness: 1,
      ior: 1.5,
      emission: [1, 0.5, 0],
      normalScale: 2,
    });
  });

  test("and a thousand of them are not quoted at length", async () => {
    const uris = Array.from({ length: 1000 }, (_, i) => ({ uri: `${i}${"x".repeat(1e4)}` }));
    const { warnings } = await load(pictureFile(uris), {
      fetchResource: async (url) => {
        throw new Error(url);
      },
    });
    expect(warnings).toHaveLength(101);
    expect(Math.max(...warnings.map(({ length }) => length))).toBeLessThan(600);
  });
});

describe("a texture of KHR_texture_basisu", () => {
  const packed = (fallback: object, picture: Picture = ktx2Picture("etc1sAlpha")) =>
    pictureFile([RED, picture], undefined, (json) => {
      json.extensionsRequired = ["KHR_texture_basisu"];
      json.textures = [{ source: 0 }, { ...fallback, extensions: { KHR_texture_basisu: { source: 1 } } }];
    });

  test("has the texels of its KTX2 picture", async () => {
    const { scene, materials, warnings } = await load(packed({}));
    expect(materials.map(({ baseColorTexture }) => baseColorTexture)).toEqual(["image 0", "image 1"]);
    const { width, height, texels } = scene.textures!["image 1"]!;
    expect([width, height]).toEqual([12, 10]);
    expect([...texels]).toEqual([...texelsOfKtx2Blocks({ hasAlpha: true })]);
    expect(warnings).toEqual([]);
  });

  test("has its other picture, if the file has one", async () => {
    const { materials, warnings } = await load(packed({ source: 0 }));
    expect(materials.map(({ baseColorTexture }) => baseColorTexture)).toEqual(["image 0", "image 0"]);
    expect(warnings).toEqual([]);
  });

  test("is left out if its picture is of a kind that can't be read, and the picture is named", async () => {
    const cubeMap = ktx2Picture("uastc");
    cubeMap[36] = 6;
    const { materials, warnings } = await load(packed({}, cubeMap));
    expect(materials.map(({ baseColorTexture }) => baseColorTexture)).toEqual(["image 0", undefined]);
    expect(warnings).toEqual([`${LEFT_OUT}it is KTX2 with a cube map, which can't be read (images[1])`]);
  });

  test("is made smaller where pictures are too large together", async () => {
    const { scene, warnings } = await load(packed({}), { maxTexelBytes: 4 * (1 + 6 * 5) });
    expect(scene.textures!["image 1"]).toMatchObject({ width: 6, height: 5 });
    expect(warnings).toEqual([expect.stringContaining("shown at 6 × 5 instead of 12 × 10")]);
  });

  test("needs no decoder of the caller's, and is not given to one", async () => {
    const only = pictureFile([ktx2Picture("uastcZstandard")]);
    const { scene } = await loadGltf(only);
    expect(scene.textures!["image 0"]).toMatchObject({ width: 12, height: 10 });
    const refuse = async () => {
      throw new Error("what is this?");
    };
    expect((await load(only, { decodeImage: refuse })).warnings).toEqual([]);
  });

  test("of more texels than are read is left out before it is decoded", async () => {
    const large = ktx2Picture("etc1s");
    new DataView(large.buffer).setUint32(20, 2 ** 27, true);
    const { warnings } = await load(packed({}, large));
    expect(warnings).toEqual([`${LEFT_OUT}it is 134217728 × 10, which is more than 268435456 texels (images[1])`]);
  });
});

test("a texture without a picture is left out, which is said", async () => {
  const file = pictureFile([RED], undefined, (json) => {
    json.textures = [{}];
  });
  const { materials, warnings } = await load(file);
  expect(materials[0]!.baseColorTexture).toBeUndefined();
  expect(warnings).toEqual(["A texture is left out because it has no picture that can be read (textures[0])"]);
});

test("a signal still ends a file whose pictures are read or decoded", async () => {
  for (const stage of ["fetchResource", "decodeImage"] as const) {
    const controller = new AbortController();
    const options = {
      signal: controller.signal,
      fetchResource: async () => RED,
      decodeImage,
      [stage]: () => {
        controller.abort(new Error("enough"));
        throw new Error("ended");
      },
    };
    await expect(loadGltf(pictureFile([{ uri: "a" }, { uri: "b" }]), options), stage).rejects.toThrow("enough");
  }
});

describe("pictures that are too large together", () => {
  const png = (side: number) => pngFile([side, side], [8, 2, 0, 0, 0], []);
  /** Stripes of light: every other row is white. */
  const striped = vi.fn(async (bytes: Uint8Array) => {
    const side = new DataView(bytes.buffer, bytes.byteOffset).getUint32(16);
    const texels = new Uint8Array(4 * side * side).fill(255);
    for (let row = 0; row < side; row += 2) texels.fill(0, 4 * side * row, 4 * side * (row + 1));
    return { width: side, height: side, texels };
  });
  const options = { decodeImage: striped };

  test("are halved, and it is said from what size to what size", async () => {
    const { scene, warnings } = await load(pictureFile([png(64), png(8)]), {
      ...options,
      maxTexelBytes: 4 * 16 * 16 + 4 * 8 * 8,
    });
    const sizes = Object.values(scene.textures!).map(({ width, height }) => [width, height]);
    expect(sizes).toEqual([
      [16, 16],
      [8, 8],
    ]);
    expect(warnings).toEqual([
      "Pictures are too large together, so this is shown at 16 × 16 instead of 64 × 64 (images[0])",
    ]);
    expect(new Set(scene.textures!["image 0"]!.texels)).toEqual(new Set([188, 128])); // half the light, half of alpha
  });

  test("are averaged as data where they are data", async () => {
    const { scene } = await load(
      pictureFile([png(64)], (index) => ({ normalTexture: { index } })),
      { ...options, maxTexelBytes: 4 * 32 * 32 },
    );
    expect(new Set(scene.textures!["image 0"]!.texels)).toEqual(new Set([128]));
  });

  test("count for each way in which they are repeated", async () => {
    const file = pictureFile([png(64), png(64)], undefined, (json) => {
      json.samplers = [{ wrapS: 33071 }];
      json.textures = [{ source: 0 }, { source: 0, sampler: 0 }];
    });
    const { scene } = await load(file, { ...options, maxTexelBytes: 4 * 64 * 64 });
    expect(Object.values(scene.textures!).map(({ width }) => width)).toEqual([32, 32]);
  });

  test("five of 4096 × 4096 fit what every device can hold, and at most two are whole at a time", async () => {
    let [held, most] = [0, 0];
    const counting = async (bytes: Uint8Array) => {
      most = Math.max(most, ++held);
      const image = await striped(bytes);
      setTimeout(() => held--); // when its texels are read, or a moment later
      return image;
    };
    const { scene, warnings } = await load(pictureFile(Array(5).fill(png(4096))), { decodeImage: counting });
    const textures = Object.values(scene.textures!);
    expect(textures.map(({ width }) => width)).toEqual([2048, 2048, 2048, 2048, 4096]);
    const byteCount = textures.reduce((sum, { texels }) => sum + texels.length, 0);
    expect(byteCount).toBeLessThanOrEqual(128 * 2 ** 20);
    expect(most).toBeLessThanOrEqual(2);
    expect(warnings).toEqual([
      "Pictures are too large together, so this is shown at 2048 × 2048 instead of 4096 × 4096 (images[0], images[1], images[2] and 1 more)",
    ]);
  });

  test("without an option as much as the adapter holds is kept", async () => {
    const limits = { maxStorageBufferBindingSize: 2 ** 28, maxBufferSize: 2 ** 30 };
    vi.stubGlobal("navigator", { gpu: { requestAdapter: async () => ({ limits }) } });
    try {
      const { scene } = await load(pictureFile(Array(5).fill(png(4096))), options);
      expect(Object.values(scene.textures!).map(({ width }) => width)).toEqual([2048, 2048, 4096, 4096, 4096]);
    } finally {
      vi.unstubAllGlobals();
    }
  });

  test("longer than a scene allows, are halved too", async () => {
    const decode = async () => ({ width: 20_000, height: 1, texels: new Uint8Array(80_000) });
    const { scene } = await load(pictureFile([pngFile([20_000, 1], [8, 2, 0, 0, 0], [])]), { decodeImage: decode });
    expect(scene.textures!["image 0"]).toMatchObject({ width: 10_000, height: 1 });
  });

  test("more than anybody has are left out, those that come last", async () => {
    const decode = vi.fn(async () => {
      throw new Error("not decoded here");
    });
    const { warnings } = await load(pictureFile(Array(20).fill(png(16384))), { decodeImage: decode });
    expect(decode).toHaveBeenCalledTimes(16);
    expect(warnings.join()).toContain(
      "there are pictures of more than 4294967296 texels (images[16], images[17], images[18] and 1 more)",
    );
  });
});

/** A .glb with its JSON changed. */
function rewritten(file: Uint8Array, change: (json: TriangleJson) => void): Uint8Array {
  const view = new DataView(file.buffer, file.byteOffset);
  const end = 20 + view.getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(file.subarray(20, end)));
  change(json);
  return container(JSON.stringify(json), file.subarray(end + 8));
}
