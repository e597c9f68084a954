// Opaque glTF 2.0 metallic-roughness surfaces (appendix B): mix(dielectric, metal, metallic) with
//   metal      = GGX with F = Schlick(baseColor)
//   dielectric = (1 − F)·Lambert + F·GGX with F = Schlick(f0)
// The two Fresnel terms mix into one, because Schlick's formula is linear in F0.
//
// Directions are unit, in the local frame (z = n, on wo's side). wo points to the viewer, wi to the light.
import package::constants::INV_PI;
import package::directions::{cosineHemisphere, uniformHemisphere};
import package::lobes::fresnel::schlickWeight;
import package::lobes::ggx::{ggxPdf, ggxSample, ggxVisibility, ggxD, schlickBeckmannVisibility};
import package::minMax::{greater, lesser};

// Directions closer to the surface count as below it: the square of the half vector's length may underflow.
const LEAST_COSINE = 1e-18;

struct Bsdf {
  // (1 − metallic)·baseColor
  diffuse: vec3f,
  // Reflectance at normal incidence, mix(f0, baseColor, metallic).
  F0: vec3f,
  // Reflectance at normal incidence of the dielectric part alone.
  f0: f32,
  // Reflectance at grazing incidence: 1, or 0 for a surface that is Lambert only.
  f90: f32,
  // roughness²; 0 is a perfect mirror.
  alpha: f32,
  // 1 for the masking "schlick-beckmann", else 0.
  schlickBeckmann: f32,
  // Probability of sampling the specular lobe from the given wo.
  specularShare: f32,
  // What gives the rough lobe back the light of multiple scattering, from the given wo; 1 without the flag.
  gain: vec3f,
}

struct BsdfValue {
  // f·cos
  f: vec3f,
  // Density of bsdfSample, per steradian.
  pdf: f32,
}

// The same of the microfacets' lobe, without its Fresnel term.
struct GlossyValue {
  // D·G·cosI / (4·cosO·cosI)
  f: f32,
  pdf: f32,
}

struct BsdfSample {
  wi: vec3f,
  // f·|cos| / pdf; 0 when no direction could be sampled, and the path stops.
  weight: vec3f,
  // Per steradian; 0 for a mirror, whose density is a delta.
  pdf: f32,
}

fn luminance(c: vec3f) -> f32 {
  return dot(c, vec3f(0.2126, 0.7152, 0.0722));
}

// The share that the specular lobe is expected to reflect of what the surface reflects.
fn specularShare(bsdf: Bsdf, cosO: f32) -> f32 {
  @if(!DIFFUSE) return 1.0;
  @if(DIFFUSE && !SPECULAR) return 0.0;
  @if(DIFFUSE && SPECULAR) {
    let w = schlickWeight(cosO);
    let specular = luminance(bsdf.F0 + (bsdf.f90 - bsdf.F0) * w);
    let diffuse = luminance(bsdf.diffuse) * (1.0 - bsdf.f0 - (bsdf.f90 - bsdf.f0) * w);
    return select(specular / (specular + diffuse), 0.0, specular + diffuse == 0.0);
  }
}

// Mirrors aside, whose density is a delta.
fn bsdfEval(bsdf: Bsdf, wo: vec3f, wi: vec3f) -> BsdfValue {
  let lambert = greater(wi.z, 0.0) * INV_PI;
  @if(!SPECULAR) return BsdfValue(bsdf.diffuse * lambert, lambert);
  @if(SPECULAR) {
    let wm = normalize(wo + wi);
    let w = schlickWeight(dot(wo, wm));
    var value: BsdfValue;
    @if(DIFFUSE) {
      value.f = bsdf.diffuse * ((1.0 - bsdf.f0 - (bsdf.f90 - bsdf.f0) * w) * lambert);
      value.pdf = (1.0 - bsdf.specularShare) * lambert;
    }
    @if(ROUGH) {
      let glossy = glossyEval(bsdf, wo, wi, wm);
      var F = bsdf.F0 + (bsdf.f90 - bsdf.F0) * w;
      @if(MULTISCATTER) F *= bsdf.gain;
      var isRough = true;
      @if(MIRROR) isRough = bsdf.alpha > 0.0;
      value.f += select(vec3f(0.0), F * glossy.f, isRough);
      value.pdf += select(0.0, bsdf.specularShare * glossy.pdf, isRough);
    }
    let isAbove = (wo.z > LEAST_COSINE) & (wi.z > LEAST_COSINE);
    return BsdfValue(select(vec3f(0.0), value.f, isAbove), select(0.0, value.pdf, isAbove));
  }
}

// The square of the least width of a lobe that a light is weighed by.
const LEAST_ALPHA2 = 1e-6;

// wo and wi are opposite, and their half vector has no direction, where the square of their sum is no more than this.
const OPPOSITE2 = 1e-30;

// About the mean of f·cos over a ball of light around wi of radius `size` at distance 1: to choose lights by. 0 only where all
// of the ball is below the surface.
@if(MANY_LIGHTS)
fn bsdfExpect(bsdf: Bsdf, wo: vec3f, wi: vec3f, size: f32) -> f32 {
  let cosI = lesser(greater(wi.z + size, 0.0), 1.0);
  @if(!ROUGH) return cosI;
  @if(ROUGH) {
    // Microfacets turn by half the angle: the light widens their distribution. The least width keeps weights finite.
    let alpha = sqrt(greater(bsdf.alpha * bsdf.alpha + 0.25 * size * size, LEAST_ALPHA2));
    let h = wo + wi;
    let wm = select(vec3f(0.0, 0.0, 1.0), normalize(h), dot(h, h) > OPPOSITE2);
    var glossy = ggxD(wm, alpha) * ggxVisibility(greater(wo.z, LEAST_COSINE), cosI, alpha);
    @if(MIRROR) glossy = select(0.0, glossy, bsdf.alpha > 0.0); // light samples never find a mirror's direction
    // Even black metal reflects at grazing angles.
    let specular = greater(luminance(bsdf.F0), 0.01 * bsdf.f90);
    return cosI * (luminance(bsdf.diffuse) * INV_PI + specular * glossy);
  }
}

@if(ROUGH)
fn glossyEval(bsdf: Bsdf, wo: vec3f, wi: vec3f, wm: vec3f) -> GlossyValue {
  let D = ggxD(wm, bsdf.alpha);
  @if(SMITH) let smith = ggxVisibility(wo.z, wi.z, bsdf.alpha);
  @if(SCHLICK_BECKMANN) let schlick = schlickBeckmannVisibility(wo.z, wi.z, bsdf.alpha);
  @if(SMITH && !SCHLICK_BECKMANN) let visibility = smith;
  @if(!SMITH && SCHLICK_BECKMANN) let visibility = schlick;
  @if(SMITH && SCHLICK_BECKMANN) let visibility = select(smith, schlick, bsdf.schlickBeckmann > 0.0);
  return GlossyValue(D * visibility * wi.z, ggxPdf(wo.z, wm, bsdf.alpha));
}

// Draws the lobe with `lobe`, the direction with `u`.
fn bsdfSample(bsdf: Bsdf, wo: vec3f, u: vec2f, lobe: f32) -> BsdfSample {
  @if(!SPECULAR) {
    let wi = cosineHemisphere(u);
    return BsdfSample(wi, bsdf.diffuse, wi.z * INV_PI);
  }
  @if(SPECULAR) {
    let specular = lobe < bsdf.specularShare;
    var wm = vec3f(0.0, 0.0, 1.0);
    @if(ROUGH && MIRROR) wm = select(wm, ggxSample(wo, bsdf.alpha, u), bsdf.alpha > 0.0);
    @if(ROUGH && !MIRROR) wm = ggxSample(wo, bsdf.alpha, u);
    var wi = reflect(-wo, wm);
    @if(DIFFUSE) wi = select(cosineHemisphere(u), wi, specular);
    let value = bsdfEval(bsdf, wo, wi);
    let possible = wi.z > 0.0 && value.pdf > 0.0;
    let sample = BsdfSample(wi, select(vec3f(0.0), value.f / select(1.0, value.pdf, possible), possible), value.pdf);
    @if(!MIRROR) return sample;
    @if(MIRROR) {
      if (specular && bsdf.alpha == 0.0) { return mirrorSample(bsdf, wo); }
      return sample;
    }
  }
}

@if(MIRROR)
fn mirrorSample(bsdf: Bsdf, wo: vec3f) -> BsdfSample {
  let F = bsdf.F0 + (bsdf.f90 - bsdf.F0) * schlickWeight(wo.z);
  return BsdfSample(vec3f(-wo.xy, wo.z), F / bsdf.specularShare, 0.0);
}

// The baseline's choice: uniform over the hemisphere whatever the surface reflects; only mirrors are followed exactly.
@if(UNIFORM)
fn bsdfSampleUniform(bsdf: Bsdf, wo: vec3f, u: vec2f, lobe: f32) -> BsdfSample {
  @if(MIRROR) {
    if (bsdf.alpha == 0.0 && lobe < bsdf.specularShare) { return mirrorSample(bsdf, wo); }
  }
  let wi = uniformHemisphere(u);
  var pdf = 0.5 * INV_PI;
  @if(MIRROR) pdf *= select(1.0, 1.0 - bsdf.specularShare, bsdf.alpha == 0.0);
  return BsdfSample(wi, bsdfEval(bsdf, wo, wi).f / pdf, pdf);
}
