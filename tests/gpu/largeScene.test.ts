import { expect, test, vi } from "vitest";
import { PathTracer } from "../../src/renderer/pathTracer";
import type { Scene, SceneObject, Vec3 } from "../../src/scene/schema";
import { renderScene, testDevice } from "../support/device";
import { createRandom } from "../support/random";

/** Spheres in three materials in a cube of side 20. */
function crowd(count: number): Scene {
  const random = createRandom(count);
  const at = (): Vec3 => [20 * random() - 10, 20 * random() - 10, 20 * random() - 10];
  return {
    camera: { position: [0, 0, 30] },
    materials: {
      a: { baseColor: [0.8, 0.2, 0.2] },
      b: { baseColor: [0.2, 0.8, 0.2], ior: 1 },
      c: { metallic: 1, roughness: 0.3 },
    },
    objects: Array.from({ length: count }, (_, i): SceneObject => {
      return { type: "sphere", center: at(), radius: 0.2, material: "abc"[i % 3]! };
    }),
    lights: [{ type: "point", position: [0, 20, 20], power: [3000, 3000, 3000] }],
    environment: { radiance: [0.2, 0.2, 0.2] },
  };
}

test("four thousand spheres in three materials do not die at rest, and look the same", async () => {
  const options = { size: [16, 16], samples: 16 } as const;
  const moving = await renderScene(crowd(4096), { ...options, settings: { constants: false } });
  const resting = await renderScene(crowd(4096), { ...options, settings: { constants: true } });
  expect(resting.stats.badSamples).toBe(0);
  const meanOf = (image: Float32Array) => image.reduce((sum, value) => sum + value, 0) / image.length;
  expect(meanOf(moving.image)).toBeGreaterThan(0.1);
  expect(Math.abs(meanOf(resting.image) / meanOf(moving.image) - 1)).toBeLessThan(0.01); // the same paths, but for rounding
});

test("a camera that moves around many shapes sends none of their tables again", async () => {
  const device = await testDevice();
  const tracer = await PathTracer.create({ scene: crowd(1000), width: 8, height: 8, device });
  await tracer.compile();
  const writeBuffer = vi.spyOn(device.queue, "writeBuffer");
  for (let i = 0; i < 3; i++) {
    tracer.setCamera({ position: [i, 1, 30] });
    await tracer.sample(1);
  }
  const bytes = writeBuffer.mock.calls.map(([, , data, , size]) => size ?? data.byteLength);
  expect(bytes.length).toBeGreaterThanOrEqual(3);
  for (const length of bytes) expect(length).toBeLessThan(1024);
  writeBuffer.mockRestore();
  tracer.dispose();
});
