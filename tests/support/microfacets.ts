// The terms of design §4 in doubles, from the papers: what the shader's must be.
//
// [1] Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces"
// [2] Heitz 2014, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", JCGT 3(2)
// [3] glTF 2.0 specification, appendix B
import type { Material, Vec3 } from "../../src/scene/schema";

/** GGX as a function of the tangent of the angle between m and n; m need not be unit. [1] eq. 33 */
export function ggxDensity(m: Vec3, alpha: number): number {
  const cos2 = m[2] ** 2 / (m[0] ** 2 + m[1] ** 2 + m[2] ** 2);
  const tan2 = (m[0] ** 2 + m[1] ** 2) / m[2] ** 2;
  return alpha ** 2 / (Math.PI * cos2 ** 2 * (alpha ** 2 + tan2) ** 2);
}

/** Λ. [2] eq. 72 */
export function smithLambda(cosTheta: number, alpha: number): number {
  const tan2 = (1 - cosTheta ** 2) / cosTheta ** 2;
  return (Math.sqrt(1 + alpha ** 2 * tan2) - 1) / 2;
}

/** Height-correlated G2 [2] eq. 99, over 4·cosO·cosI. */
export function smithVisibility(cosO: number, cosI: number, alpha: number): number {
  return 1 / ((1 + smithLambda(cosO, alpha) + smithLambda(cosI, alpha)) * 4 * cosO * cosI);
}

/** Schlick's G1 of both directions, k = α·sqrt(2/π), over 4·cosO·cosI. */
export function schlickBeckmannVisibility(cosO: number, cosI: number, alpha: number): number {
  const k = alpha * Math.sqrt(2 / Math.PI);
  const g1 = (cosine: number) => cosine / (cosine * (1 - k) + k);
  return (g1(cosO) * g1(cosI)) / (4 * cosO * cosI);
}

/** Density of wi after reflection at a visible normal. [2] eq. 2, 3 and [1] eq. 14 */
export function visibleNormalPdf(wo: Vec3, m: Vec3, alpha: number): number {
  return ggxDensity(m, alpha) / (1 + smithLambda(wo[2], alpha)) / (4 * wo[2]);
}

export function schlickWeight(cosTheta: number): number {
  return (1 - cosTheta) ** 5;
}

/** f of one colour channel, glTF's mix of metal and dielectric. [3] B.3 */
export function gltfBrdf(material: Material, baseColor: number, wo: Vec3, wi: Vec3): number {
  const { metallic = 0, roughness = 1, ior = 1.5, masking = "smith" } = material;
  const alpha = roughness ** 2;
  const h: Vec3 = [wo[0] + wi[0], wo[1] + wi[1], wo[2] + wi[2]];
  const length = Math.hypot(...h);
  const weight = schlickWeight((wo[0] * h[0] + wo[1] * h[1] + wo[2] * h[2]) / length);
  const visibility = masking === "smith" ? smithVisibility : schlickBeckmannVisibility;
  const lobe = ggxDensity(h, alpha) * visibility(wo[2], wi[2], alpha);
  const f0 = ((ior - 1) / (ior + 1)) ** 2;
  const metal = (baseColor + (1 - baseColor) * weight) * lobe;
  if (ior === 1 && metallic === 0) return baseColor / Math.PI; // no interface (design §2)
  const F = f0 + (1 - f0) * weight;
  return metallic * metal + (1 - metallic) * (F * lobe + ((1 - F) * baseColor) / Math.PI);
}

/** What a white GGX lobe with Smith's masking reflects of uniform light, and the part of it that is Schlick's weight. */
export type LobeAlbedo = { readonly one: number; readonly weight: number };

/**
 * ∫ f·cos dω of the lobe, by the midpoint rule over visible normals (Dupuy, Benyoub 2023), whose density leaves G2/G1 to
 * integrate: bounded by 1, whatever α and the angle. `steps` = 256 is good to 3e-4, at normal incidence to 1e-5.
 */
export function lobeAlbedo(cosO: number, alpha: number, steps = 256): LobeAlbedo {
  const sinO = Math.sqrt(1 - cosO ** 2);
  const length = Math.hypot(alpha * sinO, cosO);
  const [x, z] = [(alpha * sinO) / length, cosO / length];
  const lambdaO = smithLambda(cosO, alpha);
  let [one, weight] = [0, 0];
  for (let i = 0; i < steps; i++) {
    const cap = 1 - ((i + 0.5) / steps) * (1 + z);
    const radius = Math.sqrt(1 - cap ** 2);
    for (let j = 0; j < steps; j++) {
      const phi = (Math.PI * (j + 0.5)) / steps;
      const m = [alpha * (radius * Math.cos(phi) + x), alpha * radius * Math.sin(phi), cap + z] as const;
      const cosM = m[2] / Math.hypot(...m);
      const cosOM = (sinO * m[0]) / Math.hypot(...m) + cosO * cosM;
      const cosI = 2 * cosOM * cosM - cosO;
      if (cosI <= 0) continue;
      const value = (1 + lambdaO) / (1 + lambdaO + smithLambda(cosI, alpha));
      one += value;
      weight += value * schlickWeight(cosOM);
    }
  }
  return { one: one / steps ** 2, weight: weight / steps ** 2 };
}
