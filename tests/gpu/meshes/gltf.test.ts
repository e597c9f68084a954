import { expect, test } from "vitest";
import { renderSeeds, seedsFrom } from "../../support/device";
import { loadGltfReference } from "../../support/reference";
import { judge, measure } from "../../support/statistics";

const SAMPLES = 32;

test("a glTF file of mirrored meshes, a lamp and a point light agrees with Blender and Cycles, seeds 1–8", async () => {
  const reference = await loadGltfReference();
  const { width, height } = reference;
  const renders = await renderSeeds(reference.scene, {
    size: [width, height],
    samples: SAMPLES,
    seeds: seedsFrom(1, 8),
  });
  for (const { stats } of renders) expect(stats.badSamples).toBe(0);
  const images = renders.map(({ image }) => image);
  const { pixelShare, blockShare, meanSigmas, meanError } = judge(measure(images, width, height, SAMPLES), reference);
  console.log(
    `mirrored: pixels ${(100 * pixelShare).toFixed(2)} %, blocks ${(100 * blockShare).toFixed(1)} %, mean ${meanSigmas.map((sigmas) => sigmas.toFixed(2)).join(" ")} σ, σ ${meanError.toExponential(1)}`,
  );
  expect(pixelShare).toBeGreaterThanOrEqual(0.9975);
  expect(blockShare).toBe(1);
  for (const sigmas of meanSigmas) expect(Math.abs(sigmas)).toBeLessThan(4);
});
