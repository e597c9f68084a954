import { expect, test } from "vitest";
import type { Scene } from "../../../src/scene/schema";
import { renderSeeds, seedsFrom } from "../../support/device";
import { bumpySphere, insideOut, type MeshData, meshObject, placed, smoothSphere } from "../../support/meshes";
import { constantImage, judge, measure } from "../../support/statistics";

// As in `closedRoom.test.ts`: whatever a ray sees shows Le·(1 + ρ + … + ρ^N).
const EMITTED = [0.5, 1, 2] as const;
const ALBEDO = [0.9, 0.6, 0.3] as const;

const SIZE = [16, 16] as const;
const SEEDS = seedsFrom(1, 8);
const SAMPLES = 64;

test.each([0, 1, 3, 8])(
  "a closed bumpy mesh shows Le·(1 − ρ^(N+1)) / (1 − ρ) inside, N = %d, seeds 1–8",
  async (bounces) => {
    await expectEverywhere(
      insideOut(placed(bumpySphere(300), 4, [0, 0, 0])),
      bounces,
      ALBEDO.map((rho, c) => (EMITTED[c]! * (1 - rho ** (bounces + 1))) / (1 - rho)),
    );
  },
);

// With interpolated normals energy is no longer conserved: light scatters around the shading normal, and what would go below
// the triangle is lost, (1 − cos δ)/2 of it where the normals differ by δ. What a wall emits knows no shading normal.
test("a closed mesh with interpolated normals shows Le inside where nothing scatters, seeds 1–8", async () => {
  await expectEverywhere(insideOut(placed(smoothSphere(300), 2, [0, 0, 0])), 0, [...EMITTED]);
});

async function expectEverywhere(room: MeshData, bounces: number, expected: number[]): Promise<void> {
  const [width, height] = SIZE;
  const samples = bounces === 0 ? 8 : SAMPLES;
  const renders = await renderSeeds(roomScene(room), {
    size: SIZE,
    samples,
    seeds: SEEDS,
    settings: { maxBounces: bounces },
  });
  for (const { stats } of renders) expect(stats.badSamples).toBe(0);
  const images = renders.map(({ image }) => image);
  const verdict = judge(
    measure(images, width, height, samples),
    constantImage(width, height, expected as unknown as readonly [number, number, number]),
  );
  expect(verdict.meanError).toBeLessThan(2e-3);
  for (const sigmas of verdict.meanSigmas) expect(Math.abs(sigmas)).toBeLessThan(4);
  expect(verdict.blockShare).toBe(1);
  expect(verdict.pixelShare).toBeGreaterThanOrEqual(0.9975);
}

function roomScene(room: MeshData): Scene {
  return {
    camera: { position: [-0.7, -0.4, 0.8], target: [0.3, 0.2, -0.6], verticalFov: 100 },
    materials: { wall: { baseColor: ALBEDO, ior: 1, emission: EMITTED } },
    objects: [meshObject(room, "wall")],
  };
}
