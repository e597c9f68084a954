import { describe, expect, test } from "vitest";
import { PathTracer } from "../../src/renderer/pathTracer";
import { testDevice } from "../support/device";
import { loadReference } from "../support/reference";

describe.each(["cornell", "spheres"] as const)("%s, seed 3", (name) => {
  test.each(["path", "uniform"] as const)("more bounces never darken a pixel, %s estimator", async (estimator) => {
    const { scene } = loadReference(name);
    const settings = { seed: 3, estimator };
    const tracer = await PathTracer.create({ scene, width: 64, height: 64, settings, device: await testDevice() });
    const images: Float32Array[] = [];
    for (let maxBounces = 0; maxBounces <= 8; maxBounces++) {
      tracer.update({ maxBounces });
      await tracer.sample(16);
      images.push(await tracer.readRadiance());
      expect(tracer.stats.badSamples).toBe(0);
    }
    tracer.dispose();

    for (const [n, image] of images.entries()) {
      if (n === 0) continue;
      const before = images[n - 1]!;
      // The same seed gives the same paths, one scattering longer: each sample is the one before plus light that is not
      // negative. Only rounding can take from it: 16 additions, 2⁻²³ each.
      const tolerance = 16 * 2 ** -23;
      const darker = image.filter((value, i) => value < before[i]! * (1 - tolerance)).length;
      expect(darker, `values darker at ${n} bounces than at ${n - 1}`).toBe(0);
      // The light of bounces 7 and 8 is still a thousandth of the whole in these scenes.
      expect(sumOf(image)).toBeGreaterThan(sumOf(before));
    }
  });
});

function sumOf(values: Float32Array): number {
  return values.reduce((sum, value) => sum + value, 0);
}
