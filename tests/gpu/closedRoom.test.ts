import { describe, expect, test } from "vitest";
import type { Scene, SceneObject, Vec3 } from "../../src/scene/schema";
import { renderSeeds, seedsFrom } from "../support/device";
import { constantImage, judge, measure } from "../support/statistics";

// A cube of which every inner wall emits EMITTED and reflects ALBEDO: whatever a ray sees shows
// Le·(1 + ρ + ρ² + … + ρ^N), the light that has been scattered up to N times.
const EMITTED = [0.5, 1, 2] as const;
const ALBEDO = [0.9, 0.6, 0.3] as const;

const SIZE = [24, 24] as const;
// 576 pixels × 8 × 128 samples: the mean of all is known to below 0.1 %.
const SEEDS = seedsFrom(1, 8);
const SAMPLES = 128;

/** Corner and edges of the walls, with edge1 × edge2 pointing in. */
const WALLS: readonly (readonly [Vec3, Vec3, Vec3])[] = [
  [
    [-1, -1, -1],
    [0, 0, 2],
    [2, 0, 0],
  ],
  [
    [-1, 1, -1],
    [2, 0, 0],
    [0, 0, 2],
  ],
  [
    [-1, -1, -1],
    [0, 2, 0],
    [0, 0, 2],
  ],
  [
    [1, -1, -1],
    [0, 0, 2],
    [0, 2, 0],
  ],
  [
    [-1, -1, -1],
    [2, 0, 0],
    [0, 2, 0],
  ],
  [
    [-1, -1, 1],
    [0, 2, 0],
    [2, 0, 0],
  ],
];

const ROOMS: Readonly<Record<string, SceneObject[]>> = {
  quads: WALLS.map(([corner, edge1, edge2]) => ({ type: "quad", corner, edge1, edge2, material: "wall" })),
  planes: WALLS.map(([point, edge1, edge2]) => ({
    type: "plane",
    point,
    normal: cross(edge1, edge2),
    material: "wall",
  })),
  triangles: WALLS.flatMap(([corner, edge1, edge2]): SceneObject[] => {
    const far = add(add(corner, edge1), edge2);
    return [
      { type: "triangle", vertices: [corner, add(corner, edge1), far], material: "wall" },
      { type: "triangle", vertices: [corner, far, add(corner, edge2)], material: "wall" },
    ];
  }),
};

// The uniform estimator samples lights with the factor 1/d² and no MIS: where glowing walls meet, its variance is infinite and a
// z-test means nothing. Planes have no area to sample, so that there it can be tested; `litPlane.test.ts` has its lights.
const CASES = Object.keys(ROOMS).flatMap((room) =>
  (room === "planes" ? (["path", "uniform"] as const) : (["path"] as const)).flatMap((estimator) =>
    [0, 1, 3, 8].map((bounces) => ({ room, estimator, bounces })),
  ),
);

describe.each(CASES)("a closed room of glowing $room, $estimator estimator, N = $bounces, seeds 1–8", (one) => {
  const { room, estimator, bounces } = one;

  test("shows Le·(1 − ρ^(N+1)) / (1 − ρ) everywhere", async () => {
    const [width, height] = SIZE;
    const samples = bounces === 0 ? 16 : SAMPLES;
    const settings = { estimator, maxBounces: bounces };
    const renders = await renderSeeds(roomScene(ROOMS[room]!), { size: SIZE, samples, seeds: SEEDS, settings });
    for (const { stats } of renders) expect(stats.badSamples).toBe(0);

    const expected = ALBEDO.map((rho, c) => (EMITTED[c]! * (1 - rho ** (bounces + 1))) / (1 - rho));
    const images = renders.map(({ image }) => image);
    const verdict = judge(
      measure(images, width, height, samples),
      constantImage(width, height, expected as unknown as readonly [number, number, number]),
    );
    expect(verdict.meanError).toBeLessThan(1e-3);
    for (const sigmas of verdict.meanSigmas) expect(Math.abs(sigmas)).toBeLessThan(4);
    expect(verdict.blockShare).toBe(1);
    expect(verdict.pixelShare).toBeGreaterThanOrEqual(0.9975);
  });
});

function roomScene(objects: SceneObject[]): Scene {
  return {
    // Off centre and tilted, so that the image shows four walls, their edges and a corner.
    camera: { position: [-0.7, -0.4, 0.8], target: [0.3, 0.2, -0.6], verticalFov: 100 },
    materials: { wall: { baseColor: ALBEDO, ior: 1, emission: EMITTED } },
    objects,
  };
}

function add(a: Vec3, b: Vec3): Vec3 {
  return [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
}

function cross(a: Vec3, b: Vec3): Vec3 {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}
