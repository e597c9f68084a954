import { describe, expect, test } from "vitest";
import { type Emitter, emittersOf, emitterWindow, shareOf, type Window } from "../../../src/compile/emitterWindow";
import type { Frustum, Lens } from "../../../src/compile/frustum";
import { add, cross, dot, normalize, scale, subtract } from "../../../src/math/vec3";
import type { Vec3 } from "../../../src/scene/schema";
import { hullOf, type Shape } from "../../../src/shapes/shapes";
import { createRandom, randomDirection } from "../../support/random";

const random = createRandom(21);
const VIEWS = 300;
const POINTS = 400;

const triple = (size: number): Vec3 => scale(randomDirection(random), size * random());

function randomView(isOrthographic: boolean): Frustum {
  const forward = randomDirection(random);
  const side = normalize(cross(forward, randomDirection(random)));
  const [halfWidth, halfHeight] = [0.1 + random(), 0.1 + random()].map((half) => (isOrthographic ? 4 * half : half));
  const [right, up] = [scale(side, halfWidth!), scale(cross(side, forward), halfHeight!)];
  return { origin: triple(8), forward, right, up, isOrthographic };
}

const VISIBLE_EMITTERS: Readonly<Record<string, () => { shape: Shape; point: () => Vec3 }>> = {
  sphere: () => {
    const [center, radius] = [triple(5), 0.1 + 2 * random()];
    return {
      shape: { kind: "sphere", center, radius },
      point: () => add(center, scale(randomDirection(random), radius)),
    };
  },
  quad: () => {
    const [corner, edge1, edge2] = [triple(5), triple(3), triple(3)];
    const normal = normalize(cross(edge1, edge2));
    const point = () => add(corner, add(scale(edge1, random()), scale(edge2, random())));
    return { shape: { kind: "quad", corner, edge1, edge2, normal, axis: undefined }, point };
  },
  box: () => {
    const [center, turn] = [triple(5), 7 * random()];
    const halfSize: Vec3 = [random(), random(), random()];
    const point = (): Vec3 => {
      const [x, y, z] = halfSize.map((half) => half * (2 * random() - 1)) as [number, number, number];
      const [c, s] = [Math.cos(turn), Math.sin(turn)];
      return add(center, [c * x + s * z, y, c * z - s * x]);
    };
    return { shape: { kind: "box", center, halfSize, turn }, point };
  },
};

/** Image plane coordinates of a point in view, else undefined. */
function project(point: Vec3, view: Frustum): [number, number] | undefined {
  const { origin, forward, right, up, isOrthographic } = view;
  const offset = subtract(point, origin);
  const depth = dot(offset, forward);
  if (depth <= 0) return undefined;
  const size = isOrthographic ? 1 : depth;
  const [x, y] = [right, up].map((axis) => dot(offset, axis) / (size * dot(axis, axis))) as [number, number];
  return Math.abs(x) <= 1 && Math.abs(y) <= 1 ? [x, y] : undefined;
}

/** Where the picture shows a point to some place of the lens; undefined for outside of it. */
function blurred(point: Vec3, view: Frustum & { readonly lens: Lens }): [number, number] | undefined {
  const { origin, forward, right, up, isOrthographic, lens } = view;
  const [turn, from] = [7 * random(), lens.radius * Math.sqrt(random())];
  const place = add(scale(normalize(right), from * Math.cos(turn)), scale(normalize(up), from * Math.sin(turn)));
  const toPoint = subtract(point, origin);
  const depth = dot(toPoint, forward);
  if (depth <= 0) return undefined;
  // Rays from there to the plane of focus go through the point where they have come this far.
  const share = depth / lens.focus;
  const moved = subtract(toPoint, scale(place, 1 - share));
  const size = isOrthographic ? 1 : depth;
  const [x, y] = [right, up].map((axis) => dot(moved, axis) / (size * dot(axis, axis))) as [number, number];
  return Math.abs(x) <= 1 && Math.abs(y) <= 1 ? [x, y] : undefined;
}

const contains = ([left, bottom, right, top]: Window, [x, y]: [number, number]) =>
  x >= left - 1e-9 && x <= right + 1e-9 && y >= bottom - 1e-9 && y <= top + 1e-9;

describe.each(Object.keys(VISIBLE_EMITTERS))("the window of a %s, seed 21", (kind) => {
  test.each([false, true])("holds every point of it that is in view, orthographic: %s", (isOrthographic) => {
    let seen = 0;
    for (let i = 0; i < VIEWS; i++) {
      const { shape, point } = VISIBLE_EMITTERS[kind]!();
      const view = randomView(isOrthographic);
      const window = emitterWindow(emittersOf([shape]), view);
      const points = Array.from({ length: POINTS }, () => project(point(), view)).filter((p) => p !== undefined);
      seen += points.length;
      expect(points.every((p) => contains(window, p))).toBe(true);
    }
    expect(seen).toBeGreaterThan(1000);
  });
});

const PLANE: Shape = { kind: "plane", point: [0, 0, 0], normal: [0, 1, 0], axis: "Y" };
const FRONT: Frustum = { origin: [0, 0, 10], forward: [0, 0, -1], right: [0.5, 0, 0], up: [0, 0.5, 0] };

test("a ball's window ends at its tangents", () => {
  const [, , right] = emitterWindow([{ ball: { center: [0, 0, 0], radius: 1 } }], FRONT);
  expect(right).toBeCloseTo(Math.tan(Math.asin(1 / 10)) / 0.5, 12);
});

describe.each(Object.keys(VISIBLE_EMITTERS))("through a lens the window of a %s, seed 21", (kind) => {
  test.each([false, true])("holds every point of the picture that may show it, orthographic: %s", (isOrthographic) => {
    let seen = 0;
    for (let i = 0; i < VIEWS; i++) {
      const { shape, point } = VISIBLE_EMITTERS[kind]!();
      const view = { ...randomView(isOrthographic), lens: { radius: 0.5 * random(), focus: 0.2 + 8 * random() } };
      const window = emitterWindow(emittersOf([shape]), view);
      const points = Array.from({ length: POINTS }, () => blurred(point(), view)).filter((p) => p !== undefined);
      seen += points.length;
      expect(points.every((p) => contains(window, p))).toBe(true);
    }
    expect(seen).toBeGreaterThan(1000);
  });
});

test("through a lens a window is wider by the blur, and not in the plane of focus", () => {
  const view: Frustum = { ...FRONT, lens: { radius: 0.4, focus: 8 } };
  const flat = (depth: number): Emitter => ({
    points: [
      [-1, -1, 10 - depth],
      [1, 1, 10 - depth],
    ],
  });
  for (const depth of [4, 8, 30]) {
    const edge = (1 / depth + 0.4 * Math.abs(1 / depth - 1 / 8)) / 0.5;
    expect(emitterWindow([flat(depth)], view)[2]).toBeCloseTo(edge, 5);
  }
  expect(shareOf(emitterWindow([flat(-1)], view))).toBe(0);
  expect(
    shareOf(
      emitterWindow(
        [
          {
            points: [
              [0, 0, 10.1],
              [0, 0, 9],
            ],
          },
        ],
        view,
      ),
    ),
  ).toBe(1);
});

test("in an orthographic view a window is as large as what it holds, however far that is", () => {
  const view: Frustum = { ...FRONT, right: [4, 0, 0], up: [0, 2, 0], isOrthographic: true };
  for (const z of [9.5, 0, -1e6]) {
    const window = emitterWindow([{ ball: { center: [1, 0, z], radius: 1 } }], view);
    expect(window).toEqual([0, -0.5, 0.5, 0.5]);
  }
  expect(shareOf(emitterWindow([{ ball: { center: [0, 0, 11.5], radius: 1 } }], view))).toBe(0);
  expect(shareOf(emitterWindow([{ points: [[4.5, 0, 0]] }], view))).toBe(0);
});

test("several lamps share the window around all of them", () => {
  const lamps = [-1, 1].map((x): Emitter => ({ ball: { center: [2 * x, 0, 0], radius: 0.5 } }));
  const [left, bottom, right, top] = emitterWindow(lamps, FRONT);
  expect(left).toBeCloseTo(-right, 12);
  expect(right).toBeGreaterThan(2.5 / 5);
  expect(top - bottom).toBeLessThan(0.25);
});

test("what is behind the camera or beside the image has no window, a plane the whole image", () => {
  const ball = (center: Vec3): Emitter => ({ ball: { center, radius: 1 } });
  expect(shareOf(emitterWindow([ball([0, 0, 20])], FRONT))).toBe(0);
  expect(shareOf(emitterWindow([ball([30, 0, 0])], FRONT))).toBe(0);
  expect(shareOf(emitterWindow([], FRONT))).toBe(0);
  expect(shareOf(emitterWindow(emittersOf([PLANE]), FRONT))).toBe(1);
});

test("of many lamps the box around them is looked at, whose window holds each one's", () => {
  const many = Array.from({ length: 1000 }, (): Shape => ({ kind: "sphere", center: triple(2), radius: 0.1 }));
  expect(emittersOf(many)).toMatchObject([{ points: { length: 8 } }]);
  const [left, bottom, right, top] = emitterWindow(emittersOf(many), FRONT);
  const exact = emitterWindow(many.map(hullOf), FRONT);
  expect(exact.map((edge, i) => (i < 2 ? edge >= [left, bottom][i]! : edge <= [right, top][i - 2]!))).not.toContain(
    false,
  );
  expect(shareOf([left, bottom, right, top])).toBeLessThan(2 * shareOf(exact));
  expect(emittersOf([...many, PLANE])).toEqual([undefined]);
  expect(emittersOf(many.slice(0, 10))).toEqual(many.slice(0, 10).map(hullOf));
});
