import { describe, expect, test } from "vitest";
import { pointLight, sphere } from "../../src/scene/builders";
import type { Light, Material, Scene, SceneObject } from "../../src/scene/schema";
import { compile, sceneOf } from "../support/compiled";
import { renderSeeds, seedsFrom } from "../support/device";
import { runProbe } from "../support/probe";
import { createRandom } from "../support/random";
import { measurePoint } from "../support/statistics";

const SIZE = [48, 48] as const;
const SEEDS = seedsFrom(1, 8);
const SAMPLES = 128;

const FLOORS: Readonly<Record<string, Material>> = {
  "a diffuse floor": { baseColor: [0.7, 0.6, 0.5], ior: 1 },
  "a glossy floor": { baseColor: [0.7, 0.6, 0.5], metallic: 0.5, roughness: 0.5 },
  "black metal, which reflects at grazing angles only": { baseColor: [0, 0, 0], metallic: 1, roughness: 0.6 },
};

/** Lights of every kind over a floor, near and far, one of them below it and some turned away. */
function litScene(floor: Material, seed: number): Scene {
  const random = createRandom(seed);
  const around = (y: number): [number, number, number] => [4 * random() - 2, y, 4 * random() - 2];
  const material = "glow";
  const objects: SceneObject[] = [
    { type: "plane", point: [0, 0, 0], normal: [0, 1, 0], material: "floor" },
    { type: "sphere", center: [0, 0.5, 0], radius: 0.5, material: "floor" },
    { type: "sphere", center: around(1.5), radius: 0.2, material },
    { type: "quad", corner: around(1), edge1: [0.5, 0, 0], edge2: [0, 0, 0.5], material }, // shines down
    { type: "quad", corner: around(1), edge1: [0, 0, 0.5], edge2: [0.5, 0, 0], material }, // shines up
    { type: "triangle", vertices: [around(1), around(2), around(1)], material },
    { type: "box", center: around(0.2), size: [0.2, 0.4, 0.2], rotationY: 30, material },
  ];
  const lights: Light[] = [
    { type: "sphere", position: around(2), radius: 0.3, power: [50, 60, 70] },
    { type: "sphere", position: around(0.4), radius: 0.1, power: [5, 6, 7] },
    { type: "point", position: around(-1), power: [30, 30, 30] },
    { type: "point", position: around(2), power: [40, 30, 20] },
    { type: "point", position: around(3), power: [0, 0, 0] },
  ];
  return {
    camera: { position: [0, 2.5, 4], target: [0, 0.3, 0], verticalFov: 45 },
    materials: { floor, glow: { baseColor: [0, 0, 0], ior: 1, emission: [3, 4, 5] } },
    objects,
    lights,
    maxBounces: 1,
  };
}

/** So many lamps more that they are looked up in a loop, and so many spheres that the scene is in a tree and a storage buffer. */
function crowded(scene: Scene, seed: number): Scene {
  const random = createRandom(seed);
  const around = (y: number): [number, number, number] => [4 * random() - 2, y, 4 * random() - 2];
  const lamps = Array.from(
    { length: 60 },
    (): Light => ({ type: "sphere", position: around(1 + random()), radius: 0.05, power: [3, 3, 3] }),
  );
  const pebbles = Array.from(
    { length: 600 },
    (): SceneObject => ({ type: "sphere", center: around(0.02), radius: 0.02, material: "floor" }),
  );
  return { ...scene, objects: [...scene.objects, ...pebbles], lights: [...scene.lights!, ...lamps] };
}

const CASES = [
  ...Object.entries(FLOORS).map(([name, floor]) => {
    const size = { size: SIZE, samples: SAMPLES, lightSampleCounts: [1, 4] };
    return { name: `ten lights of every kind over ${name}`, scene: litScene(floor, 31), ...size };
  }),
  {
    name: "seventy lights over six hundred pebbles",
    scene: crowded(litScene(FLOORS["a diffuse floor"]!, 31), 32),
    size: [24, 24] as const,
    samples: 96,
    lightSampleCounts: [1],
  },
];

describe.each(CASES)("$name, seed 31", ({ name, scene, size, samples, lightSampleCounts }) => {
  const render = (settings: object) => renderSeeds(scene, { size, samples, seeds: SEEDS, settings });
  const meanOf = (renders: Awaited<ReturnType<typeof render>>) => {
    const means = renders.map(({ image }) => measurePoint(image).mean);
    const mean = means.reduce((sum, value) => sum + value, 0) / means.length;
    const variance = means.reduce((sum, value) => sum + (value - mean) ** 2, 0) / (means.length - 1);
    return { mean, standardError: Math.sqrt(variance / means.length) };
  };

  let baselineOnce: ReturnType<typeof render> | undefined;

  test.each(lightSampleCounts)("give as much with %d light samples as the baseline finds", async (lightSamples) => {
    const ours = await render({ lightSamples });
    for (const { stats } of ours) expect(stats.badSamples).toBe(0);
    baselineOnce ??= render({ estimator: "uniform", lightSamples: 16 });
    const [path, baseline] = [meanOf(ours), meanOf(await baselineOnce)];
    const sigma = Math.hypot(path.standardError, baseline.standardError);
    console.log(`${name}: ${path.mean.toFixed(5)} against ${baseline.mean.toFixed(5)} ± ${sigma.toExponential(1)}`);
    // Eight values give a standard error that is itself uncertain: Student's t with 7 degrees of freedom is below 5.41 with
    // probability 0.999.
    expect(Math.abs(path.mean - baseline.mean)).toBeLessThan(5.41 * sigma);
    expect(sigma).toBeLessThan(0.005 * baseline.mean); // or the comparison would say nothing
  });
});

test("what a light is expected to give is finite, leaves mirrors out, and is nothing from below only", async () => {
  const cases = [
    // wi, size, alpha, diffuse, F0
    { wi: [0, 0, 1], size: 0.1, alpha: 0.2, diffuse: 0.5, F0: 0.04 },
    { wi: [-0.6, 0, -0.8], size: 0.9, alpha: 0.2, diffuse: 0.5, F0: 0.04 }, // −wo, but some of it is above
    { wi: [-0.6, 0, 0.8], size: 0, alpha: 0, diffuse: 0.5, F0: 0.04 }, // the mirror's direction
    { wi: [0.6, 0, 0.8], size: 0, alpha: 1e-3, diffuse: 0, F0: 0 }, // black metal
    { wi: [0, 0.8, -0.6], size: 0.5, alpha: 0.2, diffuse: 0.5, F0: 0.04 },
  ];
  const ball = (material: string) => sphere({ center: [0, 0, 0], radius: 1, material });
  const lamp = pointLight({ position: [0, 3, 0], power: [1, 1, 1] });
  const { sceneModule, features } = compile(
    sceneOf([ball("rough"), ball("mirror")], [lamp, lamp], { rough: {}, mirror: { roughness: 0 } }),
  );
  const words = await runProbe({
    wgsl: `
      import package::scene::{Bsdf, bsdfExpect};
      fn probe(i: u32) {
        let wi = bitcast<vec4f>(inputs[2u * i]);
        let surface = bitcast<vec4f>(inputs[2u * i + 1u]);
        var bsdf: Bsdf;
        bsdf.diffuse = vec3f(surface.y);
        bsdf.F0 = vec3f(surface.z);
        bsdf.f90 = 1.0;
        bsdf.alpha = surface.x;
        let expected = bsdfExpect(bsdf, vec3f(0.6, 0.0, 0.8), wi.xyz, wi.w);
        outputs[i] = vec4u(bitcast<u32>(expected), 0u, 0u, 0u);
      }`,
    conditions: features,
    modules: { scene: sceneModule },
    count: cases.length,
    inputs: new Float32Array(cases.flatMap(({ wi, size, alpha, diffuse, F0 }) => [...wi, size, alpha, diffuse, F0, 0])),
    outputRows: cases.length,
  });
  const expected = cases.map((_, i) => new Float32Array(words.buffer)[4 * i]!);
  expect(expected.every(Number.isFinite)).toBe(true);
  expect(expected.map((value) => value > 0)).toEqual([true, true, true, true, false]);
  expect(expected[2]).toBeCloseTo((0.5 * 0.8) / Math.PI, 6);
});
