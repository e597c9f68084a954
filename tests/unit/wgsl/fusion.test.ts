// The decisive expressions of the intersection functions, under every freedom that WGSL leaves to a device: + − × rounded either
// way, products fused into sums. A software adapter shows one device of them all: it fuses nothing and rounds to the nearest.
import { describe, expect, test } from "vitest";
import type { Vec3 } from "../../../src/scene/schema";
import { halfEdgeDuals } from "../../../src/shapes/duals";
import { dualWithRim, inCommonOrder, withRim } from "../../../src/shapes/rims";
import { add, dot, scale, subtract } from "../../support/oracle";
import { createRandom, randomDirection } from "../../support/random";
import { CONSISTENT, everyFusion, randomChoices } from "../../support/wgsl/choices";
import { type Run, type Value, wgslFunctions } from "../../support/wgsl/evaluate";

const NONE = 0xffffffffn;
const ULP = 2 ** -23;
const BOX = wgslFunctions(["constants", "minMax", "ray", "shapes/box"]);
const PLANAR = wgslFunctions(["constants", "ray", "shapes/plane", "shapes/quad", "shapes/triangle"]);

// What boxes were until an H200 found rays that enter them where they start.
const OLD_BOX = wgslFunctions([
  "constants",
  "minMax",
  "ray",
  `fn boxIntersect(ray: Ray, center: vec3f, halfSize: vec3f, id: u32) -> f32 {
    let middle = (center - ray.o) * ray.inverse;
    let extent = halfSize * abs(ray.inverse);
    let enter = middle - extent;
    let leave = middle + extent;
    let near = greater(greater(enter.x, enter.y), enter.z);
    let far = lesser(lesser(leave.x, leave.y), leave.z);
    return select(-1.0, select(near, far, near <= 0.0), near <= far * 1.00000024);
  }`,
]);

type Box = { readonly center: Vec3; readonly halfSize: Vec3 };
type BoxRay = Box & { readonly o: Vec3; readonly d: Vec3 };

/** A ray that starts on the faces (one, two, three of them) of a box, all coordinates multiples of 2⁻⁸. */
function rayFromBox(random: () => number): BoxRay {
  const lattice = (span: number) => Math.round(256 * span * (2 * random() - 1)) / 256;
  const center: Vec3 = [lattice(2), lattice(2), lattice(2)];
  const halfSize: Vec3 = [0, 0, 0].map(() => (1 + Math.floor(255 * random())) / 256) as unknown as Vec3;
  const faces = 1 + Math.floor(3 * random());
  const first = Math.floor(3 * random());
  const o = [0, 1, 2].map((axis) => {
    const isOnFace = (axis - first + 3) % 3 < faces;
    return center[axis]! + (isOnFace ? Math.sign(random() - 0.5) * halfSize[axis]! : lattice(2));
  }) as unknown as Vec3;
  const d = randomDirection(random).map((x) => (random() < 0.05 ? 0 : Math.fround(x))) as unknown as Vec3;
  return { center, halfSize, o, d };
}

/** Distances at which a line enters and leaves a box, in doubles: exact differences on the lattice, divided once. */
function span({ center, halfSize, o, d }: BoxRay): { enter: number; leave: number } {
  let [enter, leave] = [Number.NEGATIVE_INFINITY, Number.POSITIVE_INFINITY];
  for (let axis = 0; axis < 3; axis++) {
    const slope = Math.abs(d[axis]!) < 1e-18 ? 1e-18 : d[axis]!; // as safeInverse has it
    const ends = [-1, 1].map((side) => (center[axis]! + side * halfSize[axis]! - o[axis]!) / slope);
    enter = Math.max(enter, Math.min(...ends));
    leave = Math.min(leave, Math.max(...ends));
  }
  return { enter, leave };
}

/** The distance that must be found, `undefined` where a ULP decides whether the box is met at all. */
function boxDistance(ray: BoxRay): number | undefined {
  const { enter, leave } = span(ray);
  if (Math.abs(enter - leave) <= 16 * ULP * Math.abs(leave)) return undefined;
  if (enter > leave || leave <= 0) return -1;
  return enter > 0 ? enter : leave;
}

/** A difference that is exact on the lattice, 1/d to 2.5 ULP or 3, and a product. */
const BOX_TOLERANCE = 5 * ULP;

function isRight(found: number, expected: number): boolean {
  if (expected <= 0) return found <= 0;
  return Math.abs(found - expected) <= BOX_TOLERANCE * expected;
}

/** Whether a box is met where the ray starts, before it is met. */
function isPhantom(found: number, expected: number): boolean {
  return found > 0 && found < 1e-5 && expected > 1e-4;
}

function meetBox(run: Run, { o, d, center, halfSize }: BoxRay): number {
  return run("boxIntersect", run("makeRay", o, d, NONE), center, halfSize, 0n) as number;
}

/** How many of `count` boxes a device meets where it should not. */
function wrongBoxes(
  run: Run,
  count: number,
  seed: number,
  isWrong = (found: number, expected: number) => !isRight(found, expected),
  meet = meetBox,
): number {
  const random = createRandom(seed);
  let wrong = 0;
  for (let i = 0; i < count; i++) {
    const ray = rayFromBox(random);
    const expected = boxDistance(ray);
    if (expected !== undefined && isWrong(meet(run, ray), expected)) wrong++;
  }
  return wrong;
}

describe("a box whose face the ray starts on is not entered there", () => {
  test.each(CONSISTENT)("$name, 10,000 rays from faces, edges and corners, seed 1", ({ choices }) => {
    expect(wrongBoxes(BOX(choices), 10_000, 1)).toBe(0);
  });

  test("every operation fused and rounded at random, 20,000 rays, seed 2", () => {
    expect(wrongBoxes(BOX(randomChoices(createRandom(3))), 20_000, 2)).toBe(0);
  });

  test("every combination of fused products, 200 rays, seed 4", () => {
    const random = createRandom(4);
    for (let i = 0; i < 200; i++) {
      const ray = rayFromBox(random);
      const expected = boxDistance(ray);
      if (expected === undefined) continue;
      let wrong = 0;
      everyFusion(BOX, (run) => {
        if (!isRight(meetBox(run, ray), expected)) wrong++;
      });
      expect(wrong).toBe(0);
    }
  });

  test("nor one that is turned by 0°, as the tree holds it, 10,000 rays, seed 8", () => {
    const meet: typeof meetBox = (run, { o, d, center, halfSize }) =>
      run("turnedBoxIntersect", run("makeRay", o, d, NONE), center, halfSize, [1, 0], 0n) as number;
    expect(wrongBoxes(BOX(randomChoices(createRandom(9))), 10_000, 8, undefined, meet)).toBe(0);
  });

  test("as an H200 has met one at 7.5e-9", () => {
    const ray: BoxRay = {
      o: [-1.71875, -0.75390625, 0.60546875],
      d: [0.88974744, 0.4405258, -0.11952592].map(Math.fround) as unknown as Vec3,
      center: [-1, -0.9921875, 0.85546875],
      halfSize: [1.4375 / 2, 0.9921875 / 2, 1.3359375 / 2],
    };
    const old = CONSISTENT.map(({ choices }) => meetBox(OLD_BOX(choices), ray));
    expect(old.filter((t) => t > 0 && t < 1e-7).length).toBeGreaterThan(0);
    for (const { choices } of CONSISTENT) expect(meetBox(BOX(choices), ray)).toBeCloseTo(0.585238, 5);
  });

  test("which the difference of two products does not hold to, once one is fused, seed 1", () => {
    const phantoms = CONSISTENT.map(({ choices }) => wrongBoxes(OLD_BOX(choices), 10_000, 1, isPhantom));
    const [software, fusesFirst, fusesLast] = phantoms;
    expect(software).toBe(0);
    expect(Math.min(fusesFirst!, fusesLast!)).toBeGreaterThan(100);
  });
});

test("a box's normal is that of a face that the ray enters or leaves by, from its faces, edges and corners, seed 5", () => {
  const random = createRandom(5);
  const run = BOX(randomChoices(createRandom(6)));
  let [met, wrong] = [0, 0];
  for (let i = 0; i < 20_000; i++) {
    const ray = rayFromBox(random);
    const { o, d, center, halfSize } = ray;
    const expected = boxDistance(ray);
    if (expected === undefined || expected <= 0) continue;
    met++;
    const point = add(o, scale(d, expected)).map(Math.fround) as unknown as Vec3;
    const wgslRay = run("makeRay", o, d, NONE);
    const n = run("boxNormal", wgslRay, point, center, halfSize, [1, 0], 0n) as Vec3;
    const isLeaving = span(ray).enter <= 0;
    const isOnFace = Math.abs(Math.abs(dot(subtract(point, center), n)) - Math.abs(dot(halfSize, n))) < 1e-5;
    if (dot(n, d) > 0 !== isLeaving || !isOnFace) wrong++;
  }
  expect(met).toBeGreaterThan(1_500);
  expect(wrong).toBe(0);
});

describe("rays at the edges and vertices of a fan of triangles on a lattice meet one of them", () => {
  test.each(CONSISTENT)("$name, seed 7", ({ choices }) => {
    const random = createRandom(7);
    const run = PLANAR(choices);
    const lattice = () => Math.round(256 * (2 * random() - 1)) / 256;
    let missed = 0;
    for (let i = 0; i < 2_000; i++) {
      const hub: Vec3 = [lattice() / 4, lattice() / 4, lattice() / 4];
      const rim = RIM_POINTS.map(([x, y]): Vec3 => [x + lattice() / 4, y + lattice() / 4, lattice()]);
      const [a] = rim as [Vec3];
      const along = [0, 1, Math.round(16 * random()) / 16, random()][i % 4]!;
      // Half way out at most: beyond a rim point there is nothing.
      const aim = add(hub, scale(subtract(a, hub), along / 2));
      const o: Vec3 = [lattice() / 8, lattice() / 8, 8];
      const d = unitF32(subtract(aim, o));
      const shear = run("shearOf", run("makeRay", o, d, NONE));
      const isMet = rim.some((point, k) => {
        const corners = inCommonOrder([hub, point, rim[(k + 1) % rim.length]!]);
        return (run("triangleIntersect", shear, ...corners) as number) > 0;
      });
      if (!isMet) missed++;
    }
    expect(missed).toBe(0);
  });
});

const RIM_POINTS = [
  [1, 0],
  [0.5, 1],
  [-0.5, 1],
  [-1, 0],
  [-0.5, -1],
  [0.5, -1],
] as const;

test("the film's sum keeps what it is given, seed 12", () => {
  const random = createRandom(12);
  const devices = [...CONSISTENT.map(({ choices }) => choices), randomChoices(createRandom(13))];
  const calls = 3_000;
  for (const run of devices.map(wgslFunctions(["film"]))) {
    let pixel: Value = { sum: [0, 0, 0, 0], carry: [0n, 0n] };
    let exact = 0;
    for (let i = 0; i < calls; i++) {
      const x = Math.fround(10 ** (2 * random() - 1));
      exact += x;
      pixel = run("filmAdd", pixel, [x, x, x, 1]);
    }
    const { sum } = pixel as unknown as { sum: readonly number[] };
    // A sample may round by an ULP where it meets what was carried, always the same way, and the carry holds 4 ULP of the sum.
    const bound = ULP + calls * 2 ** -15 * ULP + 4 * ULP;
    for (const channel of sum.slice(0, 3)) expect(Math.abs(channel / exact - 1)).toBeLessThan(bound);
    expect(sum[3]).toBe(calls);
  }
});

test("rays between two rectangles with a common edge meet one of them, level and turned, seed 10", () => {
  const random = createRandom(10);
  const run = PLANAR(randomChoices(createRandom(11)));
  let missed = 0;
  for (let i = 0; i < 10_000; i++) {
    const at: Vec3 = [8 * random() - 4, 8 * random() - 4, 8 * random() - 4];
    const [left, right, up] = [0.1 + random(), 0.1 + random(), 0.1 + random()];
    const slope = i % 2 === 0 ? 0 : random() - 0.5;
    // Both stand on the z-axis through `at`; the second is bent back by the slope.
    const meet = (ray: Value, width: number, tilt: number) => {
      const edge1: Vec3 = [width, tilt * width, 0];
      const middle = add(at, scale(add(edge1, [0, 0, up]), 0.5));
      if (tilt === 0)
        return run("quadIntersectY", ray, middle, withRim([width / 2, 0, up / 2], middle).map(Math.fround));
      const normal = scale([-tilt, 1, 0], 1 / Math.hypot(tilt, 1));
      const duals = halfEdgeDuals(edge1, [0, 0, up], normal).map((dual) => dualWithRim(dual, middle));
      const reach = Math.max(...duals.map((dual) => Math.hypot(...dual)));
      return run("quadIntersect", ray, ...[middle, normal, ...duals].map(f32), Math.fround(reach));
    };
    const aim = add(at, [0, 0, up * random()]);
    const o = f32(add(aim, scale(randomDirection(random), 10 ** (3 * random() - 1))));
    if (Math.abs(o[1] - aim[1]) < 0.1 * Math.hypot(...subtract(o, aim))) continue; // along both
    const ray = run("makeRay", o, unitF32(subtract(aim, o)), NONE);
    const found = [meet(ray, left, 0), meet(ray, -right, slope)] as number[];
    if (!found.some((t) => t > 0)) missed++;
  }
  expect(missed).toBe(0);
});

function f32(v: Vec3): Vec3 {
  return v.map(Math.fround) as unknown as Vec3;
}

function unitF32(v: Vec3): Vec3 {
  return f32(scale(v, 1 / Math.hypot(...v)));
}
