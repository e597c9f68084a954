// A clear coat of ior 1.5: GGX microfacets, or a mirror, on top of a surface, which it dims on light's way in and out.
// KHR_materials_clearcoat, whose single factor is taken of both ways here.
//
// Directions are unit, in the local frame of the surface. The coat may have a normal of its own.
import package::basis::{frameAround, toLocal, toWorld};
import package::lobes::fresnel::schlickWeight;
import package::lobes::ggx::{LEAST_WIDTH2, ggxD, ggxPdf, ggxSample, ggxVisibility};
import package::lobes::lobe::{BsdfSample, BsdfValue, Directions, LEAST_COSINE};
import package::minMax::greater;
import package::scene::Bsdf;

// Reflectance at normal incidence of ior 1.5.
const COAT_F0 = 0.04;

fn coatFresnel(bsdf: Bsdf, cosTheta: f32) -> f32 {
  return bsdf.clearcoat * (COAT_F0 + (1.0 - COAT_F0) * schlickWeight(cosTheta));
}

// A direction in the coat's own frame, and back.
fn toCoat(bsdf: Bsdf, w: vec3f) -> vec3f {
  @if(!COAT_NORMAL) return w;
  @if(COAT_NORMAL) return toLocal(frameAround(bsdf.coatNormal), w);
}

fn fromCoat(bsdf: Bsdf, w: vec3f) -> vec3f {
  @if(!COAT_NORMAL) return w;
  @if(COAT_NORMAL) return toWorld(frameAround(bsdf.coatNormal), w);
}

fn coatOut(bsdf: Bsdf, wo: vec3f) -> f32 {
  return 1.0 - coatFresnel(bsdf, abs(toCoat(bsdf, wo).z));
}

fn coatThrough(bsdf: Bsdf, wo: vec3f, wi: vec3f) -> f32 {
  return coatOut(bsdf, wo) * coatOut(bsdf, wi);
}

fn coatShare(bsdf: Bsdf, wo: vec3f) -> f32 {
  return select(0.0, coatFresnel(bsdf, toCoat(bsdf, wo).z), bsdf.coatAlpha > 0.0);
}

fn coatValue(bsdf: Bsdf, at: Directions) -> BsdfValue {
  let wo = toCoat(bsdf, at.wo);
  let wi = toCoat(bsdf, at.wi);
  if (bsdf.coatAlpha == 0.0 || wo.z <= LEAST_COSINE || wi.z <= LEAST_COSINE) { return BsdfValue(vec3f(0.0), 0.0); }
  let wm = normalize(wo + wi);
  let lobe = ggxD(wm, bsdf.coatAlpha) * ggxVisibility(wo.z, wi.z, bsdf.coatAlpha) * wi.z;
  return BsdfValue(vec3f(coatFresnel(bsdf, dot(wo, wm)) * lobe), ggxPdf(wo.z, wm, bsdf.coatAlpha));
}

fn coatDirection(bsdf: Bsdf, wo: vec3f, u: vec2f) -> vec3f {
  let own = toCoat(bsdf, wo);
  return fromCoat(bsdf, reflect(-own, ggxSample(own, bsdf.coatAlpha, u)));
}

fn coatExpect(bsdf: Bsdf, wo: vec3f, wi: vec3f, cosI: f32, size: f32) -> f32 {
  if (bsdf.coatAlpha == 0.0) { return 0.0; }
  let own = toCoat(bsdf, wo);
  let h = own + toCoat(bsdf, wi);
  let wm = normalize(select(vec3f(0.0, 0.0, 1.0), h, dot(h, h) > LEAST_COSINE));
  let alpha = sqrt(greater(bsdf.coatAlpha * bsdf.coatAlpha + 0.25 * size * size, LEAST_WIDTH2));
  return COAT_F0 * bsdf.clearcoat * ggxD(wm, alpha) * ggxVisibility(greater(own.z, LEAST_COSINE), cosI, alpha);
}

fn mirrorCoatShare(bsdf: Bsdf, wo: vec3f) -> f32 {
  return select(0.0, coatFresnel(bsdf, toCoat(bsdf, wo).z), bsdf.coatAlpha == 0.0);
}

fn mirrorCoatSample(bsdf: Bsdf, wo: vec3f, share: f32) -> BsdfSample {
  let own = toCoat(bsdf, wo);
  let wi = fromCoat(bsdf, vec3f(-own.xy, own.z));
  let possible = (wi.z > 0.0) & (own.z > 0.0) & (share > 0.0);
  let weight = coatFresnel(bsdf, own.z) / select(1.0, share, possible);
  return BsdfSample(wi, vec3f(select(0.0, weight, possible)), 0.0);
}
