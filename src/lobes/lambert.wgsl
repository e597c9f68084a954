// Lambert's law, under an interface or without one.
//
// Directions are unit, in the local frame (z = n, on wo's side). wo points to the viewer, wi to the light.
import package::constants::INV_PI;
import package::directions::cosineHemisphere;
import package::lobes::fresnel::{luminance, schlickWeight, transmittance, transmittanceAt};
import package::lobes::lobe::{BsdfSample, BsdfValue, Directions};
import package::minMax::greater;
import package::scene::Bsdf;

fn lambertShare(bsdf: Bsdf, wo: vec3f) -> f32 {
  @if(!SPECULAR) return luminance(bsdf.diffuse);
  @if(SPECULAR && !EXACT_FRESNEL) return luminance(bsdf.diffuse) * transmittance(bsdf, schlickWeight(wo.z));
  @if(EXACT_FRESNEL) return luminance(bsdf.diffuse) * transmittanceAt(bsdf, wo.z);
}

fn lambertValue(bsdf: Bsdf, at: Directions) -> BsdfValue {
  let pdf = greater(at.wi.z, 0.0) * INV_PI;
  @if(!SPECULAR) return BsdfValue(bsdf.diffuse * pdf, pdf);
  @if(SPECULAR && !EXACT_FRESNEL) return BsdfValue(bsdf.diffuse * (transmittance(bsdf, at.schlick) * pdf), pdf);
  @if(EXACT_FRESNEL) return BsdfValue(bsdf.diffuse * (at.through * pdf), pdf);
}

fn lambertSample(bsdf: Bsdf, u: vec2f) -> BsdfSample {
  let wi = cosineHemisphere(u);
  return BsdfSample(wi, bsdf.diffuse, wi.z * INV_PI);
}

fn lambertExpect(bsdf: Bsdf) -> f32 {
  return luminance(bsdf.diffuse) * INV_PI;
}
