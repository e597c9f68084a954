import { compileScene } from "../../src/compile/compileScene";
import { parseScene } from "../../src/scene/parseScene";
import type { Material, Vec3 } from "../../src/scene/schema";
import { runProbe } from "./probe";

/** A direction pair, or a direction and random numbers; unit, z = n, rounded to f32 on their way. */
export type BsdfInput = {
  /** Index of the material. */
  readonly material?: number;
  readonly wo: Vec3;
  /** wi to evaluate; u.x, u.y and the lobe's choice to sample. */
  readonly x: Vec3;
};

/** f·cos and the density of sampling, as `bsdfEval` gives them: four floats per input. */
export function evaluateBsdf(materials: readonly Material[], inputs: readonly BsdfInput[]): Promise<Float32Array> {
  const body = `
    let value = bsdfEval(bsdfOf(id, wo, vec2f(0.0), vec3f(1.0)), wo, x.xyz);
    outputs[i] = bitcast<vec4u>(vec4f(value.f, value.pdf));`;
  return run(materials, inputs, 1, body);
}

/** As `bsdfSample` gives them, eight floats per input: wi, pdf, weight, 0. */
export function sampleBsdf(materials: readonly Material[], inputs: readonly BsdfInput[]): Promise<Float32Array> {
  return run(
    materials,
    inputs,
    2,
    `let drawn = bsdfSample(bsdfOf(id, wo, vec2f(0.0), vec3f(1.0)), wo, x.xy, x.z);
    outputs[2u * i] = bitcast<vec4u>(vec4f(drawn.wi, drawn.pdf));
    outputs[2u * i + 1u] = bitcast<vec4u>(vec4f(drawn.weight, 0.0));`,
  );
}

async function run(materials: readonly Material[], inputs: readonly BsdfInput[], rows: number, body: string) {
  const scene = parseScene({
    camera: { position: [0, 0, 9] },
    materials: Object.fromEntries(materials.map((material, i) => [`m${i}`, material])),
    objects: materials.map((_, i) => ({ type: "sphere" as const, center: [i, 0, 0], radius: 1, material: `m${i}` })),
  });
  const { sceneModule, features, uniform } = compileScene(scene, {
    estimator: "path",
    sampler: "sobol",
    lightSamples: 1,
  });
  const floats = new Float32Array(8 * inputs.length);
  for (const [i, { material = 0, wo, x }] of inputs.entries()) floats.set([...wo, material, ...x, 0], 8 * i);
  const words = await runProbe({
    wgsl: `
      import package::scene::{bsdfEval, bsdfSample};
      import package::surface::bsdfOf;
      fn probe(i: u32) {
        let a = bitcast<vec4f>(inputs[2u * i]);
        let x = bitcast<vec4f>(inputs[2u * i + 1u]);
        let wo = a.xyz;
        let id = u32(a.w);
        ${body}
      }`,
    conditions: features,
    modules: { scene: sceneModule },
    scene: uniform,
    count: inputs.length,
    inputs: floats,
    outputRows: rows * inputs.length,
  });
  return new Float32Array(words.buffer);
}
