// A perfect mirror: all of the interface's light in one direction.
//
// Directions are unit, in the local frame (z = n, on wo's side).
import package::lobes::fresnel::{fresnelShare, reflectanceAt, schlickFresnel, schlickWeight};
import package::lobes::lobe::BsdfSample;
import package::scene::Bsdf;

fn mirrorShare(bsdf: Bsdf, wo: vec3f) -> f32 {
  return select(0.0, fresnelShare(bsdf, wo), bsdf.alpha == 0.0);
}

fn mirrorSample(bsdf: Bsdf, wo: vec3f, share: f32) -> BsdfSample {
  @if(!EXACT_FRESNEL) return BsdfSample(vec3f(-wo.xy, wo.z), schlickFresnel(bsdf, schlickWeight(wo.z)) / share, 0.0);
  @if(EXACT_FRESNEL) return BsdfSample(vec3f(-wo.xy, wo.z), reflectanceAt(bsdf, wo.z) / share, 0.0);
}
