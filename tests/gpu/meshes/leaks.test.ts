import { afterAll, describe, expect, test } from "vitest";
import type { Scene, Vec3 } from "../../../src/scene/schema";
import { bumpySphere, type MeshData, meshObject, placed, triangleAt } from "../../support/meshes";
import { add, cross, dot, scale, subtract } from "../../support/oracle";
import { createRandom, randomDirection, scatteredDirection } from "../../support/random";
import { unit } from "../../support/solids";
import { count, LONG } from "../../support/stability";
import { recordStability } from "../../support/stabilityRows";
import { NONE, Rays, tally, traceRays } from "../../support/traceRays";

// Rays per place and side: a million and more per place.
const RAYS = 500_000 * LONG;
const FAR: Vec3 = [1e5, -7e4, 1e5 / 3];

// The mesh is 20 across: 10⁵ away its vertices lie on a lattice of 2⁻⁷, a sixtieth of an edge. A point of a triangle is then no
// better known, and the clearance that this takes may put one next to an edge beyond the next triangle.
const SIZE = 20;
const PLACES = [
  { where: "at the origin", place: [0, 0, 0], target: [0, 0, 0], mayEscape: 0 },
  { where: "10⁵ from what the camera looks at", place: FAR, target: [0, 0, 0], mayEscape: 1e-3 },
] as const satisfies readonly { where: string; place: Vec3; target: Vec3; mayEscape: number }[];
const leaks = new Map<string, number>();
const escapes = new Map<string, number>();

describe.each(PLACES)("a closed mesh $where, seed 21", ({ where, place, target, mayEscape }) => {
  test.each(["outside", "inside"] as const)(
    "lets no ray in or out through an edge or a vertex, from %s",
    async (side) => {
      const mesh = placed(bumpySphere(1000), SIZE, add(place, [0.1, 0.2, -0.3]));
      const { rays, aims } = raysAtEdges(mesh, add(place, [0.1, 0.2, -0.3]), target, side);
      const scene: Scene = {
        camera: { position: add(target, [0, 1, 5]), target },
        materials: { lambert: { ior: 1 } },
        objects: [meshObject(mesh, "lambert")],
      };
      const { id, t, nextId } = await traceRays(scene, rays);
      // Past the edge by a hundredth of the mesh: through the wall.
      const leak = tally(RAYS, (i) => id[i] === NONE || t[i]! > aims[i]! + 0.01 * SIZE);
      leaks.set(where, (leaks.get(where) ?? 0) + leak);
      expect(leak).toBe(0);
      if (side === "outside") return;
      const lost = tally(RAYS, (i) => id[i] !== NONE && nextId[i] === NONE);
      escapes.set(where, lost);
      expect(lost).toBeLessThanOrEqual(mayEscape * RAYS);
    },
  );
});

afterAll(() =>
  recordStability(
    "mesh-leaks",
    PLACES.flatMap(({ where, mayEscape }) => [
      {
        case: `Rays through shared edges and vertices of a closed mesh of 1,000 triangles 20 across, ${where}, from outside and inside`,
        asserted: "0 leaks",
        inputs: 2 * RAYS,
        worst: `${count(leaks.get(where) ?? 0)} leaks`,
      },
      {
        case: `Rays that scatter inside that mesh, at its edges and vertices, ${where}`,
        asserted: mayEscape === 0 ? "none gets out" : `at most ${mayEscape} of them get out: vertices are known to 2⁻⁷`,
        inputs: RAYS,
        worst: `${count(escapes.get(where) ?? 0)} get out`,
      },
    ]),
  ),
);

// An edge of which a face is seen under less than this cosine may be the outline for a ray that is off by rounding.
const LEAST_COSINE = 0.01;

// How far from its ends rays meet an edge, as a share of it: some thirty times what they are off by rounding. A vertex there may be
// part of the outline, which a ray that is off by rounding passes.
const END = 1e-4;

/** Rays at points of edges and vertices all of whose triangles are turned to the ray, and the distances to those points. */
function raysAtEdges(mesh: MeshData, middle: Vec3, target: Vec3, side: "outside" | "inside") {
  const triangles = Array.from({ length: mesh.indices.length / 3 }, (_, i) =>
    // As the device has them: relative to the target, in f32.
    triangleAt(mesh, i).map((vertex) => subtract(vertex, target).map(Math.fround) as unknown as Vec3),
  ) as [Vec3, Vec3, Vec3][];
  const normals = triangles.map(([a, b, c]) => unit(cross(subtract(b, a), subtract(c, a))));
  const around = (vertices: readonly number[]) =>
    triangles.flatMap((_, i) => (vertices.every((v) => mesh.indices.slice(3 * i, 3 * i + 3).includes(v)) ? [i] : []));
  const neighbours = new Map<string, number[]>();
  const facesAround = (vertices: readonly number[]) => {
    const key = vertices.toSorted((v, w) => v - w).join();
    if (!neighbours.has(key)) neighbours.set(key, around(vertices));
    return neighbours.get(key)!;
  };

  const random = createRandom(21);
  const rays = new Rays(RAYS);
  const aims = new Float64Array(RAYS);
  for (let i = 0; i < RAYS; ) {
    const triangle = Math.floor(triangles.length * random());
    const [first, second] = [Math.floor(3 * random()), Math.floor(3 * random())];
    const [a, b] = [triangles[triangle]![first]!, triangles[triangle]![second]!];
    const aim = add(a, scale(subtract(b, a), END + (1 - 2 * END) * random()));
    const faces = facesAround([...new Set([first, second])].map((corner) => mesh.indices[3 * triangle + corner]!));
    // Anything within 0.2 of the middle is inside; what is beyond 0.55 of it, outside.
    const reach = SIZE * (side === "inside" ? 0.2 * random() : 0.6 + 2 * random());
    const o = add(subtract(middle, target), scale(randomDirection(random), reach)).map(Math.fround) as unknown as Vec3;
    const d = unit(subtract(aim, o));
    const facing = faces.every((face) => (side === "inside" ? 1 : -1) * dot(normals[face]!, d) > LEAST_COSINE);
    if (!facing) continue;
    rays.set(i, o, d, scatteredDirection(random));
    aims[i] = Math.hypot(...subtract(aim, o));
    i++;
  }
  return { rays, aims };
}
