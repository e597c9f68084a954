import { describe, expect, test } from "vitest";
import { primitivesOf } from "../../../src/compile/primitives";
import { box, plane, pointLight, quad, sphere, sphereLight, triangle } from "../../../src/scene/builders";
import { parseScene } from "../../../src/scene/parseScene";
import { partOf } from "../../../src/scene/parts";
import type { SceneObject, Vec3 } from "../../../src/scene/schema";
import type { Shape } from "../../../src/shapes/shapes";
import { sceneOf } from "../../support/compiled";

const material = "lambert";

function shapeOf(object: SceneObject, origin: Vec3 = [0, 0, 0]): Shape {
  const scene = sceneOf([object]);
  const [x, y, z] = origin;
  const camera = { position: [x, y + 1, z + 5], target: origin } as const;
  return primitivesOf(parseScene({ ...scene, camera }))[0]!.shape;
}

function normalOf(object: SceneObject): Vec3 {
  const shape = shapeOf(object);
  if (!("normal" in shape)) throw new TypeError(`${shape.kind} has no normal of its own`);
  return shape.normal;
}

/** Equal up to a few roundings of doubles. */
function expectVector(actual: Vec3, expected: Vec3): void {
  for (const [i, component] of expected.entries()) expect(actual[i]).toBeCloseTo(component, 14);
}

test("objects come first, then sphere lights; point lights are no primitives", () => {
  const lights = [
    sphereLight({ position: [0, 9, 0], radius: 1, power: [1, 1, 1] }),
    pointLight({ position: [0, 8, 0], power: [1, 1, 1] }),
  ];
  const objects = [
    plane({ point: [0, 0, 0], normal: [0, 1, 0], material }),
    sphere({ center: [0, 1, 0], radius: 1, material }),
  ];
  const primitives = primitivesOf(parseScene(sceneOf(objects, lights)));
  expect(primitives.map(({ shape }) => shape.kind)).toEqual(["plane", "sphere", "sphere"]);
  expect(primitives.map((primitive) => primitive.material === "black")).toEqual([false, false, true]);
});

test("each primitive's part of the scene is found by its id", () => {
  const sphereAt = (y: number) => sphereLight({ position: [0, y, 0], radius: 1, power: [1, 1, 1] });
  const lights = [pointLight({ position: [0, 8, 0], power: [1, 1, 1] }), sphereAt(9), sphereAt(12)];
  const objects = [sphere({ center: [0, 1, 0], radius: 1, material })];
  const scene = parseScene(sceneOf(objects, lights));
  const parts = primitivesOf(scene).map((_, id) => partOf(scene, id));
  expect(parts).toEqual([
    { kind: "object", index: 0 },
    { kind: "light", index: 1 },
    { kind: "light", index: 2 },
  ]);
});

test("positions are relative to the origin, in doubles", () => {
  const far: Vec3 = [1e9, -1e9, 1e9];
  const near = (dx: number): Vec3 => [1e9 + dx, -1e9, 1e9];
  expect(shapeOf(sphere({ center: near(0.125), radius: 2, material }), far)).toEqual({
    kind: "sphere",
    center: [0.125, 0, 0],
    radius: 2,
  });
  expect(shapeOf(box({ center: near(0.5), size: [2, 4, 6], material }), far)).toMatchObject({ center: [0.5, 0, 0] });
  expect(shapeOf(plane({ point: near(1), normal: [1, 0, 0], material }), far)).toMatchObject({ point: [1, 0, 0] });
  expect(shapeOf(quad({ corner: near(2), edge1: [1, 0, 0], edge2: [0, 1, 0], material }), far)).toMatchObject({
    corner: [2, 0, 0],
  });
  const vertices = [near(0), near(1), [1e9, -1e9 + 1, 1e9]] as const;
  expect(shapeOf(triangle({ vertices, material }), far)).toMatchObject({
    vertices: [
      [0, 0, 0],
      [1, 0, 0],
      [0, 1, 0],
    ],
  });
});

describe("normals", () => {
  test("a plane's is made unit", () => {
    expectVector(normalOf(plane({ point: [0, 0, 0], normal: [0, 3, 4], material })), [0, 0.6, 0.8]);
  });

  test("a quad's is edge1 × edge2", () => {
    const edges = { edge1: [0, 0, 2], edge2: [3, 0, 0] } as const;
    expect(shapeOf(quad({ corner: [0, 0, 0], ...edges, material }))).toMatchObject({ normal: [0, 1, 0] });
  });

  test("a triangle's is on the side from which the vertices run counter-clockwise", () => {
    const counterClockwise = [
      [0, 0, 0],
      [2, 0, 0],
      [0, 2, 0],
    ] as const;
    expect(shapeOf(triangle({ vertices: counterClockwise, material }))).toMatchObject({ normal: [0, 0, 1] });
  });

  test("a triangle without area still has a unit one", () => {
    const vertices = [
      [1, 1, 1],
      [1, 1, 1],
      [2, 2, 2],
    ] as const;
    expect(Math.hypot(...normalOf(triangle({ vertices, material })))).toBe(1);
  });

  test.each([1e-15, 1e15])("a quad of size %d has a unit one", (size) => {
    const object = quad({ corner: [0, 0, 0], edge1: [size, 0, 0], edge2: [size, size, 0], material });
    expectVector(normalOf(object), [0, 0, 1]);
  });
});

describe("axes", () => {
  test.each<[Vec3, string | undefined]>([
    [[2, 0, 0], "X"],
    [[0, -1, 0], "Y"],
    [[0, 0, 5], "Z"],
    [[1, 1e-9, 0], undefined],
  ])("a plane with normal %j is perpendicular to %s", (normal, axis) => {
    expect(shapeOf(plane({ point: [0, 0, 0], normal, material }))).toMatchObject({ axis });
  });

  test.each<[Vec3, Vec3, string | undefined]>([
    [[0, 1, 0], [0, 0, 1], "X"],
    [[0, 0, -2], [1, 0, 0], "Y"],
    [[1, 0, 0], [0, 3, 0], "Z"],
    [[1, 1, 0], [-1, 1, 0], undefined], // in the plane of an axis, but turned in it
    [[1, 0, 0], [1, 1, 0], undefined], // a parallelogram
  ])("a quad with edges %j and %j is an axis-aligned rectangle across %s", (edge1, edge2, axis) => {
    expect(shapeOf(quad({ corner: [0, 0, 0], edge1, edge2, material }))).toMatchObject({ axis });
  });
});

describe("boxes", () => {
  test("are held by centre and half size", () => {
    const shape = shapeOf(box({ center: [1, 2, 3], size: [2, 4, 6], material }));
    expect(shape).toMatchObject({ center: [1, 2, 3], halfSize: [1, 2, 3] });
  });

  test.each([0, 180, -360, 540])("turned by %d degrees are axis-aligned", (rotationY) => {
    const shape = shapeOf(box({ center: [0, 0, 0], size: [1, 1, 1], rotationY, material }));
    expect(shape).toMatchObject({ turn: undefined });
  });

  test("turned otherwise have an angle in radians", () => {
    const shape = shapeOf(box({ center: [0, 0, 0], size: [1, 1, 1], rotationY: 45, material }));
    expect(shape).toMatchObject({ turn: Math.PI / 4 });
  });
});

test("a sphere light's radiance is power / (4π²·radius²)", () => {
  const light = sphereLight({ position: [0, 0, 0], radius: 0.5, power: [10, 20, 0] });
  const [primitive] = primitivesOf(parseScene(sceneOf([], [light])));
  const area = Math.PI * 4 * 0.5 ** 2;
  expect(primitive!.emission[0]).toBeCloseTo(10 / (Math.PI * area), 12);
  expect(primitive!.emission[1]).toBeCloseTo(20 / (Math.PI * area), 12);
  expect(primitive!.emission[2]).toBe(0);
});
