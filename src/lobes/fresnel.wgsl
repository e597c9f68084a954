// How much an interface reflects, by Schlick's approximation.
//
// [1] Schlick 1994, "An Inexpensive BRDF Model for Physically-based Rendering", eq. 15
import package::minMax::greater;
import package::scene::Bsdf;

// Microfacets of a smaller α are a mirror: see fresnel.ts.
const LEAST_ALPHA = 0x1p-24;

// (1 − cos)⁵
fn schlickWeight(cosTheta: f32) -> f32 {
  let m = greater(1.0 - cosTheta, 0.0);
  let m2 = m * m;
  return m2 * m2 * m;
}

// Reflectance of the interface, by Schlick's weight.
@if(SPECULAR)
fn schlickFresnel(bsdf: Bsdf, schlick: f32) -> vec3f {
  return bsdf.F0 + (bsdf.f90 - bsdf.F0) * schlick;
}

// The luminance that the interface is expected to reflect.
@if(SPECULAR)
fn fresnelShare(bsdf: Bsdf, wo: vec3f) -> f32 {
  return luminance(schlickFresnel(bsdf, schlickWeight(wo.z)));
}

fn luminance(c: vec3f) -> f32 {
  return dot(c, vec3f(0.2126, 0.7152, 0.0722));
}
