// Refraction through GGX microfacets, with separate masking and shadowing as in [1]. Radiance is not scaled by the square of the index
// of refraction: a path gains on its way into a solid what it loses on its way out.
//
// Directions are unit, in the local frame (z = n, on wo's side). alpha > 0.
//
// [1] Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces"
// [2] Heitz 2014, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", JCGT 3(2)
import package::lobes::fresnel::{expectedCosine, interfaceAt, luminance, refractedCos2};
import package::lobes::ggx::{ggxD, ggxVisibility, microfacetD, microfacetSample, microfacetSlope};
import package::lobes::lobe::{BsdfValue, Directions, LEAST_COSINE};
import package::minMax::greater;
import package::scene::Bsdf;

fn isRoughSolid(bsdf: Bsdf) -> bool {
  return (bsdf.eta > 0.0) & (bsdf.alpha > 0.0);
}

// Of what is reflected and of what is refracted.
fn roughRefractionShare(bsdf: Bsdf, wo: vec3f) -> f32 {
  if (!isRoughSolid(bsdf)) { return 0.0; }
  let interface_ = interfaceAt(bsdf, expectedCosine(bsdf, wo));
  return luminance(interface_.F) + luminance(bsdf.transmitted) * interface_.through;
}

// The probability with which a microfacet reflects.
fn reflectChance(bsdf: Bsdf, F: vec3f, through: f32) -> f32 {
  let reflected = luminance(F);
  let total = reflected + luminance(bsdf.transmitted) * through;
  return select(1.0, reflected / total, total > 0.0);
}

fn roughRefractionValue(bsdf: Bsdf, at: Directions) -> BsdfValue {
  if (!isRoughSolid(bsdf)) { return BsdfValue(vec3f(0.0), 0.0); }
  let slope = microfacetSlope(bsdf, at.wo);
  if (at.wi.z > 0.0) {
    let chance = reflectChance(bsdf, at.F, at.through);
    return BsdfValue(vec3f(0.0), chance * microfacetD(bsdf, at.wm) * 0.5 / (at.wo.z + slope));
  }
  let sum = at.wo + bsdf.eta * at.wi;
  let wm = normalize(select(sum, -sum, sum.z < 0.0)); // [1] eq. 16
  let cosO = dot(at.wo, wm);
  let cosI = -dot(at.wi, wm);
  if (cosO <= 0.0 || cosI <= 0.0) { return BsdfValue(vec3f(0.0), 0.0); }
  // dωm / dωi. [1] eq. 17
  let across = cosO - bsdf.eta * cosI;
  let jacobian = bsdf.eta * bsdf.eta * cosI / (across * across);
  // Visible normals: G1·D·(wo·wm) / cosO, with G1 = 2·cos / (cos + slope). [2] eq. 2, 3
  let density = 2.0 * cosO * microfacetD(bsdf, wm) * jacobian / (at.wo.z + slope);
  let shadowing = 2.0 * -at.wi.z / (microfacetSlope(bsdf, at.wi) - at.wi.z);
  let interface_ = interfaceAt(bsdf, cosO);
  let chance = 1.0 - reflectChance(bsdf, interface_.F, interface_.through);
  return BsdfValue(bsdf.transmitted * (interface_.through * shadowing * density), chance * density);
}

// Zero for light that microfacets send to the side where it does not belong.
fn roughRefractionDirection(bsdf: Bsdf, wo: vec3f, u: vec2f, rest: f32) -> vec3f {
  let wm = microfacetSample(bsdf, wo, u);
  let cosO = dot(wo, wm);
  let interface_ = interfaceAt(bsdf, cosO);
  if (rest < reflectChance(bsdf, interface_.F, interface_.through)) {
    let wi = reflect(-wo, wm);
    return select(vec3f(0.0), wi, wi.z > 0.0);
  }
  let inverse = 1.0 / select(1.0, bsdf.eta, bsdf.eta > 0.0);
  let cos2 = refractedCos2(cosO, 1.0 / inverse);
  if (cos2 <= 0.0) { return vec3f(0.0); }
  let wi = normalize((cosO * inverse - sqrt(cos2)) * wm - inverse * wo);
  return select(vec3f(0.0), wi, wi.z < 0.0);
}

// Where wi is the size of the lobe away from any refraction, nothing is expected but what this leaves.
const LEAST_EXPECTED = 0.01;

// f by the microfacets that refract one direction to the other, widened by the light as they turn with it.
fn roughRefractionExpect(bsdf: Bsdf, wo: vec3f, wi: vec3f, cosI: f32, size: f32) -> f32 {
  if (!isRoughSolid(bsdf)) { return 0.0; }
  let sum = wo + bsdf.eta * wi;
  let wm = normalize(select(sum, -sum, sum.z < 0.0));
  let across = dot(wo, wm) + bsdf.eta * dot(wi, wm);
  let jacobian = bsdf.eta * bsdf.eta * abs(dot(wi, wm)) / greater(across * across, LEAST_COSINE);
  let alpha = sqrt(bsdf.alpha * bsdf.alpha + jacobian * size * size);
  let lobe = 4.0 * abs(dot(wo, wm)) * jacobian * ggxD(wm, alpha) * ggxVisibility(greater(wo.z, LEAST_COSINE), cosI, alpha);
  return luminance(bsdf.transmitted) * greater(lobe, LEAST_EXPECTED);
}
