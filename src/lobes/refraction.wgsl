// Refraction through a smooth interface: all of what it lets through in one direction. Radiance is not scaled by the square of the index
// of refraction: a path gains on its way into a solid what it loses on its way out.
//
// Directions are unit, in the local frame (z = n, on wo's side).
import package::lobes::fresnel::{luminance, refractedCos2, transmittanceAt};
import package::lobes::lobe::BsdfSample;
import package::scene::Bsdf;

fn refractionShare(bsdf: Bsdf, wo: vec3f) -> f32 {
  let isSmooth = (bsdf.eta > 0.0) & (bsdf.alpha == 0.0);
  return select(0.0, luminance(bsdf.transmitted) * transmittanceAt(bsdf, wo.z), isSmooth);
}

fn refractionSample(bsdf: Bsdf, wo: vec3f, share: f32) -> BsdfSample {
  let cos2 = refractedCos2(wo.z, bsdf.eta);
  if (!(share > 0.0) || cos2 <= 0.0) { return BsdfSample(vec3f(0.0, 0.0, 1.0), vec3f(0.0), 0.0); }
  let wi = normalize(vec3f(-wo.xy / bsdf.eta, -sqrt(cos2)));
  return BsdfSample(wi, bsdf.transmitted * (transmittanceAt(bsdf, wo.z) / share), 0.0);
}
