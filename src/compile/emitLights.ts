// @lean wgsl
// Writes the part of the shader module `scene` that chooses the light to sample, and a point on it.

import type { Light } from "../lights/light";
import { isDistant, samplerOf, tagOf } from "../lights/lights";
import type { Features } from "./features";
import type { Values } from "./values";

/** `sampleKind`: a point on a light, by its kind. */
export function emitLightSamplers(lights: readonly Light[], { UNIFORM }: Features): string {
  const byTag = new Map(lights.map((light) => [tagOf(light), samplerOf(light)]));
  const kinds = [...byTag].sort(([a], [b]) => a - b);
  const samples = kinds.map(([tag, { sample, baseline = sample }], i) => {
    const isLast = i === kinds.length - 1;
    return `  ${isLast ? "" : `if (light.kind == ${tag}u) { `}return ${UNIFORM ? baseline : sample};${isLast ? "" : " }"}\n`;
  });
  if (samples.length === 0) return "";
  return `fn sampleKind(light: Light, p: vec3f, u: vec2f, pick: vec2f) -> LightSample {\n${samples.join("")}}\n`;
}

// More than these are not unrolled, but looked up one after the other.
const MAX_UNROLLED = 48;

/** Whether the lights' bounds are in tables. */
export function hasManyLights(lights: readonly Light[]): boolean {
  return lights.length > MAX_UNROLLED;
}

/** Where those of the lights are that rays find when they escape. */
export function emitSkyLights(lights: readonly Light[], { SKY_DISKS }: Features): string {
  if (!SKY_DISKS) return "";
  return `const FIRST_SKY_LIGHT = ${firstDistant(lights)}u;\nconst LIGHT_COUNT = ${lights.length}u;\n`;
}

/** All from here on are infinitely far. */
function firstDistant(lights: readonly Light[]): number {
  return lights.filter((light) => !isDistant(light)).length;
}

/**
 * `chooseLight`: in proportion to the light that each one is expected to add to the surface, or evenly for the baseline
 * estimator; `lightBoundOf`, which knows the balls around emissive primitives; and, where some are infinitely far, `lightWeight`, which
 * knows how much they are expected to add.
 */
export function emitLightChoice(lights: readonly Light[], features: Features, values: Values): string {
  const signature = "fn chooseLight(surface: Surface, u: vec2f) -> LightChoice";
  if (lights.length <= 1) return `${signature} {\n  return LightChoice(0u, u, 1.0, 1.0);\n}\n`;
  if (!features.MANY_LIGHTS) {
    const count = `${lights.length}.0`;
    return `${signature} {
  let x = u.x * ${count};
  let index = min(u32(x), ${lights.length - 1}u);
  return LightChoice(index, vec2f(min(x - f32(index), 0x1.fffffep-1), u.y), 1.0 / ${count}, 1.0);
}
`;
  }
  if (hasManyLights(lights)) return emitLightLoop(lights.length, firstDistant(lights));
  // The faces of a box share a bound, and with it what is expected of them.
  const groups = [...new Set(lights.map(({ bound }) => bound))];
  const bounds = groups.map(({ center, radius }) => `vec4f(${values.vec3(center)}, ${values.scalar(radius)})`);
  const shares = groups.map((group, k) => {
    const light = lights.find(({ bound }) => bound === group)!;
    const { front } = light;
    if (isDistant(light)) return `  let share${k} = skyLightShare(surface, ${bounds[k]});\n`;
    const call = front
      ? `flatLightShare(surface, ${bounds[k]}, ${values.vec3(front)})`
      : `lightShare(surface, ${bounds[k]})`;
    return `  let share${k} = ${call};\n`;
  });
  const strengths = lights.map(({ strength }) => values.scalar(strength));
  const weights = lights.map(({ bound }, i) => `${strengths[i]} * share${groups.indexOf(bound)}`);
  const sums = weights.map((weight, i) => `  let sum${i} = ${i === 0 ? "" : `sum${i - 1} + `}${weight};\n`);
  const steps = lights.map((_, i) =>
    i === 0 ? "" : `  chosen = select(chosen, vec3f(${i}.0, sum${i - 1}, sum${i}), x >= sum${i - 1});\n`,
  );
  const lookups = groups.map((group, k) => {
    const { primitive } = lights.find(({ bound }) => bound === group)!;
    return primitive === undefined ? "" : `  bound = select(bound, ${bounds[k]}, id == ${primitive}u);\n`;
  });
  const skyWeights = lights.map((light, i) => {
    if (!isDistant(light)) return "";
    const share = `skyLightShare(surface, ${bounds[groups.indexOf(light.bound)]})`;
    return `  if (index == ${i}u) { return ${strengths[i]} * ${share}; }\n`;
  });
  return `${signature} {
${shares.join("")}${sums.join("")}  let total = sum${lights.length - 1};
  let x = u.x * total;
  // Index, and where its share of total begins and ends.
  var chosen = vec3f(0.0, 0.0, sum0);
${steps.join("")}  let weight = chosen.z - chosen.y;
  let stretched = clamp((x - chosen.y) / select(weight, 1.0, weight == 0.0), 0.0, 0x1.fffffep-1);
  return LightChoice(u32(chosen.x), vec2f(stretched, u.y), weight / select(total, 1.0, total == 0.0), total);
}

fn lightBoundOf(id: u32) -> vec4f {
  var bound = vec4f(0.0);
${lookups.join("")}  return bound;
}
${features.SKY_DISKS ? `\nfn lightWeight(index: u32, surface: Surface) -> f32 {\n${skyWeights.join("")}  return 0.0;\n}\n` : ""}`;
}

function emitLightLoop(count: number, firstDistant: number): string {
  const distant =
    firstDistant < count
      ? `  if (index >= ${firstDistant}u) { return scene.lightFronts[index].w * skyLightShare(surface, scene.lightBounds[index]); }\n`
      : "";
  return `
fn lightWeight(index: u32, surface: Surface) -> f32 {
${distant}  let bound = scene.lightBounds[index];
  let front = scene.lightFronts[index];
  let isFlat = any(front.xyz != vec3f(0.0));
  return front.w * select(lightShare(surface, bound), flatLightShare(surface, bound, front.xyz), isFlat);
}

fn chooseLight(surface: Surface, u: vec2f) -> LightChoice {
  var total = 0.0;
  for (var i = 0u; i < ${count}u; i++) { total += lightWeight(i, surface); }
  let x = u.x * total;
  // Index, where its share of total begins, and its weight.
  var chosen = vec3f(0.0);
  var sum = 0.0;
  for (var i = 0u; i < ${count}u; i++) {
    let weight = lightWeight(i, surface);
    chosen = select(chosen, vec3f(f32(i), sum, weight), (weight > 0.0) & (x >= sum));
    sum += weight;
  }
  let stretched = clamp((x - chosen.y) / select(chosen.z, 1.0, chosen.z == 0.0), 0.0, 0x1.fffffep-1);
  return LightChoice(u32(chosen.x), vec2f(stretched, u.y), chosen.z / select(total, 1.0, total == 0.0), total);
}

fn lightBoundOf(id: u32) -> vec4f {
  return scene.primitiveBounds[id];
}
`;
}
