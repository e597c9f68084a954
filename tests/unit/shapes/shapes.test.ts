import { describe, expect, test } from "vitest";
import { add, dot, scale, subtract } from "../../../src/math/vec3";
import type { Vec3 } from "../../../src/scene/schema";
import { hullOf, reachAlong, type Shape } from "../../../src/shapes/shapes";
import { createRandom, randomDirection } from "../../support/random";

const random = createRandom(5);
const triple = (): Vec3 => scale(randomDirection(random), 4 * random());
const normal: Vec3 = [0, 1, 0];

const SHAPES: Readonly<Record<string, () => Shape>> = {
  sphere: () => ({ kind: "sphere", center: triple(), radius: random() }),
  quad: () => ({ kind: "quad", corner: triple(), edge1: triple(), edge2: triple(), normal, axis: undefined }),
  triangle: () => ({ kind: "triangle", vertices: [triple(), triple(), triple()], normal }),
  box: () => ({ kind: "box", center: triple(), halfSize: [random(), random(), random()], turn: 7 * random() }),
  "box that is not turned": () => ({ kind: "box", center: triple(), halfSize: [1, 2, 3], turn: undefined }),
  mesh: () => {
    const lower = triple();
    return { kind: "mesh", lower, upper: add(lower, [random(), random(), random()]), light: undefined };
  },
};

describe.each(Object.keys(SHAPES))("a %s, seed 5", (kind) => {
  test("reaches as far as the farthest of its points, seen from anywhere", () => {
    for (let i = 0; i < 200; i++) {
      const [shape, direction, from] = [SHAPES[kind]!(), randomDirection(random), triple()];
      const farthest = Math.max(...extremes(shape, direction).map((point) => dot(subtract(point, from), direction)));
      expect(reachAlong(shape, direction, from)).toBeCloseTo(farthest, 12);
    }
  });
});

/** Points of what holds a shape, those farthest along a direction among them. */
function extremes(shape: Shape, direction: Vec3): readonly Vec3[] {
  const hull = hullOf(shape)!;
  return "ball" in hull ? [add(hull.ball.center, scale(direction, hull.ball.radius))] : hull.points;
}

test("a plane reaches to infinity", () => {
  expect(reachAlong({ kind: "plane", point: [0, 0, 0], normal, axis: "Y" }, [0, 1, 0], [0, 0, 0])).toBe(Infinity);
});
