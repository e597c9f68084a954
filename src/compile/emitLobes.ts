// @lean wgsl
// Writes the part of the shader module `scene` that says how surfaces scatter: `Bsdf`, and the functions that join the lobes of the
// scene's materials.

import type { Layer, Lobe } from "../lobes/lobe";
import { bsdfColumns, derivedIn, layersIn, lobesIn } from "../lobes/lobes";
import type { TextureField } from "../scene/schema";
import type { Features } from "./features";

/**
 * - `materialOf(id)`: the lobes' columns of a primitive's material.
 * - `textured(material, factors, uv)`: times the textures that multiply them.
 * - `seenFrom(material, wo)`: with what depends on the direction to the viewer.
 * - `bsdfEval(bsdf, wo, wi)`: of the lobes that have a density.
 * - `bsdfSample(bsdf, wo, u, lobe)`: draws the lobe with `lobe`, the direction with `u`. Of the baseline estimator, in its place,
 *   `bsdfSampleUniform`: uniform over the hemisphere, whatever the surface reflects; only lobes of one
 *   direction are followed exactly.
 * - `bsdfExpect(bsdf, wo, wi, size)`, where lights are chosen among: about the mean of f·cos over a ball of light around wi of radius `size` at distance 1: to choose
 *   lights by. 0 only where all of the ball is below the surface.
 *
 * @param rareTextures - those that some primitive has, beside glTF's without extensions.
 */
export function emitLobes(features: Features, rareTextures: readonly TextureField[]): string {
  const columns = bsdfColumns(features);
  const layers = layersIn(features);
  const lobes = drawn(lobesIn(features), layers);
  const derived = derivedIn(features);
  const types = new Map([...columns, ...derived].map(([name, { type }]) => [name, type]));
  const members = Array.from(types, ([name, type]) => `  ${name}: ${type},\n`);
  const shares = lobes.flatMap(({ name, condition }) => (condition ? `  ${name}Share: f32,\n` : []));
  return `
struct Bsdf {
${members.join("")}${shares.join("")}}

fn materialOf(id: u32) -> Bsdf {
  var bsdf: Bsdf;
${columns.map(([name]) => `  bsdf.${name} = ${name}Of(id);\n`).join("")}  return bsdf;
}
${rareTextures.length > 0 ? emitTextured(columns, rareTextures) : ""}
fn seenFrom(material: Bsdf, wo: vec3f) -> Bsdf {
  var bsdf = material;
${derived.map(([name, { from }]) => `  bsdf.${name} = ${from};\n`).join("")}${emitShares(lobes)}  return bsdf;
}
${emitValue(lobes, layers, features)}
${emitSamples(lobes, features)}`;
}

function emitTextured(columns: ReturnType<typeof bsdfColumns>, rare: readonly TextureField[]): string {
  const products = columns.flatMap(([name, { texture }]) => {
    if (!texture || !rare.includes(texture[0])) return [];
    const [field, part, least] = texture;
    const sampler = part === "color" ? "colorAt" : part === "a" ? "alphaAt" : "dataAt";
    const suffix = sampler === "dataAt" ? `.${part}` : "";
    const product = `bsdf.${name} * package::textures::${sampler}(factors.${field}, uv)${suffix}`;
    // What is 0 without the texture stays so.
    const value = least === undefined ? product : `select(0.0, greater(${product}, ${least}), bsdf.${name} > 0.0)`;
    return `  bsdf.${name} = ${value};\n`;
  });
  return `
fn textured(material: Bsdf, factors: Factors, uv: package::uvs::Uvs) -> Bsdf {
  var bsdf = material;
${products.join("")}  return bsdf;
}
`;
}

type Drawn = {
  readonly name: string;
  readonly lobe: Lobe;
  /** What lies on it. */
  readonly above: readonly Layer[];
  /** WGSL expressions: the probability of the lobe, and whether `lobe` draws it, if it is not what is left. */
  readonly probability: string;
  readonly condition?: string;
  /** Where its share of [0, 1) starts. */
  readonly start: string;
};

/** In the order in which their shares lie in [0, 1): lobes of one direction first, the first of the registry that has a density last. */
function drawn(lobes: ReturnType<typeof lobesIn>, layers: readonly Layer[]): Drawn[] {
  const first = lobes.find(([, lobe]) => "value" in lobe) ?? lobes[0]!; // every scene has one
  const [name, lobe] = first;
  const ordered = lobes
    .filter((other) => other !== first)
    .sort(([, a], [, b]) => Number("delta" in b) - Number("delta" in a));
  const shares = ordered.map(([name]) => `bsdf.${name}Share`);
  const above = ({ layer }: Lobe) => layers.slice(layer ? layers.indexOf(layer) + 1 : 0);
  return [
    ...ordered.map(([name, lobe], i) => ({
      name,
      lobe,
      above: above(lobe),
      probability: shares[i]!,
      condition: `lobe < ${shares.slice(0, i + 1).join(" + ")}`,
      start: ["0.0", ...shares.slice(0, i)].join(" + "),
    })),
    {
      name,
      lobe,
      above: above(lobe),
      probability: ["1.0", ...shares].join(" - "),
      start: ["0.0", ...shares].join(" + "),
    },
  ];
}

function emitShares(lobes: readonly Drawn[]): string {
  if (lobes.length === 1) return "";
  const names = lobes.map(({ name }) => name);
  const expected = lobes.map(({ name, lobe, above }) => {
    const product = [lobe.share, ...above.map(({ out }) => out)].join(" * ");
    return `  let ${name} = ${product};\n`;
  });
  const shares = lobes.flatMap(({ name, condition }) =>
    condition ? `  bsdf.${name}Share = select(${name} / total, 0.0, total == 0.0);\n` : [],
  );
  return `${expected.join("")}  let total = ${names.join(" + ")};\n${shares.join("")}`;
}

/** Lobes that have a density. */
function spread(lobes: readonly Drawn[]) {
  return lobes.flatMap(({ lobe, ...rest }) => ("value" in lobe ? { ...lobe, ...rest } : []));
}

function emitValue(lobes: readonly Drawn[], layers: readonly Layer[], features: Features): string {
  const { MANY_LIGHTS, BELOW, EXACT_FRESNEL } = features;
  // The last has what the others leave: added first, as it is in most scenes the only one.
  const dense = spread(lobes).reverse();
  const add = ({ name, value, probability, isBelow }: (typeof dense)[number]) => {
    const sums = isBelow === "some" ? ["sum", "below"] : isBelow ? ["below"] : ["sum"];
    const added = sums.map((sum) => `  ${sum}.f += ${name}.f;\n  ${sum}.pdf += (${probability}) * ${name}.pdf;\n`);
    return `  let ${name} = ${value};\n${added.join("")}`;
  };
  // From below: each layer takes of what lies below it, and adds its own.
  const ofLayer = (wanted: Layer | undefined) => dense.filter(({ layer }) => layer === wanted).map(add);
  const sums = [
    ...ofLayer(undefined),
    ...layers.flatMap((layer, i) => [
      `  let through${i} = ${layer.through};\n  sum.f *= through${i};\n`,
      ...(BELOW ? [`  below.f *= through${i};\n`] : []),
      ...ofLayer(layer),
    ]),
  ];
  const at = EXACT_FRESNEL ? "exactDirections(bsdf, wo, wi)" : "directions(wo, wi)";
  const start = `  let at = ${at};\n  var sum: BsdfValue;\n${BELOW ? "  var below: BsdfValue;\n" : ""}`;
  return `
fn bsdfEval(bsdf: Bsdf, wo: vec3f, wi: vec3f) -> BsdfValue {
${start}${sums.join("")}  return ${BELOW ? "onSides(sum, below, at)" : "aboveOnly(sum, at)"};
}
${features.CLEAR_WALLS && layers.length > 0 ? emitLayers(layers) : ""}${MANY_LIGHTS ? emitExpectation(dense, BELOW) : ""}`;
}

/** Of what a wall lets through, what passes the layers on it. */
function emitLayers(layers: readonly Layer[]): string {
  return `
fn layersThrough(bsdf: Bsdf, wo: vec3f, wi: vec3f) -> f32 {
  return ${layers.map(({ through }) => through).join(" * ")};
}
`;
}

function emitExpectation(dense: ReturnType<typeof spread>, BELOW: boolean): string {
  const signature = "fn bsdfExpect(bsdf: Bsdf, wo: vec3f, wi: vec3f, size: f32) -> f32";
  const sumOf = (lobes: typeof dense) => lobes.map(({ expect }) => expect).join(" + ") || "0.0";
  const [above, below] = [dense.filter(({ isBelow }) => isBelow !== true), dense.filter(({ isBelow }) => isBelow)];
  if (!BELOW) {
    const expected = dense.every(({ isEven }) => isEven) ? "" : ` * (${sumOf(dense)})`;
    return `
${signature} {
  let cosI = lesser(greater(wi.z + size, 0.0), 1.0);
  return cosI${expected};
}
`;
  }
  const side = (name: string, sign: string, lobes: typeof dense) => `
fn ${name}(bsdf: Bsdf, wo: vec3f, wi: vec3f, size: f32) -> f32 {
  let cosI = lesser(greater(size ${sign} wi.z, 0.0), 1.0);
  return cosI * (${sumOf(lobes)});
}
`;
  return `${side("expectAbove", "+", above)}${side("expectBelow", "-", below)}
${signature} {
  return expectAbove(bsdf, wo, wi, size) + expectBelow(bsdf, wo, wi, size);
}
`;
}

/** A WGSL expression for whether what a lobe has drawn is for below the surface; `wi` is what it has drawn. */
function sideOf({ isBelow = false }: Lobe): string {
  return isBelow === "some" ? "wi.z < 0.0" : String(isBelow);
}

/** What is left of `lobe` once it has drawn this one, for a lobe that has to draw once more. */
function emitRest({ isBelow, start, probability }: ReturnType<typeof spread>[number]): string {
  if (isBelow !== "some") return "";
  return `  let rest = clamp((lobe - (${start})) / greater(${probability}, 1e-6), 0.0, 0x1.fffffep-1);\n`;
}

function emitSamples(lobes: readonly Drawn[], { UNIFORM, BELOW }: Features): string {
  const dense = spread(lobes).reverse();
  const deltas = lobes.flatMap(({ lobe, probability, condition, above }) => {
    if (!("delta" in lobe)) return [];
    const sample =
      above.length === 0
        ? `let share = ${probability}; return ${lobe.delta};`
        : `let share = ${probability}; var drawn = ${lobe.delta}; let wi = drawn.wi; ${above.map(({ through }) => `drawn.weight *= ${through};`).join(" ")} return drawn;`;
    return { probability, text: condition ? `  if (${condition}) { ${sample} }\n` : `  ${sample}\n` };
  });
  const followed = deltas.map(({ text }) => text).join("");
  const [last, ...others] = dense;
  const left = ["1.0", ...deltas.map(({ probability }) => probability)].join(" - ");
  // Each drawn where the ones before it in [0, 1) are not.
  const picks = others.map((picked) => {
    const { sample, condition } = picked;
    const side = BELOW ? `  isBelow = select(isBelow, ${sideOf(picked)}, ${condition});\n` : "";
    return `${emitRest(picked)}  wi = select(wi, ${sample}, ${condition});\n${side}`;
  });
  const side = last && BELOW ? `  var isBelow = ${sideOf(last)};\n` : "";
  const body = !last
    ? ""
    : lobes.length === 1 && last.alone
      ? `  return ${last.alone};\n`
      : `${emitRest(last)}  var wi = ${last.sample};\n${side}${picks.join("")}  return weighed(bsdf, wo, wi${BELOW ? ", isBelow" : ""});\n`;
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
