import { describe, expect, test } from "vitest";
import { buildBvh } from "../../../src/bvh/buildBvh";
import type { Bvh } from "../../../src/bvh/bvh";
import { anyHit, closestHit, type Intersect, type Ray } from "../../../src/bvh/traverse";
import { boxSoup } from "../../support/bvh";
import { createRandom } from "../../support/random";

/** Entry into a primitive's own box, faces included: a primitive that rays along slabs and planes do hit. */
function boxIntersect(bounds: Float32Array, { origin, direction }: Ray): Intersect {
  return (primitive, tMin, tMax) => {
    let near = tMin;
    let far = tMax;
    for (let axis = 0; axis < 3; axis++) {
      const low = bounds[6 * primitive + axis]! - origin[axis]!;
      const high = bounds[6 * primitive + 3 + axis]! - origin[axis]!;
      const d = direction[axis]!;
      if (d === 0) {
        if (low > 0 || high < 0) return Number.POSITIVE_INFINITY;
      } else {
        near = Math.max(near, Math.min(low / d, high / d));
        far = Math.min(far, Math.max(low / d, high / d));
      }
    }
    return near <= far ? near : Number.POSITIVE_INFINITY;
  };
}

function bruteForce(bvh: Bvh, intersect: Intersect, tMin: number, tMax: number): number {
  return Math.min(...Array.from(bvh.order, (primitive) => intersect(primitive, tMin, tMax)));
}

// Divided by the direction or multiplied by its inverse: each is three roundings off, at most.
const ROUNDING = 8 * 2 ** -53;

function expectSameAsBruteForce(bvh: Bvh, bounds: Float32Array, ray: Ray, tMin: number, tMax: number): number {
  const intersect = boxIntersect(bounds, ray);
  const expected = bruteForce(bvh, intersect, tMin, tMax);
  const hit = closestHit(bvh, ray, intersect, tMin, tMax);
  const label = JSON.stringify({ ...ray, tMin, tMax: String(tMax) });
  expect(anyHit(bvh, ray, intersect, tMin, tMax), label).toBe(expected < Number.POSITIVE_INFINITY);
  if (expected === Number.POSITIVE_INFINITY) expect(hit, label).toBeUndefined();
  else {
    expect(Math.abs(hit!.t - expected), label).toBeLessThanOrEqual(ROUNDING * Math.abs(expected));
    expect(intersect(hit!.primitive, tMin, tMax), label).toBe(hit!.t);
  }
  return expected < Number.POSITIVE_INFINITY ? 1 : 0;
}

describe("closest and any hit equal brute force", () => {
  test.each([1, 2, 3, 4, 5])("on boxes at random, seed %i", (seed) => {
    const random = createRandom(seed);
    const bounds = boxSoup(random, 300, 0.1);
    const bvh = buildBvh(bounds, { maxLeaf: seed });
    let hits = 0;
    for (let i = 0; i < 300; i++) {
      const origin = [3 * random() - 1, 3 * random() - 1, 3 * random() - 1] as const;
      const direction = [random() - origin[0], random() - origin[1], random() - origin[2]] as const;
      const tMin = i % 3 === 0 ? random() : 0; // 1 is at a point among the boxes
      const tMax = i % 2 === 0 ? tMin + 2 * random() : Number.POSITIVE_INFINITY;
      hits += expectSameAsBruteForce(bvh, bounds, { origin, direction }, tMin, tMax);
    }
    expect(hits).toBeGreaterThan(50);
    expect(hits).toBeLessThan(290);
  });

  test("of rays with zero components, from, along and off the planes of boxes on a grid, seed 6", () => {
    const random = createRandom(6);
    const whole = (below: number) => Math.trunc(random() * below);
    const cells = Array.from({ length: 120 }, () => {
      const low = [whole(6), whole(6), whole(6)];
      // Some are flat, some are lines and points.
      return [...low, ...low.map((value) => value + whole(2))];
    });
    const bounds = Float32Array.from(cells.flat());
    const bvh = buildBvh(bounds, { maxLeaf: 1 });
    const components = [-1, -0, 0, 1];
    let hits = 0;
    let rays = 0;
    for (let i = 0; i < 4000; i++) {
      const direction = [components[whole(4)]!, components[whole(4)]!, components[whole(4)]!] as const;
      if (direction.every((component) => component === 0)) continue;
      const coordinate = () => (random() < 0.7 ? whole(9) - 1 : 9 * random() - 1);
      const origin = [coordinate(), coordinate(), coordinate()] as const;
      hits += expectSameAsBruteForce(bvh, bounds, { origin, direction }, 0, Number.POSITIVE_INFINITY);
      rays += 1;
    }
    expect(hits).toBeGreaterThan(rays / 10);
    expect(hits).toBeLessThan(rays);
  });

  test("in an empty tree there is nothing", () => {
    const bvh = buildBvh(new Float32Array(0));
    const ray: Ray = { origin: [0, 0, 0], direction: [0, 0, 1] };
    expect(closestHit(bvh, ray, () => 1)).toBeUndefined();
    expect(anyHit(bvh, ray, () => 1)).toBe(false);
  });
});

test("of a thousand boxes in a row a ray meets few, the nearest first", () => {
  const bounds = Float32Array.from({ length: 6000 }, (_, i) =>
    i % 3 === 0 ? Math.trunc(i / 6) + (i % 6) / 6 : i % 6 < 3 ? 0 : 1,
  );
  const bvh = buildBvh(bounds);
  for (const sign of [1, -1]) {
    const ray: Ray = { origin: [sign > 0 ? -5 : 1005, 0.5, 0.5], direction: [sign, 0, 0] };
    const visited: number[] = [];
    const intersect = boxIntersect(bounds, ray);
    const hit = closestHit(bvh, ray, (primitive, tMin, tMax) => {
      visited.push(primitive);
      return intersect(primitive, tMin, tMax);
    });
    expect(hit!.primitive).toBe(sign > 0 ? 0 : 999);
    expect(visited.length).toBeLessThanOrEqual(4);
  }
});
