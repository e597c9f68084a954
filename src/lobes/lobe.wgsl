// How surfaces scatter light: what all lobes have in common. `Bsdf` and the functions that join the lobes of a scene's materials
// are generated; see compile/emitLobes.ts.
//
// Opaque surfaces are glTF 2.0's metallic-roughness (appendix B): mix(dielectric, metal, metallic) with
//   metal      = GGX with F = Schlick(baseColor)
//   dielectric = (1 − F)·Lambert + F·GGX with F = Schlick(f0)
// The two Fresnel terms mix into one, because Schlick's formula is linear in F0.
//
// A surface that light gets through scatters to its other side too: there wi.z is negative, and a lobe either reflects or transmits.
//
// Directions are unit, in the local frame (z = n, on wo's side). wo points to the viewer, wi to the light.
import package::constants::INV_PI;
import package::directions::{uniformHemisphere, uniformSphere};
import package::lobes::fresnel::{interfaceAt, schlickWeight};
import package::scene::{Bsdf, bsdfEval};

// Directions closer to the surface count as below it: the square of the half vector's length may underflow.
const LEAST_COSINE = 1e-18;

struct Directions {
  wo: vec3f,
  wi: vec3f,
  // Halfway between them: the normal of microfacets that reflect one to the other. Below the surface, those of wi's mirror image.
  @if(SPECULAR) wm: vec3f,
  // Schlick's weight of the Fresnel term there, or both terms.
  @if(SPECULAR && !EXACT_FRESNEL) schlick: f32,
  @if(EXACT_FRESNEL) F: vec3f,
  @if(EXACT_FRESNEL) through: f32,
}

struct BsdfValue {
  // f·cos
  f: vec3f,
  // Density of bsdfSample, per steradian; of one lobe, of its own directions.
  pdf: f32,
}

struct BsdfSample {
  wi: vec3f,
  // f·|cos| / pdf; 0 when no direction could be sampled, and the path stops.
  weight: vec3f,
  // Per steradian; 0 for a mirror, whose density is a delta.
  pdf: f32,
}

@if(!EXACT_FRESNEL)
fn directions(wo: vec3f, wi: vec3f) -> Directions {
  @if(!SPECULAR) return Directions(wo, wi);
  @if(SPECULAR) {
    @if(!BELOW) let wm = normalize(wo + wi);
    @if(BELOW) let wm = normalize(wo + vec3f(wi.xy, abs(wi.z)));
    return Directions(wo, wi, wm, schlickWeight(dot(wo, wm)));
  }
}

@if(EXACT_FRESNEL)
fn exactDirections(bsdf: Bsdf, wo: vec3f, wi: vec3f) -> Directions {
  let wm = normalize(wo + vec3f(wi.xy, abs(wi.z)));
  let interface_ = interfaceAt(bsdf, dot(wo, wm));
  return Directions(wo, wi, wm, interface_.F, interface_.through);
}

// Nothing is reflected below the surface.
fn aboveOnly(value: BsdfValue, at: Directions) -> BsdfValue {
  @if(!SPECULAR && !SHEEN && !COAT) return value;
  @if(SPECULAR || SHEEN || COAT) {
    let isAbove = (at.wo.z > LEAST_COSINE) & (at.wi.z > LEAST_COSINE);
    return BsdfValue(select(vec3f(0.0), value.f, isAbove), select(0.0, value.pdf, isAbove));
  }
}

// What is reflected above the surface, or transmitted below it.
@if(BELOW)
fn onSides(above: BsdfValue, below: BsdfValue, at: Directions) -> BsdfValue {
  let isAbove = at.wi.z > 0.0;
  let isOff = (at.wo.z > LEAST_COSINE) & (abs(at.wi.z) > LEAST_COSINE);
  let f = select(below.f, above.f, isAbove);
  return BsdfValue(select(vec3f(0.0), f, isOff), select(0.0, select(below.pdf, above.pdf, isAbove), isOff));
}

// A direction that some lobe has drawn, which is one for the other side or not.
@if(BELOW)
fn weighed(bsdf: Bsdf, wo: vec3f, wi: vec3f, isBelow: bool) -> BsdfSample {
  let value = bsdfEval(bsdf, wo, wi);
  let possible = select(wi.z > 0.0, wi.z < 0.0, isBelow) && value.pdf > 0.0;
  return BsdfSample(wi, select(vec3f(0.0), value.f / select(1.0, value.pdf, possible), possible), value.pdf);
}

// A direction that some lobe has drawn.
@if(!BELOW)
fn weighed(bsdf: Bsdf, wo: vec3f, wi: vec3f) -> BsdfSample {
  let value = bsdfEval(bsdf, wo, wi);
  let possible = wi.z > 0.0 && value.pdf > 0.0;
  return BsdfSample(wi, select(vec3f(0.0), value.f / select(1.0, value.pdf, possible), possible), value.pdf);
}

// A direction drawn uniformly over the hemisphere, or the sphere where light gets through, with the probability that no lobe of one direction has been drawn.
@if(UNIFORM)
fn uniformSample(bsdf: Bsdf, wo: vec3f, u: vec2f, probability: f32) -> BsdfSample {
  @if(!BELOW) let wi = uniformHemisphere(u);
  @if(!BELOW) let pdf = 0.5 * INV_PI * probability;
  @if(BELOW) let wi = uniformSphere(u);
  @if(BELOW) let pdf = 0.25 * INV_PI * probability;
  return BsdfSample(wi, bsdfEval(bsdf, wo, wi).f / pdf, pdf);
}
