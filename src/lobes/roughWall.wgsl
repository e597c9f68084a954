// A thin wall of microfacets: what it lets through leaves on the other side as it would be reflected on this one.
// KHR_materials_transmission
//
// Directions are unit, in the local frame (z = n, on wo's side); wi is below the surface. alpha > 0.
import package::lobes::fresnel::{luminance, transmittance, transmittanceAt};
import package::lobes::ggx::{ggxExpect, microfacetD, microfacetSample, microfacetSlope};
import package::lobes::lobe::{BsdfValue, Directions};
import package::scene::Bsdf;

fn isRoughWall(bsdf: Bsdf) -> bool {
  return (bsdf.isWall > 0.0) & (bsdf.alpha > 0.0);
}

fn roughWallShare(bsdf: Bsdf, wo: vec3f) -> f32 {
  return select(0.0, luminance(bsdf.transmitted) * transmittanceAt(bsdf, wo.z), isRoughWall(bsdf));
}

fn roughWallValue(bsdf: Bsdf, at: Directions) -> BsdfValue {
  let cosI = -at.wi.z;
  @if(!EXACT_FRESNEL) let through = transmittance(bsdf, at.schlick);
  @if(EXACT_FRESNEL) let through = at.through;
  let D = microfacetD(bsdf, at.wm);
  let slopeO = microfacetSlope(bsdf, at.wo);
  let visibility = 0.5 / (cosI * slopeO + at.wo.z * microfacetSlope(bsdf, vec3f(at.wi.xy, cosI)));
  let value = through * D * visibility * cosI;
  let pdf = D * 0.5 / (at.wo.z + slopeO);
  return BsdfValue(select(vec3f(0.0), bsdf.transmitted * value, isRoughWall(bsdf)), select(0.0, pdf, isRoughWall(bsdf)));
}

fn roughWallDirection(bsdf: Bsdf, wo: vec3f, u: vec2f) -> vec3f {
  if (!isRoughWall(bsdf)) { return vec3f(0.0); }
  let wi = reflect(-wo, microfacetSample(bsdf, wo, u));
  return vec3f(wi.xy, -wi.z);
}

// As of a lobe that reflects what this one lets through.
fn roughWallExpect(bsdf: Bsdf, wo: vec3f, wi: vec3f, cosI: f32, size: f32) -> f32 {
  if (!isRoughWall(bsdf)) { return 0.0; }
  var mirrored = bsdf;
  mirrored.F0 = bsdf.transmitted;
  return ggxExpect(mirrored, wo, vec3f(wi.xy, abs(wi.z)), cosI, size);
}
