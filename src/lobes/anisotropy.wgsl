// GGX microfacets that are stretched: α along t of the local frame is greater than across it.
//
// [1] Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces"
// [2] Heitz 2014, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", JCGT 3(2)
// [3] Dupuy, Benyoub 2023, "Sampling Visible GGX Normals with Spherical Caps"
import package::constants::{LEAST_COMPONENT, PI};
import package::directions::circle;
import package::minMax::greater;
import package::scene::Bsdf;

// α along t and b.
fn alphasOf(bsdf: Bsdf) -> vec2f {
  return vec2f(bsdf.alphaAlong, bsdf.alpha);
}

// Density of microfacet normals, per steradian. [2] eq. 85
fn stretchedD(wm: vec3f, alphas: vec2f) -> f32 {
  let a2 = alphas.x * alphas.y;
  let ratio = alphas.y / alphas.x;
  let d = ratio * wm.x * wm.x + wm.y * wm.y / ratio + a2 * wm.z * wm.z;
  return a2 / (PI * d * d);
}

// cos·(1 + 2Λ). [2] eq. 72, 80
fn stretchedSlope(w: vec3f, alphas: vec2f) -> f32 {
  let sides = alphas * w.xy;
  return sqrt(w.z * w.z + dot(sides, sides));
}

// A microfacet normal visible from wo. [3] listing 3
fn stretchedSample(wo: vec3f, alphas: vec2f, u: vec2f) -> vec3f {
  let stretched = normalize(vec3f(alphas * wo.xy, wo.z));
  let z = (1.0 - u.y) * (1.0 + stretched.z) - stretched.z;
  let cap = vec3f(sqrt(greater(1.0 - z * z, 0.0)) * circle(u.x), z) + stretched;
  return normalize(vec3f(alphas * cap.xy, greater(cap.z, LEAST_COMPONENT)));
}
