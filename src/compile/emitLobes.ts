// @lean wgsl
// Writes the part of the shader module `scene` that says how surfaces scatter: `Bsdf`, and the functions that join the lobes of the
// scene's materials.

import type { Lobe } from "../lobes/lobe";
import { bsdfColumns, lobesIn } from "../lobes/lobes";
import type { Features } from "./features";

/**
 * - `materialOf(id)`: the lobes' columns of a primitive's material.
 * - `seenFrom(material, wo)`: with what depends on the direction to the viewer.
 * - `bsdfEval(bsdf, wo, wi)`: of the lobes that have a density.
 * - `bsdfSample(bsdf, wo, u, lobe)`: draws the lobe with `lobe`, the direction with `u`. Of the baseline estimator, in its place,
 *   `bsdfSampleUniform`: uniform over the hemisphere, whatever the surface reflects; only lobes of one
 *   direction are followed exactly.
 * - `bsdfExpect(bsdf, wo, wi, size)`, where lights are chosen among: about the mean of f·cos over a ball of light around wi of radius `size` at distance 1: to choose
 *   lights by. 0 only where all of the ball is below the surface.
 */
export function emitLobes(features: Features): string {
  const columns = bsdfColumns(features);
  const lobes = drawn(lobesIn(features));
  const derived = lobes
    .flatMap(({ lobe }) => Object.entries(lobe.derived ?? {}))
    .filter(([, { when }]) => when(features));
  const members = [...columns, ...derived].map(([name, { type }]) => `  ${name}: ${type},\n`);
  const shares = lobes.flatMap(({ name, condition }) => (condition ? `  ${name}Share: f32,\n` : []));
  return `
struct Bsdf {
${members.join("")}${shares.join("")}}

fn materialOf(id: u32) -> Bsdf {
  var bsdf: Bsdf;
${columns.map(([name]) => `  bsdf.${name} = ${name}Of(id);\n`).join("")}  return bsdf;
}

fn seenFrom(material: Bsdf, wo: vec3f) -> Bsdf {
  var bsdf = material;
${derived.map(([name, { from }]) => `  bsdf.${name} = ${from};\n`).join("")}${emitShares(lobes)}  return bsdf;
}
${emitValue(lobes, features)}
${emitSamples(lobes, features)}`;
}

type Drawn = {
  readonly name: string;
  readonly lobe: Lobe;
  /** WGSL expressions: the probability of the lobe, and whether `lobe` draws it, if it is not what is left. */
  readonly probability: string;
  readonly condition?: string;
};

/** In the order in which their shares lie in [0, 1): lobes of one direction first, the first of the registry last. */
function drawn([first, ...others]: ReturnType<typeof lobesIn>): Drawn[] {
  const [name, lobe] = first!; // every scene has one
  const ordered = [...others].sort(([, a], [, b]) => Number("delta" in b) - Number("delta" in a));
  const shares = ordered.map(([name]) => `bsdf.${name}Share`);
  return [
    ...ordered.map(([name, lobe], i) => ({
      name,
      lobe,
      probability: shares[i]!,
      condition: `lobe < ${shares.slice(0, i + 1).join(" + ")}`,
    })),
    { name, lobe, probability: ["1.0", ...shares].join(" - ") },
  ];
}

function emitShares(lobes: readonly Drawn[]): string {
  if (lobes.length === 1) return "";
  const names = lobes.map(({ name }) => name);
  const expected = lobes.map(({ name, lobe }) => `  let ${name} = ${lobe.share};\n`);
  const shares = lobes.flatMap(({ name, condition }) =>
    condition ? `  bsdf.${name}Share = select(${name} / total, 0.0, total == 0.0);\n` : [],
  );
  return `${expected.join("")}  let total = ${names.join(" + ")};\n${shares.join("")}`;
}

/** Lobes that have a density. */
function spread(lobes: readonly Drawn[]) {
  return lobes.flatMap(({ lobe, ...rest }) => ("value" in lobe ? { ...lobe, ...rest } : []));
}

function emitValue(lobes: readonly Drawn[], { MANY_LIGHTS }: Features): string {
  // The last has what the others leave: added first, as it is in most scenes the only one.
  const dense = spread(lobes).reverse();
  const sums = dense.map(
    ({ name, value, probability }) =>
      `  let ${name} = ${value};\n  sum.f += ${name}.f;\n  sum.pdf += (${probability}) * ${name}.pdf;\n`,
  );
  const expected = dense.every(({ isEven }) => isEven) ? "" : ` * (${dense.map(({ expect }) => expect).join(" + ")})`;
  return `
fn bsdfEval(bsdf: Bsdf, wo: vec3f, wi: vec3f) -> BsdfValue {
  let at = directions(wo, wi);
  var sum: BsdfValue;
${sums.join("")}  return aboveOnly(sum, at);
}
${MANY_LIGHTS ? emitExpectation(expected) : ""}`;
}

function emitExpectation(expected: string): string {
  return `
fn bsdfExpect(bsdf: Bsdf, wo: vec3f, wi: vec3f, size: f32) -> f32 {
  let cosI = lesser(greater(wi.z + size, 0.0), 1.0);
  return cosI${expected};
}
`;
}

function emitSamples(lobes: readonly Drawn[], { UNIFORM }: Features): string {
  const deltas = lobes.flatMap(({ lobe, probability, condition }) => {
    if (!("delta" in lobe)) return [];
    const sample = `let share = ${probability}; return ${lobe.delta};`;
    return { probability, text: condition ? `  if (${condition}) { ${sample} }\n` : `  ${sample}\n` };
  });
  const followed = deltas.map(({ text }) => text).join("");
  const dense = spread(lobes).reverse();
  const [last, ...others] = dense;
  const left = ["1.0", ...deltas.map(({ probability }) => probability)].join(" - ");
  const picks = others.map(({ sample, condition }) => `  wi = select(wi, ${sample}, ${condition});\n`);
  const body = !last
    ? ""
    : lobes.length === 1 && last.alone
      ? `  return ${last.alone};\n`
      : `  var wi = ${last.sample};\n${picks.join("")}  return weighed(bsdf, wo, wi);\n`;
  if (UNIFORM) {
    return `
fn bsdfSampleUniform(bsdf: Bsdf, wo: vec3f, u: vec2f, lobe: f32) -> BsdfSample {
${followed}${last ? `  return uniformSample(bsdf, wo, u, ${left});\n` : ""}}
`;
  }
  return `
fn bsdfSample(bsdf: Bsdf, wo: vec3f, u: vec2f, lobe: f32) -> BsdfSample {
${followed}${body}}
`;
}
