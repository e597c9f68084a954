// Lambert's law on the other side of the surface: light that is scattered on its way through.
//
// Directions are unit, in the local frame (z = n, on wo's side). wo points to the viewer, wi to the light.
import package::constants::INV_PI;
import package::directions::cosineHemisphere;
import package::lobes::fresnel::{luminance, transmittance, transmittanceAt};
import package::lobes::lobe::{BsdfValue, Directions};
import package::minMax::greater;
import package::scene::Bsdf;

fn translucentShare(bsdf: Bsdf, wo: vec3f) -> f32 {
  @if(!SPECULAR) return luminance(bsdf.translucent);
  @if(SPECULAR) return luminance(bsdf.translucent) * transmittanceAt(bsdf, wo.z);
}

fn translucentValue(bsdf: Bsdf, at: Directions) -> BsdfValue {
  let pdf = greater(-at.wi.z, 0.0) * INV_PI;
  @if(!SPECULAR) return BsdfValue(bsdf.translucent * pdf, pdf);
  @if(SPECULAR && !EXACT_FRESNEL) return BsdfValue(bsdf.translucent * (transmittance(bsdf, at.schlick) * pdf), pdf);
  @if(EXACT_FRESNEL) return BsdfValue(bsdf.translucent * (at.through * pdf), pdf);
}

fn translucentDirection(u: vec2f) -> vec3f {
  let wi = cosineHemisphere(u);
  return vec3f(wi.xy, -wi.z);
}

fn translucentExpect(bsdf: Bsdf) -> f32 {
  return luminance(bsdf.translucent) * INV_PI;
}
