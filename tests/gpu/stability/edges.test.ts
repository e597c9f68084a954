import { afterAll, describe, expect, test } from "vitest";
import type { Vec3 } from "../../../src/scene/schema";
import { sceneOf } from "../../support/compiled";
import { add, dot, scale, subtract } from "../../support/oracle";
import { createRandom, randomDirection } from "../../support/random";
import { corner, pieces, type Solid, solid, unit } from "../../support/solids";
import { count, LONG } from "../../support/stability";
import { recordStability } from "../../support/stabilityRows";
import { type Method, NONE, Rays, tally, traceRays } from "../../support/traceRays";

test("the ray through the diagonal of the unit quad hits one of its two triangles", async () => {
  const [a, b, c, d]: Vec3[] = [
    [0, 0, 0],
    [1, 0, 0],
    [1, 1, 0],
    [0, 1, 0],
  ];
  // Seen from (0, 0, 10) the ray meets z = 0 at x = y, up to rounding.
  const rays = new Rays(1);
  rays.set(0, [0, 0, 10], [0.30458447, 0.30458447, -0.9024725]);
  const big = (v: Vec3): Vec3 => scale(v, 8);
  const scene = sceneOf([
    { type: "triangle", vertices: [big(a!), big(b!), big(c!)], material: "lambert" },
    { type: "triangle", vertices: [big(a!), big(c!), big(d!)], material: "lambert" },
  ]);
  const { id, t } = await traceRays(scene, rays);
  expect(id[0]).not.toBe(NONE);
  expect(t[0]).toBeCloseTo(10 / 0.9024725, 5);
});

// Rays per kind, place and side; in all, a million through edges and vertices.
const RAYS = 62_500 * LONG;
const PLACES: readonly Vec3[] = [
  [0, 0, 0],
  [1e5, -7e4, 1e5 / 3],
];
const leaks = PLACES.map((): Record<Method, number> => ({ ours: 0, textbook: 0 }));

describe.each([
  ["triangles", "level"],
  ["triangles", "turned"],
  ["quads", "level"],
  ["quads", "turned"],
] as const)("a closed box of %s, %s, seed 1", (kind, stance) => {
  describe.each(PLACES.map((place, index) => ({ place, index })))("at $place", ({ place, index }) => {
    test.each(["outside", "inside"] as const)(
      "lets no ray in or out through an edge or a vertex, from %s",
      async (side) => {
        // Near its place by parts of a metre that are no multiple of anything.
        const offset: Vec3 = [0.1, 0.2, -0.3];
        const box = solid(add(place, offset), stance === "turned");
        const { rays, aims } = raysAtEdges(solid(offset, stance === "turned"), side, RAYS, 1);
        const leak = async (method: Method) => {
          // The textbook takes coordinates as they are written; ours, relative to what the camera looks at.
          const target: Vec3 = method === "ours" ? place : [0, 0, 0];
          const scene = { ...sceneOf(pieces(box, kind)), camera: { position: add(target, [0, 1, 5]), target } };
          const { id, t } = await traceRays(scene, method === "ours" ? rays : moved(rays, place), method);
          // Past the edge by a hundredth: through the wall.
          return tally(rays.count, (i) => id[i] === NONE || t[i]! > aims[i]! + 0.01);
        };
        const ours = await leak("ours");
        leaks[index]!.ours += ours;
        leaks[index]!.textbook += await leak("textbook");
        expect(ours).toBe(0);
      },
    );
  });
});

afterAll(() => {
  const solids = "closed boxes of 12 triangles and of 6 quads, level and turned, from outside and inside";
  recordStability(
    "edges",
    ["at the origin", "10⁵ from the origin"].map((where, index) => ({
      case: `Rays through shared edges and vertices of ${solids}, ${where}`,
      asserted: "0 leaks",
      inputs: 8 * RAYS,
      worst: `${count(leaks[index]!.ours)} leaks`,
      textbook: `${count(leaks[index]!.textbook)} leaks: Möller–Trumbore, quads by |u|, |v| ≤ 1, world coordinates in f32`,
    })),
  );
});

// At this much grazing, from up to 33 away, a distance is known to some 16 ULP of 33/cos, 0.06.
const LEAST_COSINE = 1e-3;
// Aims along an edge keep this away from its ends, as a share of its half length: the face beyond the end may be turned away,
// and past that end, which lies on the outline then, a ray within rounding (4 ULP of 33) may truly miss.
const END = 1e-3;

/** Rays at points of edges and vertices all of whose faces are turned to the ray, and the distances to those points. */
function raysAtEdges(box: Solid, side: "outside" | "inside", total: number, seed: number) {
  const random = createRandom(seed);
  const rays = new Rays(total);
  const aims = new Float64Array(total);
  const normals = box.half.map(unit);
  for (let i = 0; i < total; ) {
    // One or two coordinates of the cube at ±1; every fourth aim is a vertex.
    const sides = [0, 1, 2].map((): number => (random() < 0.5 ? -1 : 1));
    const free = random() < 0.75 ? Math.floor(3 * random()) : -1;
    if (free >= 0) sides[free] = random() < 0.25 ? 0 : (1 - END) * (2 * random() - 1);
    const aim = corner(box, sides);
    const from =
      side === "inside"
        ? corner(box, [1.8 * random() - 0.9, 1.8 * random() - 0.9, 1.8 * random() - 0.9])
        : add(box.middle, scale(randomDirection(random), 2.5 + 30 * random() ** 2));
    const o = from.map(Math.fround) as unknown as Vec3;
    const d = unit(subtract(aim, o));
    const facing = normals.every(
      (n, axis) => axis === free || (side === "inside" ? 1 : -1) * sides[axis]! * dot(n, d) > LEAST_COSINE,
    );
    if (!facing) continue;
    rays.set(i, o, d);
    aims[i] = Math.hypot(...subtract(aim, o));
    i++;
  }
  return { rays, aims };
}

function moved(rays: Rays, by: Vec3): Rays {
  const result = new Rays(rays.count);
  for (let i = 0; i < rays.count; i++) result.set(i, add(rays.origin(i), by), rays.direction(i));
  return result;
}
