import { describe, expect, test } from "vitest";
import { parseScene } from "../../../src/scene/parseScene";
import type { SceneObject, Vec3 } from "../../../src/scene/schema";
import { MAX_UNROLLED, needsGeometry } from "../../../src/tree/boundedShapes";
import { treeShapesOf } from "../../../src/tree/treeShapes";
import { createRandom } from "../../support/random";

const material = "m";

/** Small spheres in a cube of side 2. */
function balls(count: number, seed = 1): SceneObject[] {
  const random = createRandom(seed);
  const at = (): Vec3 => [2 * random() - 1, 2 * random() - 1, 2 * random() - 1];
  return Array.from({ length: count }, () => ({ type: "sphere", center: at(), radius: 0.02, material }));
}

/** The walls of that cube, nearly, with its front left open. */
const WALLS: readonly SceneObject[] = [
  { type: "quad", corner: [-1, -1, -1], edge1: [2, 0, 0], edge2: [0, 2, 0], material },
  { type: "quad", corner: [-1, -1, -1], edge1: [0, 2, 0], edge2: [0, 0, 2], material },
  { type: "quad", corner: [1, -1, -1], edge1: [0, 0, 2], edge2: [0, 2, 0], material },
  { type: "quad", corner: [-1, -1, -1], edge1: [0, 0, 2], edge2: [2, 0, 0], material },
  { type: "box", center: [0, 1, 0], size: [2, 0.1, 2], material },
];

const sceneOf = (objects: readonly SceneObject[]) =>
  parseScene({ camera: { position: [0, 0, 5], target: [0, 0, 0] }, materials: { m: {} }, objects });
const inTree = (objects: readonly SceneObject[]) => treeShapesOf(sceneOf(objects)).map(({ id }) => objects[id]!);

test("few shapes are all unrolled, of one more the small ones are in the tree", () => {
  expect(inTree(balls(MAX_UNROLLED))).toEqual([]);
  expect(inTree(balls(MAX_UNROLLED + 1))).toEqual(balls(MAX_UNROLLED + 1));
});

test("planes are neither counted nor in the tree", () => {
  const planes = balls(MAX_UNROLLED).map((): SceneObject => {
    return { type: "plane", point: [0, 0, 0], normal: [0, 1, 0], material };
  });
  expect(inTree(planes)).toEqual([]);
  expect(inTree([...planes, ...balls(MAX_UNROLLED)])).toEqual([]);
  expect(inTree([...planes, ...balls(40)])).toEqual(balls(40));
});

test("a room's walls stay unrolled", () => {
  expect(inTree([...WALLS, ...balls(100)])).toEqual(balls(100));
});

test("a kind of which there are a few small ones stays unrolled, of five they are in the tree", () => {
  const tiles = (count: number) =>
    Array.from({ length: count }, (_, i): SceneObject => {
      return { type: "quad", corner: [0.1 * i, 0, 0], edge1: [0.1, 0, 0], edge2: [0, 0, 0.1], material };
    });
  expect(inTree([...tiles(4), ...WALLS, ...balls(40)])).toEqual(balls(40));
  expect(inTree([...tiles(5), ...WALLS, ...balls(40)])).toEqual([...tiles(5), ...balls(40)]);
});

test("of many large shapes the largest sixteen stay unrolled", () => {
  const shells = Array.from({ length: 50 }, (_, i): SceneObject => {
    return { type: "sphere", center: [0, 0, 0], radius: 1 + 0.001 * i, material };
  });
  expect(inTree(shells)).toEqual(shells.slice(0, -16));
});

describe.each([1, 2, 3])("shapes of all kinds and sizes, seed %d", (seed) => {
  const random = createRandom(seed);
  const at = (): Vec3 => [random(), random(), random()];
  const size = () => 10 ** (3 * random() - 3);
  const kinds: readonly (() => SceneObject)[] = [
    () => ({ type: "sphere", center: at(), radius: size(), material }),
    () => ({ type: "box", center: at(), size: [size(), size(), size()], material }),
    () => ({ type: "quad", corner: at(), edge1: [size(), 0, 0], edge2: [0, size(), 0], material }),
    () => ({ type: "triangle", vertices: [at(), at(), at()], material }),
  ];

  test.each([33, 34, 40, 60, 200])("of %d, some are in the tree and no more than 32 are unrolled", (count) => {
    const objects = Array.from({ length: count }, () => kinds[Math.floor(4 * random())]!());
    const shapes = inTree(objects);
    expect(needsGeometry(sceneOf(objects))).toBe(true);
    expect(shapes.length).toBeGreaterThan(0);
    expect(count - shapes.length).toBeLessThanOrEqual(MAX_UNROLLED);
  });
});
