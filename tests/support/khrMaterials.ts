// How materials scatter, in doubles, from the papers and the extensions of glTF: what the shader's lobes must do.
//
// [1] Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces"
// [2] Heitz 2014, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", JCGT 3(2)
// [3] Estevez, Kulla 2017, "Production Friendly Microfacet Sheen BRDF"; KHR_materials_sheen
// [4] KHR_materials_anisotropy, _clearcoat, _transmission, _diffuse_transmission
import type { Material, Vec3 } from "../../src/scene/schema";
import { dot, normalize } from "./directionBins";
import { etaOf, interfaceOf, refracted } from "./interfaces";
import { schlickWeight } from "./microfacets";

/** What white fibres reflect of uniform light, under the angle of a cosine. */
export type SheenAlbedo = (cosine: number) => number;

/** α along x and y. */
export type Alphas = readonly [number, number];

/** Of a roughness above 0. [4] */
export function alphasOf({ roughness = 1, anisotropy = 0 }: Material): Alphas {
  const alpha = roughness ** 2;
  return [alpha + (1 - alpha) * anisotropy ** 2, alpha];
}

/** Density of normals that are stretched; m need not be unit. [2] eq. 85 */
export function stretchedDensity(m: Vec3, [ax, ay]: Alphas): number {
  const cos2 = m[2] ** 2 / dot(m, m);
  const slopes = (m[0] / (m[2] * ax)) ** 2 + (m[1] / (m[2] * ay)) ** 2;
  return 1 / (Math.PI * ax * ay * cos2 ** 2 * (1 + slopes) ** 2);
}

/** Λ, of either side. [2] eq. 72, 80 */
export function stretchedLambda(w: Vec3, [ax, ay]: Alphas): number {
  return (Math.sqrt(1 + ((ax * w[0]) ** 2 + (ay * w[1]) ** 2) / w[2] ** 2) - 1) / 2;
}

/** Height-correlated, of reflection. [2] eq. 99 */
export function jointMasking(wo: Vec3, wi: Vec3, alphas: Alphas): number {
  return 1 / (1 + stretchedLambda(wo, alphas) + stretchedLambda(wi, alphas));
}

/** Λ of fibres. [3] eq. 3, 4 */
export function charlieLambda(cosine: number, alpha: number): number {
  const q = (1 - alpha) ** 2;
  const between = (rough: number, smooth: number) => rough + (smooth - rough) * q;
  const L = (x: number) =>
    between(21.5473, 25.3245) / (1 + between(3.82987, 3.32435) * x ** between(0.19823, 0.16801)) +
    between(-1.9776, -1.27393) * x +
    between(-4.32054, -4.85967);
  return Math.exp(cosine < 0.5 ? L(cosine) : 2 * L(0.5) - L(1 - cosine));
}

/** As in src/lobes/sheen.wgsl: [3] reflects any amount of light where a cosine goes to 0. */
const LEAST_SLANT = 1e-4;

/** f of white fibres, before they are cut to what light there is. [3] eq. 1, 2 */
export function charlie(wo: Vec3, wi: Vec3, alpha: number): number {
  const [cosO, cosI] = [Math.max(wo[2], LEAST_SLANT), Math.max(wi[2], LEAST_SLANT)];
  const h = normalize(add(wo, wi));
  const D = charlieDensity(h[0] ** 2 + h[1] ** 2, alpha);
  return D / (1 + charlieLambda(cosO, alpha) + charlieLambda(cosI, alpha)) / (4 * cosO * wi[2]);
}

/** ∫ charlie·cos over the hemisphere, by the midpoint rule in cosI = v³ and φ: low roughnesses shine at grazing angles. */
export function charlieAlbedo(cosO: number, alpha: number, steps = 96): number {
  const sinO = Math.sqrt(1 - cosO ** 2);
  const slant = Math.max(cosO, LEAST_SLANT);
  const lambdaO = charlieLambda(slant, alpha);
  let sum = 0;
  for (let i = 0; i < steps; i++) {
    const v = (i + 0.5) / steps;
    const cosI = v ** 3;
    const sinI = Math.sqrt(1 - cosI ** 2);
    let D = 0;
    for (let j = 0; j < steps; j++) {
      const phi = (Math.PI * (j + 0.5)) / steps;
      const across2 = sinO ** 2 + sinI ** 2 + 2 * sinO * sinI * Math.cos(phi);
      D += charlieDensity(across2 / (across2 + (cosO + cosI) ** 2), alpha);
    }
    sum += (D * 3 * v ** 2) / (1 + lambdaO + charlieLambda(Math.max(cosI, LEAST_SLANT), alpha)) / (4 * slant);
  }
  return (sum * 2 * Math.PI) / steps ** 2;
}

/** Of fibres' normals, by the square of their sine. [3] eq. 2 */
function charlieDensity(sin2: number, alpha: number): number {
  return ((2 + 1 / alpha) * sin2 ** (0.5 / alpha)) / (2 * Math.PI);
}

/** The share of light that a clear coat reflects under an angle. [4]; its ior is 1.5 */
export function coatReflectance({ clearcoat = 0 }: Material, cosine: number): number {
  return clearcoat * (0.04 + 0.96 * schlickWeight(Math.abs(cosine)));
}

/** Below a coat and fibres: what of light passes on its way from `wi` to `wo`. */
function layersThrough(material: Material, wo: Vec3, wi: Vec3, sheenAlbedo: SheenAlbedo): number {
  return sheenThrough(material, wo, wi, sheenAlbedo) * coatThrough(material, wo, wi);
}

function sheenThrough({ sheenColor = [0, 0, 0] }: Material, wo: Vec3, wi: Vec3, sheenAlbedo: SheenAlbedo): number {
  const most = Math.max(...sheenColor);
  if (most === 0) return 1;
  return 1 - most * Math.min(Math.max(sheenAlbedo(wo[2]), sheenAlbedo(Math.abs(wi[2]))), 1);
}

function coatThrough(material: Material, wo: Vec3, wi: Vec3): number {
  return (1 - coatReflectance(material, wo[2])) * (1 - coatReflectance(material, wi[2]));
}

function sheenOf(
  { sheenColor = [0, 0, 0], sheenRoughness = 0 }: Material,
  wo: Vec3,
  wi: Vec3,
  albedo: SheenAlbedo,
): Vec3 {
  if (Math.max(...sheenColor) === 0) return [0, 0, 0];
  // Cut where fibres would reflect more light than there is.
  const most = Math.max(albedo(wo[2]), albedo(wi[2]), 1);
  return scale(sheenColor, charlie(wo, wi, Math.max(sheenRoughness, LEAST_SHEEN_ROUGHNESS) ** 2) / most);
}

/** As in src/lobes/sheen.ts. */
export const LEAST_SHEEN_ROUGHNESS = 0.07;

/** The shares of what gets below the interface: scattered back, scattered to the other side, passed. */
function below({ baseColor = [1, 1, 1], metallic = 0, ...material }: Material) {
  const { transmission = 0, diffuseTransmission = 0, diffuseTransmissionColor = [1, 1, 1] } = material;
  return {
    diffuse: scale(baseColor, (1 - metallic) * (1 - transmission) * (1 - diffuseTransmission)),
    translucent: scale(diffuseTransmissionColor, (1 - metallic) * (1 - transmission) * diffuseTransmission),
    passed: scale(baseColor, (1 - metallic) * transmission),
  };
}

/**
 * f, without what goes in one direction only. `eta²` is left out of the radiance that is refracted.
 *
 * @param sheenAlbedo - that the lobe scales by; cut at 1 where it is more.
 */
export function scattered(
  material: Material,
  wo: Vec3,
  wi: Vec3,
  front = true,
  sheenAlbedo: SheenAlbedo = () => 0,
): Vec3 {
  const { roughness = 1, clearcoat = 0, clearcoatRoughness = 0 } = material;
  const alphas = alphasOf(material);
  const { diffuse, translucent, passed } = below(material);
  const isAbove = wi[2] > 0;
  const mirrored: Vec3 = [wi[0], wi[1], Math.abs(wi[2])];
  const h = normalize(add(wo, mirrored));
  const { F, through } = interfaceOf(material, dot(wo, h), front);
  const eta = etaOf(material, front);
  const isRough = roughness > 0;
  const lobe = isRough
    ? (stretchedDensity(h, alphas) * jointMasking(wo, mirrored, alphas)) / (4 * wo[2] * mirrored[2])
    : 0;
  let f = scale(isAbove ? diffuse : translucent, through / Math.PI);
  if (isAbove) f = add(f, scale(F, lobe));
  else if (eta === undefined) f = add(f, scale(passed, through * lobe));
  else if (isRough) f = add(f, scale(passed, refractedShare(material, wo, wi, eta, front)));
  f = scale(f, layersThrough(material, wo, wi, sheenAlbedo));
  if (!isAbove) return f;
  f = add(f, scale(sheenOf(material, wo, wi, sheenAlbedo), coatThrough(material, wo, wi)));
  if (clearcoat === 0 || clearcoatRoughness === 0) return f;
  const coat: Alphas = [clearcoatRoughness ** 2, clearcoatRoughness ** 2];
  const coatLobe = (stretchedDensity(h, coat) * jointMasking(wo, wi, coat)) / (4 * wo[2] * wi[2]);
  const gray = coatReflectance(material, dot(wo, h)) * coatLobe;
  return add(f, [gray, gray, gray]);
}

/** [1] eq. 21 with masking and shadowing apart, eq. 34; times the square of eta, which is left out of radiance. */
function refractedShare(material: Material, wo: Vec3, wi: Vec3, eta: number, front: boolean): number {
  const sum = add(wo, scale(wi, eta));
  const m = normalize(scale(sum, Math.sign(sum[2]))); // eq. 16
  const [cosO, cosI] = [dot(wo, m), dot(wi, m)];
  if (cosO <= 0 || cosI >= 0) return 0;
  const alphas = alphasOf(material);
  const G = 1 / ((1 + stretchedLambda(wo, alphas)) * (1 + stretchedLambda(wi, alphas)));
  const { through } = interfaceOf(material, cosO, front);
  const bend = (cosO + eta * cosI) ** 2;
  return (through * G * stretchedDensity(m, alphas) * eta ** 2 * Math.abs((cosO * cosI) / (wo[2] * wi[2]))) / bend;
}

/** What of uniform light, all around, a surface sends to a viewer: everything, that of directions below, that of directions above. */
export type Albedo = { readonly sum: Vec3; readonly above: Vec3; readonly below: Vec3 };

/**
 * ∫ f·|cos| over the sphere, by the midpoint rule: over visible normals (Dupuy, Benyoub 2023) for what microfacets do, which leaves no
 * peak, and over cosines for the rest. Of a smooth surface, what goes in one direction only.
 */
export function albedoOf(
  material: Material,
  wo: Vec3,
  front = true,
  sheenAlbedo: SheenAlbedo = () => 0,
  steps = 48,
): Albedo {
  const { roughness = 1, clearcoat = 0, clearcoatRoughness = 0, sheenColor = [0, 0, 0] } = material;
  const { diffuse, translucent, passed } = below(material);
  const eta = etaOf(material, front);
  let [above, under]: [Vec3, Vec3] = [
    [0, 0, 0],
    [0, 0, 0],
  ];
  const seen = (wi: Vec3) => layersThrough(material, wo, wi, sheenAlbedo);

  overNormals(wo, roughness === 0 ? undefined : alphasOf(material), steps, (m, share) => {
    const cosine = dot(wo, m);
    const { F, through } = interfaceOf(material, cosine, front);
    const alphas = alphasOf(material);
    const maskedO = roughness === 0 ? 1 : 1 + stretchedLambda(wo, alphas);
    const reflected = add(scale(m, 2 * cosine), scale(wo, -1));
    const kept = (wi: Vec3) =>
      (roughness === 0 ? 1 : maskedO / (maskedO + stretchedLambda(wi, alphas))) * seen(wi) * share;
    if (reflected[2] > 0) {
      above = add(above, scale(F, kept(reflected)));
      if (eta === undefined) under = add(under, scale(passed, through * kept(reflected)));
    }
    const bent = eta === undefined ? undefined : refracted(wo, m, eta);
    if (!bent || bent[2] >= 0) return;
    const apart = roughness === 0 ? 1 : 1 / (1 + stretchedLambda(bent, alphas));
    under = add(under, scale(passed, through * apart * seen(bent) * share));
  });

  const hasCoat = clearcoat > 0;
  const coat: Alphas | undefined =
    clearcoatRoughness === 0 ? undefined : [clearcoatRoughness ** 2, clearcoatRoughness ** 2];
  if (hasCoat) {
    overNormals(wo, coat, steps, (m, share) => {
      const wi = add(scale(m, 2 * dot(wo, m)), scale(wo, -1));
      if (wi[2] <= 0) return;
      const maskedO = coat ? 1 + stretchedLambda(wo, coat) : 1;
      const kept = coat ? maskedO / (maskedO + stretchedLambda(wi, coat)) : 1;
      const gray = coatReflectance(material, dot(wo, m)) * kept * share;
      above = add(above, [gray, gray, gray]);
    });
  }

  const hasFibres = Math.max(...sheenColor) > 0;
  const isDense = hasFibres || Math.max(...diffuse, ...translucent) > 0;
  for (let i = 0; isDense && i < steps; i++) {
    for (let j = 0; j < 2 * steps; j++) {
      // cos = v³, which fibres at grazing angles need; cos dω = v³·3v² dv dφ.
      const v = (i + 0.5) / steps;
      const cosI = v ** 3;
      const measure = (3 * v ** 5 * 2 * Math.PI) / (2 * steps ** 2);
      const phi = (2 * Math.PI * (j + 0.5)) / (2 * steps);
      const sinI = Math.sqrt(1 - cosI ** 2);
      const wi: Vec3 = [sinI * Math.cos(phi), sinI * Math.sin(phi), cosI];
      const { through } = interfaceOf(material, dot(wo, normalize(add(wo, wi))), front);
      const kept = (through * seen(wi) * measure) / Math.PI;
      above = add(above, scale(diffuse, kept));
      under = add(under, scale(translucent, kept));
      if (!hasFibres) continue;
      above = add(above, scale(sheenOf(material, wo, wi, sheenAlbedo), coatThrough(material, wo, wi) * measure));
    }
  }
  return { sum: add(above, under), above, below: under };
}

/** Calls with normals that are seen from `wo` and the share that each stands for; without `alphas` with the one of the surface. */
function overNormals(wo: Vec3, alphas: Alphas | undefined, steps: number, visit: (m: Vec3, share: number) => void) {
  if (!alphas) return visit([0, 0, 1], 1);
  const [ax, ay] = alphas;
  const top = normalize([ax * wo[0], ay * wo[1], wo[2]]);
  for (let i = 0; i < steps; i++) {
    const cap = 1 - ((i + 0.5) / steps) * (1 + top[2]);
    const radius = Math.sqrt(1 - cap ** 2);
    for (let j = 0; j < 2 * steps; j++) {
      const phi = (Math.PI * (j + 0.5)) / steps;
      const [x, y, z] = add([radius * Math.cos(phi), radius * Math.sin(phi), cap], top);
      visit(normalize([ax * x, ay * y, z]), 1 / (2 * steps ** 2));
    }
  }
}

export function add(a: Vec3, b: Vec3): Vec3 {
  return [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
}

export function scale(a: Vec3, k: number): Vec3 {
  return [k * a[0], k * a[1], k * a[2]];
}
