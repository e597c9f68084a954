// GGX (Trowbridge–Reitz) microfacets as a reflection lobe, isotropic; see anisotropy.wgsl.
//
// Directions are unit, in the local frame (z = n), both above the surface. wo points to the viewer, wi to the light,
// wm is the microfacet normal. alpha > 0.
//
// [1] Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces"
// [2] Heitz 2014, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", JCGT 3(2)
// [3] Dupuy, Benyoub 2023, "Sampling Visible GGX Normals with Spherical Caps"
// [4] Schlick 1994, "An Inexpensive BRDF Model for Physically-based Rendering"
import package::constants::{LEAST_COMPONENT, PI};
import package::lobes::anisotropy::{alphasOf, stretchedD, stretchedSample, stretchedSlope};
import package::directions::circle;
import package::lobes::fresnel::{fresnelShare, luminance, schlickFresnel};
import package::lobes::lobe::{BsdfValue, Directions, LEAST_COSINE};
import package::minMax::greater;
import package::scene::Bsdf;

@if(ROUGH)
fn ggxShare(bsdf: Bsdf, wo: vec3f) -> f32 {
  // What a rough solid reflects is drawn together with what it refracts.
  @if(ROUGH_REFRACTION) { if (bsdf.eta > 0.0) { return 0.0; } }
  @if(!MIRROR) return fresnelShare(bsdf, wo);
  @if(MIRROR) return select(0.0, fresnelShare(bsdf, wo), bsdf.alpha > 0.0);
}

// Anisotropic surfaces have Smith's masking. A perfect mirror is not stretched.
@if(ROUGH && ANISOTROPY)
fn ggxValue(bsdf: Bsdf, at: Directions) -> BsdfValue {
  if (bsdf.alpha == 0.0) { return BsdfValue(vec3f(0.0), 0.0); }
  @if(!EXACT_FRESNEL) var F = schlickFresnel(bsdf, at.schlick);
  @if(EXACT_FRESNEL) var F = at.F;
  @if(MULTISCATTER) F *= bsdf.gain;
  let D = microfacetD(bsdf, at.wm);
  let slopeO = microfacetSlope(bsdf, at.wo);
  let visibility = 0.5 / (at.wi.z * slopeO + at.wo.z * microfacetSlope(bsdf, at.wi));
  return BsdfValue(F * (D * visibility * at.wi.z), D * 0.5 / (at.wo.z + slopeO));
}

@if(ROUGH && !ANISOTROPY)
fn ggxValue(bsdf: Bsdf, at: Directions) -> BsdfValue {
  @if(!EXACT_FRESNEL) var F = schlickFresnel(bsdf, at.schlick);
  @if(EXACT_FRESNEL) var F = at.F;
  @if(MULTISCATTER) F *= bsdf.gain;
  let D = ggxD(at.wm, bsdf.alpha);
  @if(SMITH) let smith = ggxVisibility(at.wo.z, at.wi.z, bsdf.alpha);
  @if(SCHLICK_BECKMANN) let schlick = schlickBeckmannVisibility(at.wo.z, at.wi.z, bsdf.alpha);
  @if(SMITH && !SCHLICK_BECKMANN) let visibility = smith;
  @if(!SMITH && SCHLICK_BECKMANN) let visibility = schlick;
  @if(SMITH && SCHLICK_BECKMANN) let visibility = select(smith, schlick, bsdf.schlickBeckmann > 0.0);
  let value = BsdfValue(F * (D * visibility * at.wi.z), ggxPdf(at.wo.z, at.wm, bsdf.alpha));
  @if(!MIRROR) return value;
  @if(MIRROR) return BsdfValue(select(vec3f(0.0), value.f, bsdf.alpha > 0.0), select(0.0, value.pdf, bsdf.alpha > 0.0));
}

@if(ROUGH)
fn ggxDirection(bsdf: Bsdf, wo: vec3f, u: vec2f) -> vec3f {
  @if(!ANISOTROPY) return reflect(-wo, ggxSample(wo, bsdf.alpha, u));
  @if(ANISOTROPY) return reflect(-wo, microfacetSample(bsdf, wo, u));
}

// The square of the least width of a lobe that a light is weighed by.
const LEAST_WIDTH2 = 1e-6;

// wo and wi are opposite, and their half vector has no direction, where the square of their sum is no more than this.
const OPPOSITE2 = 1e-30;

fn ggxExpect(bsdf: Bsdf, wo: vec3f, wi: vec3f, cosI: f32, size: f32) -> f32 {
  // Microfacets turn by half the angle: the light widens their distribution. The least width keeps weights finite.
  @if(!ANISOTROPY) let alpha = sqrt(greater(bsdf.alpha * bsdf.alpha + 0.25 * size * size, LEAST_WIDTH2));
  @if(ANISOTROPY) let alpha = sqrt(greater(bsdf.alphaAlong * bsdf.alphaAlong + 0.25 * size * size, LEAST_WIDTH2));
  let h = wo + wi;
  let wm = select(vec3f(0.0, 0.0, 1.0), normalize(h), dot(h, h) > OPPOSITE2);
  var glossy = ggxD(wm, alpha) * ggxVisibility(greater(wo.z, LEAST_COSINE), cosI, alpha);
  @if(MIRROR) glossy = select(0.0, glossy, bsdf.alpha > 0.0); // light samples never find a mirror's direction
  // Even black metal reflects at grazing angles.
  return greater(luminance(bsdf.F0), 0.01 * bsdf.f90) * glossy;
}

// Density of a surface's microfacet normals, per steradian.
fn microfacetD(bsdf: Bsdf, wm: vec3f) -> f32 {
  @if(!ANISOTROPY) return ggxD(wm, bsdf.alpha);
  @if(ANISOTROPY) return stretchedD(wm, alphasOf(bsdf));
}

// cos·(1 + 2Λ) of a surface; see ggxSlope.
fn microfacetSlope(bsdf: Bsdf, w: vec3f) -> f32 {
  @if(!ANISOTROPY) return ggxSlope(w.z, bsdf.alpha);
  @if(ANISOTROPY) return stretchedSlope(w, alphasOf(bsdf));
}

// A surface's microfacet normal visible from wo.
fn microfacetSample(bsdf: Bsdf, wo: vec3f, u: vec2f) -> vec3f {
  @if(!ANISOTROPY) return ggxSample(wo, bsdf.alpha, u);
  @if(ANISOTROPY) return stretchedSample(wo, alphasOf(bsdf), u);
}

// Density of microfacet normals, per steradian. [1] eq. 33, with 1 − cos² written as sin² so that it survives alpha → 0
fn ggxD(wm: vec3f, alpha: f32) -> f32 {
  let a2 = alpha * alpha;
  let d = wm.x * wm.x + wm.y * wm.y + a2 * wm.z * wm.z;
  return a2 / (PI * d * d);
}

// sqrt(alpha² + (1 − alpha²)·cos²) = cos·(1 + 2Λ), from which all Smith terms are made. [2] eq. 72
fn ggxSlope(cosTheta: f32, alpha: f32) -> f32 {
  let sin2 = greater(1.0 - cosTheta * cosTheta, 0.0);
  return sqrt(cosTheta * cosTheta + alpha * alpha * sin2);
}

// G2 / (4·cosO·cosI), height-correlated. [2] eq. 99
fn ggxVisibility(cosO: f32, cosI: f32, alpha: f32) -> f32 {
  return 0.5 / (cosI * ggxSlope(cosO, alpha) + cosO * ggxSlope(cosI, alpha));
}

// The same with Schlick's approximation of Beckmann's masking, k = alpha·sqrt(2/π). [4] eq. 19
fn schlickBeckmannVisibility(cosO: f32, cosI: f32, alpha: f32) -> f32 {
  let k = alpha * sqrt(2.0 / PI);
  return 0.25 / ((cosO * (1.0 - k) + k) * (cosI * (1.0 - k) + k));
}

// Density of wi when wm is drawn from the normals visible from wo: G1·D / (4·cosO), per steradian. [2] eq. 3, 17
fn ggxPdf(cosO: f32, wm: vec3f, alpha: f32) -> f32 {
  return ggxD(wm, alpha) * 0.5 / (cosO + ggxSlope(cosO, alpha));
}

// A microfacet normal visible from wo. [3] listing 3
fn ggxSample(wo: vec3f, alpha: f32, u: vec2f) -> vec3f {
  let stretched = normalize(vec3f(alpha * wo.xy, wo.z));
  let z = (1.0 - u.y) * (1.0 + stretched.z) - stretched.z;
  let cap = vec3f(sqrt(greater(1.0 - z * z, 0.0)) * circle(u.x), z) + stretched;
  return normalize(vec3f(alpha * cap.xy, greater(cap.z, LEAST_COMPONENT)));
}
