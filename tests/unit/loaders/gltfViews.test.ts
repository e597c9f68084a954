import { describe, expect, test } from "vitest";
import { loadGltf } from "../../../src/loaders/gltf";
import { parseScene } from "../../../src/scene/parseScene";
import type { ResolvedLight, Vec3 } from "../../../src/scene/schema";
import { roundedNumbers, type TriangleJson, triangleFile } from "../../support/gltf";

const load = async (change: (json: TriangleJson) => void = () => {}) => {
  const { scene, warnings } = await loadGltf(triangleFile(change));
  return { scene: parseScene(scene), warnings };
};

type Sun = ResolvedLight & { type: "directional" };

const withLight = (json: TriangleJson, light: object) => {
  json.extensionsUsed = ["KHR_lights_punctual"];
  json.extensions = { KHR_lights_punctual: { lights: [light] } };
  json.nodes.push({ translation: [1, 2, 3], extensions: { KHR_lights_punctual: { light: 0 } } });
  json.scenes[0].nodes.push(json.nodes.length - 1);
};

const withCamera = (json: TriangleJson, node: object, camera: object = perspective(0.7)) => {
  json.cameras = [camera];
  json.nodes.push({ camera: 0, ...node });
  json.scenes[0].nodes.push(json.nodes.length - 1);
};

const perspective = (yfov: number) => ({ type: "perspective", perspective: { yfov, znear: 0.1 } });

describe("lights", () => {
  test("of a point light each candela is a watt per steradian", async () => {
    const { scene, warnings } = await load((json) => {
      withLight(json, { type: "point", intensity: 10, color: [1, 0.5, 0] });
    });
    expect(scene.lights).toHaveLength(1);
    expect(scene.lights[0]).toMatchObject({ type: "point", position: [1, 2, 3] });
    const [light] = scene.lights as readonly [{ type: "point"; position: Vec3; power: Vec3 }];
    expect(roundedNumbers(light.power)).toEqual(roundedNumbers([40 * Math.PI, 20 * Math.PI, 0]));
    expect(warnings).toEqual([]);
  });

  test("a light in lumens, where ours are watts, is said to be too bright, and by how much", async () => {
    // 1000 W in Blender, which writes 1000 · 683 / 4π candela, at the distance of its default scene.
    const { warnings } = await load((json) => {
      json.nodes[0].translation = [1, 2, -2.9];
      withLight(json, { type: "point", intensity: 54_351 });
    });
    expect(warnings).toEqual(["The lights are about 9 stops too bright for an exposure of 0; try one of -9"]);
  });

  test("of a directional light each lux is a watt per square metre", async () => {
    const { scene, warnings } = await load((json) => {
      withLight(json, { type: "directional", intensity: 3, color: [1, 0.5, 0] });
    });
    expect(scene.lights).toEqual([
      { type: "directional", direction: [-0, -0, -1], irradiance: [3, 1.5, 0], angularDiameter: 0 },
    ]);
    expect(warnings).toEqual([]);
  });

  test.each([1, 1e-6, 1e6])(
    "a directional light shines along −z of its node, whatever its scale, %d",
    async (scale) => {
      const { scene } = await load((json) => {
        withLight(json, { type: "directional" });
        // A parent turned by 90° around y, so that its −z is −x; below it a node turned by −45° around x, which looks down.
        const lamp = json.nodes.length - 1;
        json.nodes[lamp].rotation = [-Math.sin(Math.PI / 8), 0, 0, Math.cos(Math.PI / 8)];
        json.nodes[lamp].scale = [scale, 2 * scale, 3 * scale];
        json.nodes.push({
          children: [lamp],
          rotation: [0, Math.SQRT1_2, 0, Math.SQRT1_2],
          scale: [scale, scale, scale],
        });
        json.scenes[0].nodes = [0, lamp + 1];
      });
      const [{ direction }] = scene.lights as readonly [Sun];
      expect(roundedNumbers(direction)).toEqual(roundedNumbers([-Math.SQRT1_2, -Math.SQRT1_2, 0]));
    },
  );

  test("a directional light in a space without depth still shines across it, in one without size it is left out", async () => {
    const scaled = (scale: number[]) =>
      load((json) => {
        withLight(json, { type: "directional", name: "Sun" });
        json.nodes.at(-1)!.scale = scale;
      });
    const { scene } = await scaled([1, 1, 0]);
    expect(roundedNumbers((scene.lights[0] as Sun).direction)).toEqual([0, 0, -1]);
    const { warnings } = await scaled([0, 0, 0]);
    expect(warnings).toEqual(['A light in a space without size has no direction, and is left out (lights[0] "Sun")']);
  });

  test("a sun in lux is said to be too bright", async () => {
    const { warnings } = await load((json) => withLight(json, { type: "directional", intensity: 100_000 }));
    expect(warnings).toEqual(["The lights are about 15 stops too bright for an exposure of 0; try one of -15"]);
  });

  test("of a spot each candela is a watt per steradian, and its angles are in degrees", async () => {
    const { scene, warnings } = await load((json) => {
      const spot = { innerConeAngle: Math.PI / 12, outerConeAngle: Math.PI / 6 };
      withLight(json, { type: "spot", intensity: 10, color: [1, 0.5, 0], spot });
      json.nodes.at(-1)!.scale = [5, 6, 7];
    });
    const [light] = scene.lights;
    expect(light).toMatchObject({ type: "spot", position: [1, 2, 3], intensity: [10, 5, 0], radius: 0 });
    const { direction, innerAngle, outerAngle } = light as ResolvedLight & { type: "spot" };
    expect(roundedNumbers([...direction, innerAngle, outerAngle])).toEqual([0, 0, -1, 15, 30]);
    expect(warnings).toEqual([]);
  });

  test.each([
    [undefined, 0, 45],
    [{ innerConeAngle: 1, outerConeAngle: 1 }, 57.238484, 57.29578],
    [{ innerConeAngle: 2, outerConeAngle: 3 }, 89.91, 90],
    [{ innerConeAngle: -1, outerConeAngle: 0 }, 0, 0.001],
  ])("the angles of a spot are brought into order: %o", async (spot, inner, outer) => {
    const { scene } = await load((json) => withLight(json, { type: "spot", ...(spot && { spot }) }));
    const { innerAngle, outerAngle } = scene.lights[0] as ResolvedLight & { type: "spot" };
    expect([innerAngle, outerAngle]).toEqual([expect.closeTo(inner, 5), expect.closeTo(outer, 5)]);
  });
});

describe("the camera", () => {
  test("is the file's, aimed at the depth of the model's middle, upright where its horizon is level", async () => {
    const { scene, warnings } = await load((json) => withCamera(json, { translation: [0.5, 0.5, 4] }));
    expect(scene.camera).toMatchObject({ position: [0.5, 0.5, 4], target: [0.5, 0.5, 0], up: [0, 1, 0] });
    expect(scene.camera.verticalFov).toBeCloseTo((0.7 * 180) / Math.PI, 10);
    expect(warnings).toEqual([]);
  });

  test("keeps its roll", async () => {
    const { scene } = await load((json) => withCamera(json, { rotation: [0, 0, Math.SQRT1_2, Math.SQRT1_2] }));
    expect(roundedNumbers(scene.camera.up)).toEqual([-1, 0, 0]);
  });

  test("may look straight down", async () => {
    const rotation = [-Math.SQRT1_2, 0, 0, Math.SQRT1_2];
    const { scene } = await load((json) => withCamera(json, { translation: [0, 3, 0], rotation }));
    expect(roundedNumbers(scene.camera.up)).toEqual([0, 0, -1]);
    expect(scene.camera.target[1]).toBeLessThan(3);
  });

  describe("if it is orthographic", () => {
    const orthographic = (fields: object) => ({
      type: "orthographic",
      orthographic: { xmag: 2, zfar: 100, ...fields },
    });
    // The triangle has corners at 0, 1 along x and 1 along y.
    const cameraOf = async (fields: object, node: object = { translation: [0.5, 0.5, 4] }) => {
      const { scene, warnings } = await load((json) => withCamera(json, node, orthographic(fields)));
      expect(warnings).toEqual([]);
      return scene.camera;
    };

    test("shows twice ymag from the lower to the upper edge", async () => {
      const camera = await cameraOf({ ymag: 1.5, znear: 0.1 });
      expect(camera).toMatchObject({ position: [0.5, 0.5, 4], target: [0.5, 0.5, 0], orthographicHeight: 3 });
      expect((await cameraOf({ ymag: -1.5, znear: 0.1 })).orthographicHeight).toBe(3);
    });

    test("is not scaled with its node", async () => {
      const camera = await cameraOf({ ymag: 1.5, znear: 0.1 }, { translation: [0.5, 0.5, 4], scale: [2, 3, 5] });
      expect(camera).toMatchObject({ position: [0.5, 0.5, 4], target: [0.5, 0.5, 0], orthographicHeight: 3 });
    });

    test("begins at znear where that cuts something off, before the node or behind it", async () => {
      const half = Math.SQRT1_2;
      // From the right, 0.5 from the triangle's corner.
      const node = { translation: [1.5, 0.5, 0], rotation: [0, half, 0, half] };
      const begin = async (znear: number) => (await cameraOf({ ymag: 1, znear }, node)).position[0];
      expect(await begin(0.4)).toBe(1.5);
      expect(await begin(0.75)).toBeCloseTo(0.75, 12);
      expect(await begin(-0.4)).toBe(1.5);
      const within = async (znear: number) =>
        (await cameraOf({ ymag: 1, znear }, { ...node, translation: [0.5, 0.5, 0] })).position[0];
      expect(await within(0)).toBe(0.5);
      expect(await within(-1)).toBeCloseTo(1.5, 12);
    });

    test.each([{}, { ymag: 0 }])("but shows nothing, the model is framed, and that is said: %j", async (fields) => {
      const { scene, warnings } = await load((json) => withCamera(json, {}, orthographic(fields)));
      expect(scene.camera.orthographicHeight).toBeUndefined();
      expect(warnings).toEqual([
        "A camera without a field of view is left out: the model is framed instead (cameras[0])",
      ]);
    });

    test("but flattened, the model is framed, and that is said", async () => {
      const { warnings } = await load((json) => withCamera(json, { scale: [1, 0, 1] }, orthographic({ ymag: 1 })));
      expect(warnings).toEqual([
        "A camera flattened by its node's scale is left out: the model is framed instead (cameras[0])",
      ]);
    });
  });

  test("without one, every vertex is in a square picture, and most of it is filled", async () => {
    const { scene } = await load((json) => {
      json.nodes[0] = { mesh: 0, scale: [3, 0.2, 1], translation: [100, 5, -7] };
    });
    const { position, target, verticalFov } = scene.camera;
    const ahead = unit(minus(target, position));
    const right = unit([-ahead[2]!, 0, ahead[0]!]);
    const slope = Math.tan((verticalFov * Math.PI) / 360);
    const across = [
      [100, 5, -7],
      [103, 5, -7],
      [100, 5.2, -7],
    ].map((vertex) => {
      const offset = minus(vertex, position);
      return Math.abs(dot(offset, right)) / dot(offset, ahead) / slope;
    });
    expect(Math.max(...across)).toBeLessThan(1);
    expect(Math.max(...across)).toBeGreaterThan(0.7);
  });
});

describe("what takes no part in the framing", () => {
  const cameraOf = async (change: (json: TriangleJson) => void = () => {}) => (await load(change)).scene.camera;
  const HALF = Math.SQRT1_2;

  test.each([
    ["to a point", { scale: [0, 0, 0] }],
    ["to a line", { scale: [1, 0, 0] }],
    ["to a line that is turned", { scale: [0, 2, 0], rotation: [0.3, HALF, 0.1, HALF] }],
    ["to nothing that is seen", { scale: [1e-7, 1e-7, 1e-7] }],
  ])("an instance scaled %s, wherever it is", async (_, node) => {
    const camera = await cameraOf((json) => {
      json.nodes.push({ mesh: 0, translation: [1000, 0, 0], ...node });
      json.scenes[0].nodes.push(1);
    });
    expect(camera).toEqual(await cameraOf());
  });

  test("an instance of EXT_mesh_gpu_instancing scaled to a point", async () => {
    const { scene, warnings } = await loadGltf(
      triangleFile((json, packer) => {
        const TRANSLATION = packer.add(Float32Array.of(0, 0, 0, 1000, 0, 0), "VEC3");
        const SCALE = packer.add(Float32Array.of(1, 1, 1, 0, 0, 0), "VEC3");
        json.nodes[0].extensions = { EXT_mesh_gpu_instancing: { attributes: { TRANSLATION, SCALE } } };
      }),
    );
    expect(parseScene(scene).camera).toEqual(await cameraOf());
    expect(warnings).toEqual([]);
  });

  test("a triangle without area, and a vertex without triangle", async () => {
    const { scene } = await loadGltf(
      triangleFile((json, packer) => {
        const far = Float32Array.of(1000, 0, 0, 5, 5, 5);
        json.meshes[0].primitives[0] = {
          attributes: { POSITION: packer.add(Float32Array.of(0, 0, 0, ...far, 1, 0, 0, 0, 1, 0), "VEC3") },
          indices: packer.add(Uint16Array.of(0, 3, 4, 1, 1, 1, 1, 0, 1), "SCALAR"),
        };
      }),
    );
    expect(parseScene(scene).camera).toEqual(await cameraOf());
  });

  test("but one that is flat is seen, and a small one if nothing is larger", async () => {
    const flat = await cameraOf((json) => {
      json.nodes.push({ mesh: 0, translation: [1000, 0, 0], scale: [1, 1, 0] });
      json.scenes[0].nodes.push(1);
    });
    expect(flat.target[0]).toBeCloseTo(500.5, 6);
    const small = await cameraOf((json) => {
      json.nodes[0] = { mesh: 0, scale: [1e-7, 1e-7, 1e-7] };
    });
    expect(small.target[0]).toBeCloseTo(5e-8, 12);
  });
});

describe("the table", () => {
  const hasGround = (scene: { objects: readonly { type: string }[] }) =>
    scene.objects.some(({ type }) => type === "plane");

  test("a bare model stands on a ground just below it, under a lamp and a dim sky", async () => {
    const { scene } = await load((json) => {
      json.nodes[0].translation = [0, 10, 0];
    });
    const plane = scene.objects.find((object) => object.type === "plane")!;
    expect(plane.normal).toEqual([0, 1, 0]);
    expect(plane.point[1]).toBeLessThan(10);
    expect(plane.point[1]).toBeGreaterThan(9.99);
    expect(scene.lights.map(({ type }) => type)).toEqual(["sphere"]);
    expect(Math.min(...scene.environment.radiance)).toBeGreaterThan(0);
  });

  test("the lamp gives a model of any size the same light", async () => {
    const irradiance = async (scale: number) => {
      const { scene } = await load((json) => {
        json.nodes[0].scale = [scale, scale, scale];
      });
      const [light] = scene.lights as readonly [{ type: "point"; position: Vec3; power: Vec3 }];
      const distance = Math.hypot(...minus(light.position, scene.camera.target));
      return light.power[0] / (4 * Math.PI * distance ** 2);
    };
    expect(await irradiance(1e-6)).toBeCloseTo(await irradiance(1e6), 6);
  });

  test("a file with a light has none of it", async () => {
    const { scene } = await load((json) => withLight(json, { type: "point", intensity: 10 }));
    expect(hasGround(scene)).toBe(false);
    expect(scene.lights).toHaveLength(1);
    expect(scene.environment.radiance).toEqual([0, 0, 0]);
  });

  test("nor has one with a surface that emits", async () => {
    const { scene } = await load((json) => {
      json.materials = [{ emissiveFactor: [1, 1, 1] }];
      json.meshes[0].primitives[0].material = 0;
    });
    expect(hasGround(scene)).toBe(false);
    expect(scene.lights).toEqual([]);
  });

  test("a light that is too dim to see by stays beside the table's", async () => {
    const { scene } = await load((json) => withLight(json, { type: "point", intensity: 0.1 }));
    expect(hasGround(scene)).toBe(true);
    expect(scene.lights.map(({ type }) => type)).toEqual(["point", "sphere"]);
  });

  test("a spot lights a model that is in its cone", async () => {
    const spotlit = async (translation: number[]) => {
      const { scene } = await load((json) => {
        withLight(json, { type: "spot", intensity: 100, spot: { outerConeAngle: 0.3 } });
        json.nodes.at(-1)!.translation = translation;
      });
      return !hasGround(scene);
    };
    expect(await spotlit([0.3, 0.3, 3])).toBe(true);
    expect(await spotlit([2.3, 0.3, 3])).toBe(false);
  });

  test("a sun lights a model that faces it", async () => {
    const sunlit = async (intensity: number, rotation: number[]) => {
      const { scene } = await load((json) => {
        withLight(json, { type: "directional", intensity });
        json.nodes.at(-1)!.rotation = rotation;
      });
      return !hasGround(scene);
    };
    expect(await sunlit(1, [0, 0, 0, 1])).toBe(true);
    expect(await sunlit(1, [0, 1, 0, 0])).toBe(false); // from behind
    expect(await sunlit(0.1, [0, 0, 0, 1])).toBe(false);
  });

  test("a model all in one point, and a file with nothing in it, are valid scenes", async () => {
    await load((json) => {
      json.nodes[0].scale = [0, 0, 0];
    });
    const { scene, warnings } = await load((json) => {
      json.nodes = [{}];
    });
    expect(scene.objects).toEqual([]);
    expect(warnings).toEqual(["The file has no triangles, so there is nothing to see"]);
  });
});

function minus(a: readonly number[], b: readonly number[]): number[] {
  return a.map((value, i) => value - b[i]!);
}

function dot(a: readonly number[], b: readonly number[]): number {
  return a.reduce((sum, value, i) => sum + value * b[i]!, 0);
}

function unit(a: readonly number[]): number[] {
  return a.map((value) => value / Math.hypot(...a));
}
