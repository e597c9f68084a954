import { afterAll, describe, expect, test } from "vitest";
import type { Scene, Vec3 } from "../../../src/scene/schema";
import { sceneOf } from "../../support/compiled";
import { add, dot, scale, subtract } from "../../support/oracle";
import { createRandom, randomDirection } from "../../support/random";
import { unit } from "../../support/solids";
import { count, LONG, small } from "../../support/stability";
import { recordStability, type StabilityRow } from "../../support/stabilityRows";
import { type Method, NONE, Rays, traceRays } from "../../support/traceRays";

const RAYS = 50_000 * LONG;

type Case = {
  readonly name: string;
  readonly radius: number;
  /** Relative to what the camera looks at. */
  readonly center: Vec3;
  readonly camera: Vec3;
  /** Where rays start, and the point they are aimed at. */
  readonly ray: (random: () => number) => readonly [Vec3, Vec3];
  /** Allowed distance of a hit from the true surface, in units of the scene. */
  readonly bound: number;
  readonly why: string;
};

// Rounding of a coordinate, relative: half a ULP, or a whole one where a device rounds either way.
const ULP = 2 ** -23;
const disc = (random: () => number, radius: number): Vec3 => scale(randomDirection(random), radius * random());

const CASES: readonly Case[] = [
  {
    name: "A sphere of radius 250 seen from 5400",
    radius: 250,
    center: [0, 0, 0],
    camera: [0, 0, 5400],
    ray: (random) => [scale(randomDirection(random), 5400), disc(random, 250)],
    bound: 8 * ULP * 5400,
    why: "8 ULP of the way to it",
  },
  {
    name: "Unit spheres seen from 10⁴",
    radius: 1,
    center: [0.25, -0.5, 0.125],
    camera: [0, 0, 1e4],
    ray: (random) => [scale(randomDirection(random), 1e4), disc(random, 1)],
    bound: 8 * ULP * 1e4,
    why: "8 ULP of the way to it",
  },
  {
    name: "A sphere of radius 10⁵ as a floor, seen from up to 10 away",
    radius: 1e5,
    center: [0, -1e5, 0],
    camera: [0, 2, 8],
    ray: (random) => {
      const o = add([0, 0.01, 0], scale(randomDirection(random), 9 * random()));
      return [
        [o[0], Math.abs(o[1]), o[2]],
        [20 * random() - 10, -1e-3, 20 * random() - 10],
      ];
    },
    bound: 16 * ULP * 20,
    why: "16 ULP of the way to it",
  },
  {
    name: "A planet of radius 6.4·10⁶ as a floor, seen from up to 10 away",
    radius: 6.4e6,
    center: [0, -6.4e6, 0],
    camera: [0, 2, 8],
    ray: (random) => {
      const o = add([0, 0.01, 0], scale(randomDirection(random), 9 * random()));
      return [
        [o[0], Math.abs(o[1]), o[2]],
        [20 * random() - 10, -1e-3, 20 * random() - 10],
      ];
    },
    bound: 16 * ULP * 20,
    why: "16 ULP of the way to it",
  },
  {
    name: "From inside a sphere, also close to its surface",
    radius: 2,
    center: [0.25, 0.5, -0.125],
    camera: [0, 0, 1],
    ray: (random) => {
      const o = add([0.25, 0.5, -0.125], scale(randomDirection(random), 2 * (1 - 10 ** (-5 * random()))));
      return [o, add(o, randomDirection(random))];
    },
    bound: 16 * ULP * 4,
    why: "16 ULP of its diameter",
  },
];
const rows: StabilityRow[] = [];

describe.each(CASES)("$name", ({ name, radius, center, camera, ray, bound, why }) => {
  test(`is hit where it is in doubles, to ${why}, seed 4`, async () => {
    const target: Vec3 = [12, -7, 3];
    const scene: Scene = {
      ...sceneOf([{ type: "sphere", center: add(target, center), radius, material: "lambert" }]),
      camera: { position: add(target, camera), target },
    };
    const random = createRandom(4);
    const rays = new Rays(RAYS);
    for (let i = 0; i < RAYS; i++) {
      const [o, aim] = ray(random);
      rays.set(i, o, unit(subtract(aim, o)));
    }
    const worst = async (method: Method) => {
      const { id, t } = await traceRays(scene, rays, method);
      let [error, wrong] = [0, 0];
      for (let i = 0; i < RAYS; i++) {
        const [o, d] = [rays.origin(i), rays.direction(i)];
        const expected = nearest(o, d, center, radius);
        if (id[i] === NONE || expected === undefined) {
          // A miss must be one in doubles too, up to the bound.
          if ((id[i] === NONE) !== (expected === undefined)) {
            const gap = Math.abs(clearance(o, d, center, radius));
            error = Math.max(error, gap);
            if (gap > bound) wrong++;
          }
          continue;
        }
        // How far the hit lies off the surface, or the near side from the far one.
        const off = distanceTo(add(o, scale(d, t[i]!)), center, radius);
        const other = Math.abs(t[i]! - expected) > 0.1 * radius && clearance(o, d, center, radius) < -bound;
        error = Math.max(error, Math.abs(off));
        if (Math.abs(off) > bound || other) wrong++;
      }
      return { error, wrong };
    };
    const ours = await worst("ours");
    const textbook = await worst("textbook");
    rows.push({
      case: name,
      asserted: `hits lie within ${small(bound)} of the surface (${why}), misses pass it within that`,
      inputs: RAYS,
      worst: small(ours.error),
      textbook: `${small(textbook.error)}: quadratic formula`,
    });
    expect(ours).toMatchObject({ wrong: 0 });
  });
});

test("a ray between two nested spheres of radii 1 and 1 + 4·10⁻⁵ stays there, seed 5", async () => {
  const center: Vec3 = [0.1, -0.2, 0.3];
  const outer = 1 + 4e-5;
  const scene = sceneOf([
    { type: "sphere", center, radius: 1, material: "lambert" },
    { type: "sphere", center, radius: outer, material: "lambert" },
  ]);
  const random = createRandom(5);
  const rays = new Rays(4 * RAYS);
  for (let i = 0; i < rays.count; i++) {
    const o = add(center, scale(randomDirection(random), 1 + 4e-5 * (0.25 + 0.5 * random())));
    const z = Math.sqrt(random());
    const phi = 2 * Math.PI * random();
    const r = Math.sqrt(1 - z * z);
    rays.set(i, o, randomDirection(random), [r * Math.cos(phi), r * Math.sin(phi), z]);
  }
  const wrong = async (method: Method) => {
    const { id, nextId, p, nextDirection } = await traceRays(scene, rays, method);
    let lost = 0;
    for (let i = 0; i < rays.count; i++) {
      if (id[i] === NONE || nextId[i] === NONE) lost++;
      else if (id[i] === 0 && nextId[i] === 0) lost++;
      else if (id[i] === 1) {
        // From the outer sphere a ray meets the inner one if it points there, with room for some sixteen operations, and else
        // the outer.
        const gap = clearance(p(i), nextDirection(i), center, 1);
        if (Math.abs(gap) > 16 * ULP && nextId[i] !== (gap < 0 ? 0 : 1)) lost++;
      }
    }
    return lost;
  };
  const ours = await wrong("ours");
  rows.push({
    case: "Paths between nested spheres of radii 1 and 1 + 4·10⁻⁵",
    asserted: "none gets out or meets the wrong sphere",
    inputs: rays.count,
    worst: `${count(ours)} do`,
    textbook: `${count(await wrong("textbook"))} do: quadratic formula, t > 10⁻⁴`,
  });
  expect(ours).toBe(0);
});

afterAll(() => recordStability("spheres", rows));

/** Distance along a ray to the nearest meeting in front of it, in doubles. */
function nearest(o: Vec3, d: Vec3, center: Vec3, radius: number): number | undefined {
  const f = subtract(o, center);
  const a = dot(d, d);
  const b = dot(f, d) / a;
  const chord = subtract(f, scale(d, b));
  const inside = radius ** 2 - dot(chord, chord);
  if (inside < 0) return undefined;
  const half = Math.sqrt(inside / a);
  // Their product is exact where one of them is small.
  const c = (Math.hypot(...f) - radius) * (Math.hypot(...f) + radius);
  const far = -b + Math.sign(-b) * half;
  const roots = [far, c / a / far].filter((t) => t > 0);
  return roots.length > 0 ? Math.min(...roots) : undefined;
}

/** How far outside of the sphere a ray passes; negative if it meets it. */
function clearance(o: Vec3, d: Vec3, center: Vec3, radius: number): number {
  const f = subtract(o, center);
  const b = Math.min(dot(f, d) / dot(d, d), 0);
  return Math.hypot(...subtract(f, scale(d, b))) - radius;
}

function distanceTo(p: Vec3, center: Vec3, radius: number): number {
  return Math.hypot(...subtract(p, center)) - radius;
}
