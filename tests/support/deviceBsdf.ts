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
  /** Whether the viewer is in front of the surface of a solid, the default, or in the solid. */
  readonly front?: boolean;
  /** Radius at distance 1 of the ball of light around wi to expect light from; 0 by default. */
  readonly size?: number;
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

/** As `bsdfSampleUniform`, the sampler of the baseline estimator, gives them: as `sampleBsdf`. */
export function sampleUniformly(materials: readonly Material[], inputs: readonly BsdfInput[]): Promise<Float32Array> {
  return run(
    materials,
    inputs,
    2,
    `let drawn = bsdfSampleUniform(bsdfOf(id, wo, vec2f(0.0), vec3f(1.0)), wo, x.xy, x.z);
    outputs[2u * i] = bitcast<vec4u>(vec4f(drawn.wi, drawn.pdf));
    outputs[2u * i + 1u] = bitcast<vec4u>(vec4f(drawn.weight, 0.0));`,
    "bsdfSampleUniform",
  );
}

/** What `bsdfExpect`, by which lights are chosen, expects of a ball of light: four floats per input, of which the first counts. */
export function expectBsdf(materials: readonly Material[], inputs: readonly BsdfInput[]): Promise<Float32Array> {
  const body = `
    let expected = bsdfExpect(bsdfOf(id, wo, vec2f(0.0), vec3f(1.0)), wo, x.xyz, size);
    outputs[i] = bitcast<vec4u>(vec4f(expected, 0.0, 0.0, 0.0));`;
  return run(materials, inputs, 1, body, "bsdfExpect");
}

async function run(
  materials: readonly Material[],
  inputs: readonly BsdfInput[],
  rows: number,
  body: string,
  more?: "bsdfSampleUniform" | "bsdfExpect",
) {
  const lamp = { type: "point" as const, position: [0, 9, 0] as const, power: [1, 1, 1] as const };
  const scene = parseScene({
    camera: { position: [0, 0, 9] },
    materials: Object.fromEntries(materials.map((material, i) => [`m${i}`, material])),
    objects: materials.map((_, i) => ({ type: "sphere" as const, center: [i, 0, 0], radius: 1, material: `m${i}` })),
    lights: more === "bsdfExpect" ? [lamp, lamp] : [],
  });
  const { sceneModule, features, uniform } = compileScene(scene, {
    estimator: more === "bsdfSampleUniform" ? "uniform" : "path",
    sampler: "sobol",
    lightSamples: 1,
  });
  const floats = new Float32Array(8 * inputs.length);
  for (const [i, { material = 0, wo, x, front = true, size = 0 }] of inputs.entries()) {
    floats.set([...wo, material, ...x, front ? size : -1 - size], 8 * i);
  }
  const words = await runProbe({
    wgsl: `
      import package::scene::{${["bsdfEval", more ?? "bsdfSample"].join(", ")}};
      import package::surface::bsdfOf;
      fn probe(i: u32) {
        let a = bitcast<vec4f>(inputs[2u * i]);
        let x = bitcast<vec4f>(inputs[2u * i + 1u]);
        let wo = a.xyz;
        let id = u32(a.w);
        let size = select(x.w, -1.0 - x.w, x.w < 0.0);
        @if(REFRACTIVE) package::surface::seesFront = x.w >= 0.0;
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
