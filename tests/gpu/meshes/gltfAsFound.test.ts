import { encode } from "fast-png";
import { expect, test } from "vitest";
import { decodeImage } from "../../../src/cli/decodeImage";
import { loadGltf } from "../../../src/loaders/gltf";
import { renderScene } from "../../support/device";
import { Packer, type TriangleJson } from "../../support/gltf";
import { type MeshData, placed, smoothSphere } from "../../support/meshes";

// glTF files as they are found, with faults that the loader makes good: is the picture right?

/** A diffuse surface: its radiance is its colour times E/π. */
const diffuse = (...color: number[]) => ({
  pbrMetallicRoughness: { baseColorFactor: [...color, 1], metallicFactor: 0, roughnessFactor: 1 },
  extensions: { KHR_materials_ior: { ior: 1 } },
});

/** A square of 2 m that faces the camera and, 100 m behind that, a lamp of π·10⁴ cd, whose irradiance is π: a white square's
 * radiance is 1, less 3·(1/100)² at its corners. */
function squareFile(change: (json: TriangleJson, packer: Packer) => void): Uint8Array {
  const packer = new Packer();
  const attributes = {
    POSITION: packer.add(Float32Array.of(-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0), "VEC3"),
    TEXCOORD_0: packer.add(Float32Array.of(0, 1, 1, 1, 1, 0, 0, 0), "VEC2"),
  };
  const json: TriangleJson = {
    meshes: [
      { primitives: [{ attributes, indices: packer.add(Uint16Array.of(0, 1, 2, 0, 2, 3), "SCALAR"), material: 0 }] },
    ],
    materials: [diffuse(0.5, 0.5, 0.5)],
    cameras: [{ type: "perspective", perspective: { yfov: 0.35, znear: 0.1 } }],
    extensions: { KHR_lights_punctual: { lights: [{ type: "point", intensity: 1e4 * Math.PI }] } },
    nodes: [
      { mesh: 0 },
      { camera: 0, translation: [0, 0, 5] },
      { translation: [0, 0, 100], extensions: { KHR_lights_punctual: { light: 0 } } },
    ],
    scenes: [{ nodes: [0, 1, 2] }],
  };
  change(json, packer);
  return packer.file(json);
}

async function render(file: Uint8Array, size: number, samples: number) {
  const { scene, warnings } = await loadGltf(file, { decodeImage });
  const { image, stats } = await renderScene(scene, { size: [size, size], samples });
  expect(stats.badSamples).toBe(0);
  const at = (x: number, y: number) => [...image.subarray(4 * (size * y + x), 4 * (size * y + x) + 3)];
  return { image, at, warnings };
}

/** Of the lamp's irradiance at the corners, and f32. */
const TOLERANCE = 4e-4;

function expectColor(actual: readonly number[], expected: readonly number[]): void {
  for (const [i, value] of expected.entries()) expect(Math.abs(actual[i]! - value)).toBeLessThanOrEqual(TOLERANCE);
}

test.each([
  ["a sun of π lux", { type: "directional", intensity: Math.PI }],
  ["a spot of π·10⁴ candela, 100 m away", { type: "spot", intensity: 1e4 * Math.PI, spot: { innerConeAngle: 0.1 } }],
])("%s lights a square that faces it, whatever its node's scale", async (_, light) => {
  const { at, warnings } = await render(
    squareFile((json) => {
      json.extensions = { KHR_lights_punctual: { lights: [light] } };
      json.nodes[2].scale = [3, 4, 5];
    }),
    16,
    16,
  );
  expect(warnings).toEqual([]);
  expectColor(at(8, 8), [0.5, 0.5, 0.5]);
});

test("a file that requires KHR_materials_volume_scatter is shown without it", async () => {
  const { at, warnings } = await render(
    squareFile((json) => {
      json.extensionsUsed = json.extensionsRequired = ["KHR_materials_volume_scatter"];
    }),
    8,
    16,
  );
  expectColor(at(4, 4), [0.5, 0.5, 0.5]);
  expect(warnings).toHaveLength(1);
});

test("of a node that is not visible nothing is seen", async () => {
  const { image } = await render(
    squareFile((json) => {
      json.nodes[0].extensions = { KHR_node_visibility: { visible: false } };
    }),
    8,
    4,
  );
  expect(Math.max(...image.filter((_, i) => i % 4 !== 3))).toBe(0);
});

test("a picture whose URI begins with DATA: and BASE64 is shown", async () => {
  const { at } = await render(
    squareFile((json) => {
      const picture = encode({ width: 2, height: 1, channels: 3, data: Uint8Array.of(255, 0, 0, 0, 255, 0) });
      json.images = [{ uri: `DATA:image/png;BASE64,${Buffer.from(picture).toString("base64")}` }];
      json.samplers = [{ magFilter: 9728 }];
      json.textures = [{ source: 0, sampler: 0 }];
      json.materials = [diffuse(1, 1, 1)];
      json.materials[0].pbrMetallicRoughness.baseColorTexture = { index: 0 };
    }),
    8,
    16,
  );
  expectColor(at(2, 4), [1, 0, 0]);
  expectColor(at(5, 4), [0, 1, 0]);
});

test("a normal map that repeats ten times lies over a colour that does not", async () => {
  const byte = (value: number) => Math.round(127.5 * (1 + value));
  // Leans to the right in its left half, and is flat in its right half.
  const [lean, flat] = [
    [byte(0.6), byte(0), byte(0.8)],
    [byte(0), byte(0), byte(1)],
  ];
  const [x, y, z] = lean!.map((value) => (2 * value) / 255 - 1) as [number, number, number];
  const { at, warnings } = await render(
    squareFile((json) => {
      json.images = [
        [255, 0, 0, 0, 255, 0],
        [...lean!, ...flat!],
      ].map((data) => {
        const picture = encode({ width: 2, height: 1, channels: 3, data: Uint8Array.from(data) });
        return { uri: `data:image/png;base64,${Buffer.from(picture).toString("base64")}` };
      });
      json.samplers = [{ magFilter: 9728 }];
      json.textures = [0, 1].map((source) => ({ source, sampler: 0 }));
      json.materials = [diffuse(1, 1, 1)];
      json.materials[0].pbrMetallicRoughness.baseColorTexture = { index: 0 };
      const extensions = { KHR_texture_transform: { scale: [10, 10] } };
      json.materials[0].normalTexture = { index: 1, extensions };
      // Seen so that the square just fills the picture: 20 columns of 20 pixels.
      json.cameras[0].perspective.yfov = 2 * Math.atan(1 / 5);
    }),
    20,
    16,
  );
  expect(warnings).toEqual([]);
  for (const column of [4, 5, 8, 9, 10, 11, 14, 15]) {
    const cosine = column % 2 === 0 ? z / Math.hypot(x, y, z) : 1;
    const [red, green, blue] = at(column, 10) as [number, number, number];
    const [shown, other] = column < 10 ? [red, green] : [green, red];
    // The light is a hundredth off the axis at the square's edge, which a leaning normal makes 0.6 % of; and bytes.
    expect(Math.abs(shown - cosine), `column ${column}`).toBeLessThan(0.007);
    expect([other, blue]).toEqual([0, 0]);
  }
});

/** A ball on the default table; `change` may alter its normals, and `more` is another mesh. */
function ballFile(change: (normals: Float32Array) => void = () => {}, more?: [MeshData, object]): Uint8Array {
  const packer = new Packer();
  const primitiveOf = ({ positions, indices, normals }: MeshData, material: number) => {
    const changed = Float32Array.from(normals!);
    change(changed);
    return {
      attributes: { POSITION: packer.add(Float32Array.from(positions), "VEC3"), NORMAL: packer.add(changed, "VEC3") },
      indices: packer.add(Uint16Array.from(indices), "SCALAR"),
      material,
    };
  };
  const primitives = [primitiveOf(smoothSphere(1200), 0), ...(more ? [primitiveOf(more[0], 1)] : [])];
  return packer.file({
    meshes: [{ primitives }],
    materials: [diffuse(0.6, 0.6, 0.6), ...(more ? [more[1]] : [])],
    nodes: [{ mesh: 0 }],
    scenes: [{ nodes: [0] }],
  });
}

const meanOf = (image: Float32Array, channel: number) =>
  image.reduce((sum, value, i) => (i % 4 === channel ? sum + value : sum), 0) / (image.length / 4);

test("a ball with a normal that is NaN looks as it should, but for the facets around one vertex", async () => {
  const plain = await render(ballFile(), 24, 64);
  const broken = await render(
    ballFile((normals) => normals.fill(NaN, 3 * 250, 3 * 250 + 1)),
    24,
    64,
  );
  expect(broken.warnings).toEqual([expect.stringContaining("(1 of ")]);
  // The same seed: where the surface is the same, so is the picture but for what it reflects of the six triangles, of 1200.
  const differences = plain.image.map((value, i) => Math.abs(value - broken.image[i]!));
  expect(differences.filter((difference) => difference > 0.02).length).toBeLessThan(4 * 12);
  expect(Math.abs(meanOf(plain.image, 1) - meanOf(broken.image, 1))).toBeLessThan(0.002);
});

test("a ball with a small red diode on it is as light as without, and the diode glows", async () => {
  const glow = { pbrMetallicRoughness: { baseColorFactor: [0, 0, 0, 1] }, emissiveFactor: [1, 0, 0] };
  const diode: [MeshData, object] = [placed(smoothSphere(200), 0.06, [0.3, 0.5, 0.95]), glow];
  const plain = await render(ballFile(), 32, 64);
  const lit = await render(
    ballFile(() => {}, diode),
    32,
    64,
  );
  // It covers less than a hundredth of the picture, and darkens less than another by its shadow.
  const mean = meanOf(plain.image, 1);
  expect(Math.abs(meanOf(lit.image, 1) - mean)).toBeLessThan(0.02 * mean);
  // It is a pixel wide, so that the pixel in its middle shows at least half of its radiance of 1.
  const redness = lit.image.map((value, i) => (i % 4 === 0 ? value - lit.image[i + 1]! : 0));
  expect(Math.max(...redness)).toBeGreaterThan(0.5);
});
