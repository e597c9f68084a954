import { describe, expect, test } from "vitest";
import { type CompiledScene, compileScene } from "../../../src/compile/compileScene";
import { cameraBasis, emitterPixels, rayStart } from "../../../src/renderer/cameraBasis";
import { parseScene } from "../../../src/scene/parseScene";
import type { Light, ResolvedScene, Scene, SceneObject, Vec3 } from "../../../src/scene/schema";
import { type Geometry, prepareGeometry } from "../../../src/tree/geometry";
import { unpack } from "../../support/compiled";
import { growthOf, LINEAR } from "../../support/growth";
import { cube, meshObject, placed } from "../../support/meshes";
import { createRandom } from "../../support/random";

const SETTINGS = { estimator: "path", sampler: "sobol", lightSamples: 1 } as const;
const MATERIALS = {
  red: { baseColor: [0.8, 0.2, 0.2] },
  green: { baseColor: [0.2, 0.8, 0.2], roughness: 0.5 },
  blue: { baseColor: [0.2, 0.2, 0.8], ior: 1 },
  glow: { ior: 1, emission: [1, 2, 3] },
} as const;
const POINT: Light = { type: "point", position: [0, 9, 0], power: [99, 99, 99] };

const sceneOf = (objects: readonly SceneObject[], lights: readonly Light[] = [POINT]): Scene => ({
  camera: { position: [0, 1, 60] },
  materials: MATERIALS,
  objects,
  lights,
});

const random = createRandom(12);
const anywhere = (): Vec3 => [20 * random() - 10, 20 * random() - 10, 20 * random() - 10];

const spheres = (count: number, names: readonly string[]): SceneObject[] =>
  Array.from({ length: count }, (_, i) => {
    return { type: "sphere", center: anywhere(), radius: 0.1, material: names[i % names.length]! };
  });
const THREE = ["red", "green", "blue"];

/** A growing number of something, and nothing else. */
const CROWDS: Readonly<Record<string, (count: number) => Scene>> = {
  "spheres in one material": (count) => sceneOf(spheres(count, ["red"])),
  "spheres in three materials": (count) => sceneOf(spheres(count, THREE)),
  "spheres that shine": (count) => sceneOf(spheres(count, ["glow"])),
  "boxes that shine": (count) =>
    sceneOf(spheres(count, []).map(() => ({ type: "box", center: anywhere(), size: [1, 1, 1], material: "glow" }))),
  "sphere lights": (count) =>
    sceneOf(
      [],
      spheres(count, []).map(() => ({ type: "sphere", position: anywhere(), radius: 0.1, power: [1, 1, 1] })),
    ),
  "point lights": (count) =>
    sceneOf(
      spheres(40, THREE),
      spheres(count, []).map(() => ({ ...POINT, position: anywhere() })),
    ),
  "meshes in two materials": (count) =>
    sceneOf(Array.from({ length: count }, (_, i) => meshObject(placed(cube(), 0.1, anywhere()), THREE[i % 2]!))),
  "meshes that shine": (count) =>
    sceneOf(Array.from({ length: count }, () => meshObject(placed(cube(), 0.1, anywhere()), "glow"))),
  planes: (count) =>
    sceneOf(
      Array.from({ length: count }, (_, i) => {
        return { type: "plane", point: [0, -1 - i, 0], normal: [i / 100, 1, 0], material: THREE[i % 3]! };
      }),
    ),
  "huge spheres": (count) =>
    sceneOf(
      Array.from({ length: count }, (_, i) => {
        return { type: "sphere", center: [0, -1e5 - i / 100, 0], radius: 1e5, material: THREE[i % 3]! };
      }),
    ),
  "triangles without area": (count) =>
    sceneOf(
      Array.from({ length: count }, (_, i) => {
        const vertices = [0, 1, 2].map((x): Vec3 => [x, i, 0]) as [Vec3, Vec3, Vec3];
        return { type: "triangle", vertices, material: THREE[i % 3]! };
      }),
    ),
};

type Prepared = { readonly scene: ResolvedScene; readonly geometry: Geometry | undefined };

async function prepared(scene: Scene): Promise<Prepared> {
  const resolved = parseScene(scene);
  return { scene: resolved, geometry: await prepareGeometry(resolved) };
}

const compile = ({ scene, geometry }: Prepared): CompiledScene => compileScene(scene, SETTINGS, undefined, geometry);

describe.each(Object.keys(CROWDS))("%s", { timeout: 60_000 }, (name) => {
  test("of four times the number are compiled to a text of the same length", async () => {
    for (const isResting of [false, true]) {
      const lengths = [1000, 4000].map(async (count) => {
        const crowd = await prepared(CROWDS[name]!(count));
        const compiled = isResting ? compile(crowd).atRest(crowd.scene.camera) : compile(crowd);
        // But for digits, and the kind of buffer.
        return compiled.sceneModule.replaceAll(/-?\d[\d.]*(e-?\d+)?/g, "0").replace("storage, read", "uniform").length;
      });
      expect(await lengths[1]).toBe(await lengths[0]);
    }
  });

  test("are compiled in a time that does not grow with the square of their number", async () => {
    const [few, many] = [await prepared(CROWDS[name]!(1000)), await prepared(CROWDS[name]!(4000))];
    const work = (count: number) => {
      const crowd = count === 1000 ? few : many;
      for (let i = 0; i < 2; i++) compile(crowd).atRest(crowd.scene.camera);
    };
    expect(await growthOf(work, 1000)).toBeLessThan(LINEAR);
  });
});

test("the longest chain of comparisons stays far from the 512 that compilers refuse", async () => {
  const crowd = await prepared(sceneOf(spheres(1100, ["red", "blue"])));
  for (const count of [2, 20, 60, 1100]) {
    const scene = { ...crowd.scene, objects: crowd.scene.objects.slice(0, count) };
    const { sceneModule } = compileScene(scene, SETTINGS, scene.camera, await prepareGeometry(scene));
    for (const line of sceneModule.split("\n")) expect(line.split("|").length).toBeLessThan(64);
  }
});

describe("the largest crowds", { timeout: 60_000 }, () => {
  test("thirty-two thousand spheres in three materials are compiled, at rest too", async () => {
    const crowd = await prepared(CROWDS["spheres in three materials"]!(32_768));
    const compiled = compile(crowd).atRest(crowd.scene.camera);
    expect(compiled.sceneModule.length).toBeLessThan(5000);
    expect(compiled.shapes).toHaveLength(32_768);
  });

  test("a hundred and thirty thousand lights do not overflow the stack", async () => {
    const crowd = await prepared(CROWDS["point lights"]!(130_000));
    const compiled = compile(crowd).atRest(crowd.scene.camera);
    expect(compiled.sceneModule).toContain("lights: array<Light, 130000>");
  });

  test("as many sphere lights do not when a camera looks at them", async () => {
    const crowd = await prepared(CROWDS["sphere lights"]!(130_000));
    const { shapes, emitters, origin } = compile(crowd);
    const basis = cameraBasis(crowd.scene.camera, origin, 1);
    expect(rayStart(basis, shapes).near).toBeGreaterThan(40);
    const { emittersFrom, emittersTo } = emitterPixels(emitters, basis, 100, 100);
    expect(emittersTo[0]! - emittersFrom[0]!).toBeGreaterThan(10);
  });
});

describe("a moving camera", () => {
  const from = (scene: ResolvedScene, position: Vec3) => ({ ...scene.camera, position });

  test("compiles nothing where it makes no difference", async () => {
    const crowd = await prepared(CROWDS["spheres in three materials"]!(2000));
    const compiled = compile(crowd);
    const atRest = compiled.atRest(crowd.scene.camera);
    for (let i = 0; i < 100; i++) expect(compiled.atRest(from(crowd.scene, [i, i, 60]))).toBe(atRest);
  });

  test("that goes below a plane gets a program in which the plane blocks light", async () => {
    const ground: SceneObject = { type: "plane", point: [0, 0, 0], normal: [0, 1, 0], material: "red" };
    const crowd = await prepared(sceneOf([ground]));
    const compiled = compile(crowd);
    const [above, below] = [1, -1].map((y) => compiled.atRest(from(crowd.scene, [0, y, 60])));
    expect(above!.sceneModule).not.toContain("blocked |=");
    expect(below!.sceneModule).toContain("blocked |=");
    expect(compiled.atRest(from(crowd.scene, [0, 1, 60]))).toEqual(above);
    expect(compileScene(crowd.scene, SETTINGS, from(crowd.scene, [0, -1, 60]))).toEqual(below);
  });
});

test("planes and huge spheres past what is unrolled are rows of a table that is as long as its struct", async () => {
  const objects = [...CROWDS.planes!(50).objects, ...CROWDS["huge spheres"]!(7).objects];
  const crowd = await prepared(sceneOf(objects));
  const compiled = compile(crowd);
  const { planes, hugeSpheres, bytes } = unpack(compiled);
  expect(planes).toHaveLength(10);
  expect(planes[0]).toMatchObject({ id: 40, point: [0, -41, 0] });
  expect(hugeSpheres.map(({ id }) => id)).toEqual([50, 51, 52, 53, 54, 55, 56]);
  expect(bytes).toBe(compiled.uniform.byteLength);
});

test("a triangle whose vertices are one point puts no NaN into a program", async () => {
  const vertices: [Vec3, Vec3, Vec3] = [[1, 1, 1], [1, 1, 1], [1, 1, 1]]; // biome-ignore format: one line
  const objects: SceneObject[] = [0, 1, 2].map(() => ({ type: "triangle", vertices, material: "red" }));
  const crowd = await prepared(sceneOf(objects));
  const compiled = compile(crowd);
  expect(compiled.atRest(crowd.scene.camera).sceneModule).not.toContain("NaN");
  expect(unpack(compiled).anchors.flat().some(Number.isNaN)).toBe(false);
});

test("a change of a value does not sort thousands of shapes anew, and is not slow to find that out", async () => {
  const [few, many] = await Promise.all(
    [4000, 16_000].map((count) => prepared(CROWDS["spheres in one material"]!(count))),
  );
  const work = async (count: number) => {
    const { scene, geometry } = count === 4000 ? few! : many!;
    expect(await prepareGeometry(scene, { previous: geometry })).toBe(geometry);
  };
  expect(await growthOf(work, 4000)).toBeLessThan(LINEAR);
});
