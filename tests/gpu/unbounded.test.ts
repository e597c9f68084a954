import { describe, expect, test } from "vitest";
import { PathTracer } from "../../src/renderer/pathTracer";
import type { Scene, SceneObject, Vec3 } from "../../src/scene/schema";
import { renderScene, testDevice } from "../support/device";

const SIZE = [32, 32] as const;
const SAMPLES = 16;

/** A corner of two walls and a planet, on which a lamp that is huge too, a ball, a mesh and another lamp throw light and shadow. */
const VISIBLE: readonly SceneObject[] = [
  { type: "sphere", center: [0, -2000, 0], radius: 2000, material: "grey" },
  { type: "plane", point: [0, 0, -3], normal: [0.1, 0, 1], material: "red" },
  { type: "plane", point: [-3, 0, 0], normal: [1, 0, 0], material: "glow" },
  { type: "sphere", center: [0, 3010, 0], radius: 3000, material: "glow" },
  { type: "sphere", center: [0.5, 0.5, 0], radius: 0.5, material: "grey" },
  {
    type: "mesh",
    positions: [-1.5, 0.1, -1, -0.5, 0.1, -1, -1, 1.5, -1.2],
    indices: [0, 1, 2],
    material: "red",
  },
];

const hidden = (i: number): SceneObject =>
  i % 2
    ? { type: "plane", point: [0, 0, -4 - i], normal: [0.1, 0, 1], material: "grey" }
    : { type: "sphere", center: [0, -2010 - i, 0], radius: 2000, material: "red" };

/** @param hiddenCount - planes and huge spheres behind the others; first in the list, so that the visible ones are in a loop. */
function sceneOf(hiddenCount: number): Scene {
  return {
    camera: { position: [1, 1.5, 5], target: [0, 0.7, 0], verticalFov: 50 },
    materials: {
      grey: { baseColor: [0.6, 0.6, 0.6], ior: 1 },
      red: { baseColor: [0.8, 0.3, 0.2], roughness: 0.4 },
      glow: { baseColor: [0, 0, 0], ior: 1, emission: [0.5, 0.6, 0.7] },
    },
    objects: [...Array.from({ length: hiddenCount }, (_, i) => hidden(i)), ...VISIBLE],
    lights: [{ type: "sphere", position: [1, 2.5, 1], radius: 0.2, power: [30, 30, 30] }],
    maxBounces: 3,
  };
}

describe.each([false, true])("values as constants: %s", (constants) => {
  test("a hundred planes and huge spheres behind others change nothing that is seen", async () => {
    const options = { size: SIZE, samples: SAMPLES, settings: { constants } };
    const [alone, crowded] = [await renderScene(sceneOf(0), options), await renderScene(sceneOf(100), options)];
    expect(crowded.stats.badSamples).toBe(0);
    // The same points make the same paths, but for rounding: of 16,384 some take another turn.
    const differences = alone.image.map((value, i) => Math.abs(value - crowded.image[i]!));
    const mean = alone.image.reduce((sum, value) => sum + value, 0) / alone.image.length;
    expect(mean).toBeGreaterThan(0.1);
    expect(differences.filter((difference) => difference > 1e-3 * mean).length).toBeLessThan(0.05 * differences.length);
    expect(differences.reduce((sum, value) => sum + value, 0) / differences.length).toBeLessThan(5e-3 * mean);
  });
});

test.each([
  ["the planet", 16, 30, 0],
  ["the wall", 28, 2, 1],
])("%s is picked out of a hundred", async (_, x, y, visible) => {
  const [width, height] = SIZE;
  const tracer = await PathTracer.create({ scene: sceneOf(100), width, height, device: await testDevice() });
  const picked = await tracer.pick(x, y);
  expect(picked).toMatchObject({ kind: "object", index: 100 + visible });
  tracer.dispose();
});

const planes = (count: number) =>
  Array.from({ length: count }, (_, i): SceneObject => {
    return { type: "plane", point: [0, -1 - i, 0], normal: [i / 100, 1, 0], material: "grey" };
  });
const triangles = (count: number) =>
  Array.from({ length: count }, (_, i): SceneObject => {
    const vertices = [0, 1, 2].map((x): Vec3 => [x, i, 0]) as [Vec3, Vec3, Vec3];
    return { type: "triangle", vertices, material: "grey" };
  });

test.each([
  ["planes", planes, 50, 400],
  ["triangles without area", triangles, 50, 2000],
])("many %s take as long to compile as a few", async (_, objectsOf, few, many) => {
  const compileMs = async (count: number) => {
    const scene = { ...sceneOf(0), objects: [...objectsOf(count), ...VISIBLE] };
    const before = process.cpuUsage();
    const tracer = await PathTracer.create({ scene, width: 8, height: 8, device: await testDevice() });
    const { user, system } = process.cpuUsage(before);
    await tracer.sample(1);
    expect(tracer.stats.badSamples).toBe(0);
    tracer.dispose();
    return (user + system) / 1000;
  };
  const ms = [await compileMs(few), await compileMs(many)];
  console.log(`${few}: ${ms[0]!.toFixed(0)} ms, ${many}: ${ms[1]!.toFixed(0)} ms`);
  // When all were unrolled, four hundred planes took a minute, and fifty a second.
  expect(ms[1]).toBeLessThan(3 * ms[0]!);
});
