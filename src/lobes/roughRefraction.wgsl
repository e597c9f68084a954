// Refraction through GGX microfacets, with separate masking and shadowing as in [1]. Radiance is not scaled by the square of the index
// of refraction: a path gains on its way into a solid what it loses on its way out.
//
// Directions are unit, in the local frame (z = n, on wo's side); wi is below the surface. alpha > 0.
//
// [1] Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces"
// [2] Heitz 2014, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", JCGT 3(2)
import package::lobes::fresnel::{luminance, refractedCos2, transmittanceAt};
import package::lobes::ggx::{ggxD, ggxVisibility, microfacetD, microfacetSample, microfacetSlope};
import package::lobes::lobe::{BsdfValue, Directions, LEAST_COSINE};
import package::minMax::greater;
import package::scene::Bsdf;

// Some microfacets let light through where the surface as a whole reflects all of it: the least share of that.
const LEAST_THROUGH = 0.1;

fn roughRefractionShare(bsdf: Bsdf, wo: vec3f) -> f32 {
  let isRough = (bsdf.eta > 0.0) & (bsdf.alpha > 0.0);
  return select(0.0, luminance(bsdf.transmitted) * greater(transmittanceAt(bsdf, wo.z), LEAST_THROUGH), isRough);
}

fn roughRefractionValue(bsdf: Bsdf, at: Directions) -> BsdfValue {
  let sum = at.wo + bsdf.eta * at.wi;
  let wm = normalize(select(sum, -sum, sum.z < 0.0)); // [1] eq. 16
  let cosO = dot(at.wo, wm);
  let cosI = -dot(at.wi, wm);
  if (!(bsdf.eta > 0.0 && bsdf.alpha > 0.0 && cosO > 0.0 && cosI > 0.0)) { return BsdfValue(vec3f(0.0), 0.0); }
  // dωm / dωi. [1] eq. 17
  let across = cosO - bsdf.eta * cosI;
  let jacobian = bsdf.eta * bsdf.eta * cosI / (across * across);
  // Visible normals: G1·D·(wo·wm) / cosO, with G1 = 2·cos / (cos + slope). [2] eq. 2, 3
  let slope = microfacetSlope(bsdf, at.wo);
  let pdf = 2.0 * cosO * microfacetD(bsdf, wm) * jacobian / (at.wo.z + slope);
  let shadowing = 2.0 * -at.wi.z / (microfacetSlope(bsdf, at.wi) - at.wi.z);
  return BsdfValue(bsdf.transmitted * (transmittanceAt(bsdf, cosO) * shadowing * pdf), pdf);
}

// Zero for total reflection.
fn roughRefractionDirection(bsdf: Bsdf, wo: vec3f, u: vec2f) -> vec3f {
  let wm = microfacetSample(bsdf, wo, u);
  let inverse = 1.0 / select(1.0, bsdf.eta, bsdf.eta > 0.0);
  let cosO = dot(wo, wm);
  let cos2 = refractedCos2(cosO, 1.0 / inverse);
  if (cos2 <= 0.0) { return vec3f(0.0); }
  return normalize((cosO * inverse - sqrt(cos2)) * wm - inverse * wo);
}

// Where wi is the size of the lobe away from any refraction, nothing is expected but what this leaves.
const LEAST_EXPECTED = 0.01;

// f by the microfacets that refract one direction to the other, widened by the light as they turn with it.
fn roughRefractionExpect(bsdf: Bsdf, wo: vec3f, wi: vec3f, cosI: f32, size: f32) -> f32 {
  if (!(bsdf.eta > 0.0 && bsdf.alpha > 0.0)) { return 0.0; }
  let sum = wo + bsdf.eta * wi;
  let wm = normalize(select(sum, -sum, sum.z < 0.0));
  let across = dot(wo, wm) + bsdf.eta * dot(wi, wm);
  let jacobian = bsdf.eta * bsdf.eta * abs(dot(wi, wm)) / greater(across * across, LEAST_COSINE);
  let alpha = sqrt(bsdf.alpha * bsdf.alpha + jacobian * size * size);
  let lobe = 4.0 * abs(dot(wo, wm)) * jacobian * ggxD(wm, alpha) * ggxVisibility(greater(wo.z, LEAST_COSINE), cosI, alpha);
  return luminance(bsdf.transmitted) * greater(lobe, LEAST_EXPECTED);
}
