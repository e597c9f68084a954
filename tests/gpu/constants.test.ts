import { expect, test } from "vitest";
import { PathTracer } from "../../src/renderer/pathTracer";
import { renderScene, testDevice } from "../support/device";
import { loadReference, REFERENCE_NAMES } from "../support/reference";

const SIZE = [64, 64] as const;
const SAMPLES = 16;

test.each(REFERENCE_NAMES)("%s looks the same with its values as constants as in the uniform, seed 8", async (name) => {
  const { scene } = loadReference(name);
  const [uniform, constants] = [
    await renderScene(scene, { size: SIZE, samples: SAMPLES, seed: 8, settings: { constants: false } }),
    await renderScene(scene, { size: SIZE, samples: SAMPLES, seed: 8, settings: { constants: true } }),
  ];
  expect(constants.stats.features).toContain("values as constants");
  expect(uniform.stats.features).not.toContain("values as constants");

  expectSamePaths(constants.image, uniform.image);
});

test("constants take over in the middle of an accumulation, which goes on, seed 8", async () => {
  const { scene } = loadReference("spheres");
  const [width, height] = SIZE;
  const tracer = await PathTracer.create({
    scene,
    width,
    height,
    settings: { seed: 8, constants: true },
    device: await testDevice(),
  });
  await tracer.sample(SAMPLES / 2);
  const { program } = tracer;
  await tracer.compile();
  expect(tracer.program).not.toBe(program);
  await tracer.sample(SAMPLES / 2);
  expect(tracer.stats.samples).toBe(SAMPLES);
  const image = await tracer.readRadiance();

  const whole = await renderScene(scene, { size: SIZE, samples: SAMPLES, seed: 8, settings: { constants: false } });
  expectSamePaths(image, whole.image);

  // They fit no other scene: an edit takes the other program back.
  const objects = scene.objects.map((object) => (object.type === "sphere" ? { ...object, radius: 0.5 } : object));
  await tracer.setScene({ ...scene, objects });
  await tracer.sample(1);
  expect(tracer.program).toBe(program);
  tracer.dispose();
});

/**
 * The same paths from the same points, but compilers fold constants and may round otherwise: values change in the last
 * digits of eight bounces. Where rounding decides a hit at an edge, or a lobe, a whole path becomes another one; of the
 * 65,536 · 16 hits or so in one image, no more than some dozen are that close.
 */
function expectSamePaths(image: Float32Array, expected: Float32Array): void {
  const off = expected.filter((value, i) => Math.abs(image[i]! - value) > 1e-3 * value).length;
  expect(off / expected.length).toBeLessThan(2e-3);
}
