import { describe, expect, test } from "vitest";
import { clearDepth } from "../../../src/compile/clearDepth";
import type { Frustum } from "../../../src/compile/frustum";
import type { ResolvedObject } from "../../../src/scene/schema";
import type { Shape } from "../../../src/shapes/shapes";
import { add, cross, meetings, scale, subtract } from "../../support/oracle";
import { createRandom, randomDirection } from "../../support/random";
import { unit } from "../../support/solids";

// A camera 1000 in front of the origin; the image spans ±0.01.
const VIEW: Frustum = { origin: [0, 0, 1000], forward: [0, 0, -1], right: [0.01, 0, 0], up: [0, 0.01, 0] };
const BALL: Shape = { kind: "sphere", center: [0, 0, 0], radius: 1 };
const plane = (point: readonly [number, number, number], normal: readonly [number, number, number]): Shape => ({
  kind: "plane",
  point,
  normal,
  axis: undefined,
});

describe("the depth in front of which a view is clear", () => {
  test("is that of the nearest shape, less a thousandth", () => {
    const depth = clearDepth([BALL, { kind: "box", center: [0, 0, -9], halfSize: [1, 1, 1], turn: 0.3 }], VIEW);
    expect(depth).toBeLessThan(999);
    expect(depth).toBeGreaterThan(997.9);
  });

  test("is 0 where a shape reaches the camera", () => {
    expect(clearDepth([{ ...BALL, radius: 2000 }], VIEW)).toBe(0);
    expect(clearDepth([BALL, { ...BALL, center: [0, 0, 1000.5] }], VIEW)).toBe(0);
    expect(clearDepth([{ kind: "box", center: [0, 0, 0], halfSize: [1, 1, 2000], turn: undefined }], VIEW)).toBe(0);
  });

  test("does not end at a shape that is not in view", () => {
    const behind: Shape = { ...BALL, center: [0, 0, 1500] };
    const beside: Shape = { kind: "box", center: [30, 0, 900], halfSize: [1, 1, 1], turn: undefined };
    expect(clearDepth([BALL, behind, beside], VIEW)).toBe(clearDepth([BALL], VIEW));
  });

  test("ends where a planet comes into view, not where it comes closest to the camera", () => {
    // From 50 above a planet of radius 10⁴ the horizon is a little more than 1000 away; the image shows it and a part before it.
    const radius = 1e4;
    const dip = Math.acos(radius / (radius + 50));
    const [c, s] = [Math.cos(dip), Math.sin(dip)];
    const view: Frustum = { ...VIEW, forward: [0, -s, -c], up: [0, 0.01 * c, -0.01 * s] };
    const depth = clearDepth([{ kind: "sphere", center: [0, -radius - 50, 1000], radius }], view);
    const toEdge = Math.PI / 2 - dip - Math.atan(0.01); // from straight down
    const [across, along] = [(radius + 50) * Math.sin(toEdge), (radius + 50) * Math.cos(toEdge)];
    const first = along - Math.sqrt(radius ** 2 - across ** 2);
    expect(depth).toBeLessThan(first);
    expect(depth).toBeGreaterThan(0.9 * first);
  });

  test("is the way along a single ray, too", () => {
    const ray: Frustum = { ...VIEW, right: [0, 0, 0], up: [0, 0, 0] };
    expect(clearDepth([BALL], ray)).toBeCloseTo(999 * (1 - 2 ** -10), 9);
  });

  test("is 0 in an empty scene", () => {
    expect(clearDepth([], VIEW)).toBe(0);
  });

  test("ends where a plane enters the image", () => {
    // A floor 2 below: the image's lower edge meets it 200 away.
    const depth = clearDepth([plane([5, -2, 7], [0, 1, 0])], VIEW);
    expect(depth).toBeLessThan(200);
    expect(depth).toBeGreaterThan(199.7);
  });

  describe("of an orthographic view", () => {
    const parallel: Frustum = { ...VIEW, right: [3, 0, 0], up: [0, 4, 0], isOrthographic: true };

    test("is that of the nearest shape in view, however far beside the camera it is", () => {
      const beside: Shape = { ...BALL, center: [3.5, 0, 500] };
      const depth = clearDepth([BALL, beside, { ...BALL, center: [4.5, 0, 900] }], parallel);
      expect(depth).toBeLessThan(499);
      expect(depth).toBeGreaterThan(498.5);
      expect(clearDepth([{ ...BALL, center: [2, 3, 1001.5] }, BALL], parallel)).toBeGreaterThan(998);
    });

    test("ends where a planet comes into view, not where it comes closest to the camera", () => {
      // The planet's middle is 10⁴ + 2 below; the picture's corners reach 5 from its middle.
      const depth = clearDepth([{ kind: "sphere", center: [0, -10002, 0], radius: 1e4 }], parallel);
      const first = 1000 - Math.sqrt(1e8 - 9998 ** 2); // along the picture's lower edge
      expect(depth).toBeLessThan(first);
      expect(depth).toBeGreaterThan(0.85 * first);
    });

    test("ends where a plane enters the image, is 0 where rays start on both sides, and passes one behind all", () => {
      // Going down by 1 in 10, and 5 to 13 above the plane.
      const steep = Math.hypot(1, 0.1);
      const view: Frustum = { ...parallel, forward: [0, -0.1 / steep, -1 / steep], up: [0, 4 / steep, -0.4 / steep] };
      const depth = clearDepth([plane([0, -9, 1000], [0, 1, 0])], view);
      const first = (9 - 4 / steep) / (0.1 / steep);
      expect(depth).toBeLessThan(first);
      expect(depth).toBeGreaterThan(0.998 * first);
      expect(clearDepth([plane([0, -3, 1000], [0, 1, 0])], view)).toBe(0);
      expect(clearDepth([BALL, plane([0, 0, 1001], [0, 0.1, 1])], parallel)).toBeGreaterThan(997);
    });
  });

  test("does not end at a plane behind the camera, and is 0 on one", () => {
    expect(clearDepth([BALL, plane([0, 0, 1001], [0, 0, 1])], VIEW)).toBeGreaterThan(997);
    expect(clearDepth([BALL, plane([0, 0, 1000], [0, 0, 1])], VIEW)).toBe(0);
    expect(clearDepth([BALL, plane([0, 0, 1000], [0, 1, 0])], VIEW)).toBe(0);
  });
});

describe("no ray of a view meets anything in front of its clear depth, seed 5:", () => {
  const random = createRandom(5);
  const triple = (size: number) => scale(randomDirection(random), size * random());
  const SHAPES: Readonly<Record<string, () => { shape: Shape; object: ResolvedObject }>> = {
    sphere: () => {
      const [center, radius] = [triple(6), 0.1 + 2 * random()];
      return { shape: { kind: "sphere", center, radius }, object: { type: "sphere", center, radius, material: "m" } };
    },
    planet: () => {
      const out = randomDirection(random);
      const [radius, height] = [100 + 1e4 * random(), 6 * random()];
      const center = scale(out, radius + height);
      return { shape: { kind: "sphere", center, radius }, object: { type: "sphere", center, radius, material: "m" } };
    },
    plane: () => {
      const [point, normal] = [triple(6), randomDirection(random)];
      return { shape: plane(point, normal), object: { type: "plane", point, normal, material: "m" } };
    },
    quad: () => {
      const [corner, edge1, edge2] = [triple(6), triple(9), triple(9)];
      const normal = unit(cross(edge1, edge2));
      return {
        shape: { kind: "quad", corner, edge1, edge2, normal, axis: undefined },
        object: { type: "quad", corner, edge1, edge2, material: "m" },
      };
    },
  };

  const VIEWS: Readonly<Record<string, () => Partial<Frustum>>> = {
    pinhole: () => ({}),
    lens: () => ({ lens: { radius: random(), focus: 0.2 + 8 * random() } }),
    orthographic: () => ({ isOrthographic: true }),
    "orthographic with a lens": () => ({
      isOrthographic: true,
      lens: { radius: random(), focus: 0.2 + 8 * random() },
    }),
  };

  test.each(Object.keys(VIEWS).flatMap((view) => Object.keys(SHAPES).map((kind) => [view, kind] as const)))(
    "%s, a %s",
    (name, kind) => {
      let [met, clear] = [0, 0];
      for (let i = 0; i < 300; i++) {
        const { shape, object } = SHAPES[kind]!();
        const forward = randomDirection(random);
        const side = unit(cross(forward, randomDirection(random)));
        const kindOfView = VIEWS[name]!();
        const most = kindOfView.isOrthographic ? 4 : 1;
        const right = scale(side, 0.05 + most * random());
        const up = scale(cross(side, forward), 0.05 + most * random());
        const view: Frustum = { origin: triple(9), forward, right, up, ...kindOfView };
        const depth = clearDepth([shape], view);
        if (depth > 0) clear++;
        for (let ray = 0; ray < 40; ray++) {
          const { from, along } = rayOf(view, 2 * random() - 1, 2 * random() - 1);
          const size = Math.hypot(...along);
          const [first] = meetings([object], from, scale(along, 1 / size));
          if (first === undefined) continue;
          met++;
          expect(first.t / size).toBeGreaterThanOrEqual(depth);
        }
      }
      expect(met).toBeGreaterThan(100);
      expect(clear).toBeGreaterThan(20);
    },
  );

  /** A ray through (x, y) from some place of the lens, which advances by 1 along `forward`. */
  function rayOf({ origin, forward, right, up, isOrthographic, lens }: Frustum, x: number, y: number) {
    const offset = add(scale(right, x), scale(up, y));
    const start = isOrthographic ? add(origin, offset) : origin;
    const way = isOrthographic ? forward : add(forward, offset);
    if (!lens) return { from: start, along: way };
    const [turn, from] = [7 * random(), lens.radius * Math.sqrt(random())];
    const place = add(scale(unit(right), from * Math.cos(turn)), scale(unit(up), from * Math.sin(turn)));
    return { from: add(start, place), along: subtract(way, scale(place, 1 / lens.focus)) };
  }
});
