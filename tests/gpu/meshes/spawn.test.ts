import { afterAll, describe, expect, test } from "vitest";
import type { Scene, Vec3 } from "../../../src/scene/schema";
import { bumpySphere, icosphere, meshObject, placed } from "../../support/meshes";
import { add, scale, subtract } from "../../support/oracle";
import { createRandom, randomDirection, scatteredDirection } from "../../support/random";
import { unit } from "../../support/solids";
import { count, LONG } from "../../support/stability";
import { recordStability } from "../../support/stabilityRows";
import { NONE, Rays, tally, traceRays } from "../../support/traceRays";

// Rays per mesh and place: a million and more per place.
const RAYS = 550_000 * LONG;
const MIDDLE: Vec3 = [0.1, 0.2, -0.3];

const MESHES = {
  // Twice as large, for radius 1.
  "a bumpy mesh of 1,000 triangles": { data: placed(bumpySphere(1000), 2, [0, 0, 0]), isConvex: false },
  "a convex mesh of 320 triangles": { data: icosphere(2), isConvex: true },
};
const PLACES = [
  { where: "of radius 1 at the origin", size: 1, place: [0, 0, 0] },
  { where: "of radius 1000 at 10⁵ from the origin", size: 1e3, place: [1e5, -7e4, 1e5 / 3] },
] as const satisfies readonly { where: string; size: number; place: Vec3 }[];

type Failures = { hits: number; selfHits: number; escapes: number };
const failures = new Map(
  PLACES.map(({ where }) => [where as string, { hits: 0, selfHits: 0, escapes: 0 } as Failures]),
);

describe.each(PLACES)("$where", ({ where, size, place }) => {
  test.each(Object.keys(MESHES) as (keyof typeof MESHES)[])(
    "no ray that leaves %s meets what it leaves or slips through it, seed 22",
    async (name) => {
      const { data, isConvex } = MESHES[name];
      const middle = add(place, scale(MIDDLE, size));
      const scene: Scene = {
        camera: { position: [0, 1, 5], target: [0, 0, 0] },
        materials: { lambert: { ior: 1 } },
        objects: [meshObject(placed(data, size, middle), "lambert")],
      };
      const { rays, isInside } = raysAround(middle, size);
      const { id, nextId } = await traceRays(scene, rays);
      const isHit = (i: number) => id[i] !== NONE;
      // A ray that leaves the outside of a convex mesh meets nothing; one that leaves the inside of a closed mesh meets it.
      const counts = {
        hits: tally(RAYS, isHit),
        selfHits: tally(RAYS, (i) => isHit(i) && (isConvex && !isInside[i] ? nextId[i] !== NONE : nextId[i] === id[i])),
        escapes: tally(RAYS, (i) => isHit(i) && isInside[i] === 1 && nextId[i] === NONE),
      };
      const sum = failures.get(where)!;
      for (const key of ["hits", "selfHits", "escapes"] as const) sum[key] += counts[key];
      expect(counts).toMatchObject({ selfHits: 0, escapes: 0 });
      // The case is really tried, on both sides.
      expect(counts.hits).toBeGreaterThan(0.9 * RAYS);
    },
  );
});

afterAll(() =>
  recordStability(
    "mesh-spawn",
    PLACES.map(({ where }) => {
      const { hits, selfHits, escapes } = failures.get(where)!;
      return {
        case: `Rays that leave a bumpy mesh of 1,000 triangles and a convex one of 320, ${where}, outside and inside, a tenth of them grazing`,
        asserted: "0 self-hits; outside the convex mesh none meets it, inside a closed mesh each meets it again",
        inputs: hits,
        worst: `${count(selfHits)} self-hits, ${count(escapes)} lost through the surface`,
      };
    }),
  ),
);

/** Rays from in and outside of a mesh around `middle` at points within it. */
function raysAround(middle: Vec3, size: number) {
  const random = createRandom(22);
  const rays = new Rays(RAYS);
  const isInside = new Uint8Array(RAYS);
  for (let i = 0; i < RAYS; i++) {
    isInside[i] = random() < 0.5 ? 1 : 0;
    const o = add(middle, scale(randomDirection(random), size * (isInside[i] ? 0.5 * random() : 1.2 + 2 * random())));
    const aim = add(middle, scale(randomDirection(random), size * 0.85 * random()));
    rays.set(i, o, unit(subtract(aim, o)), scatteredDirection(random));
  }
  return { rays, isInside };
}
