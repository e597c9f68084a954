// The reflectance of an interface with a thin film on it, by Airy summation over the paths in the film, integrated over the spectrum by
// Gaussians that fit the sensitivities of the eye; as KHR_materials_iridescence has it.
//
// [1] Belcour, Barla 2017, "A Practical Extension to Microfacet Theory for the Modeling of Varying Iridescence", ACM TOG 36(4)
import package::constants::PI;
import package::lobes::fresnel::schlickWeight;
import package::minMax::{greater, lesser};
import package::scene::Bsdf;

// Of the thickness's texture.
@if(FILM_TEXTURES)
fn filmThickness(bsdf: Bsdf, share: f32) -> f32 {
  return mix(bsdf.thinnestFilm, bsdf.filmThickness, share);
}

// Films thinner than this, in nanometres, fade out: so thin a film has no ior of its own.
const THIN = 30.0;

// A dielectric of a reflectance at normal incidence of 1 has no ior; the most that is taken for it.
const MOST_F0 = 0.9999;

fn filmReflectance(cosTheta: f32, filmIor: f32, thickness: f32, F0: vec3f) -> vec3f {
  let ior = mix(1.0, filmIor, smoothstep(0.0, THIN, thickness));
  let cos2 = 1.0 - (1.0 - cosTheta * cosTheta) / (ior * ior);
  if (cos2 < 0.0) { return vec3f(1.0); }
  let cosFilm = sqrt(cos2);

  // The film's upper and lower interfaces.
  let ratio = (ior - 1.0) / (ior + 1.0);
  let R12 = mix(schlickWeight(cosTheta), 1.0, ratio * ratio);
  let root = sqrt(min(F0, vec3f(MOST_F0)));
  let base = (1.0 + root) / (1.0 - root);
  let ratios = (base - ior) / (base + ior);
  let R23 = mix(vec3f(schlickWeight(cosFilm)), vec3f(1.0), ratios * ratios);
  // How far reflections at the two interfaces turn the phase, relative to one that goes no further than the film.
  let turn = PI + select(vec3f(0.0), vec3f(PI), base < vec3f(ior));

  // [1] eq. 10: what does not interfere, and the first two orders of what does.
  let path = 2.0 * ior * thickness * cosFilm;
  let both = clamp(R12 * R23, vec3f(1e-5), vec3f(MOST_F0));
  let T121 = 1.0 - R12;
  let Rs = T121 * T121 * R23 / (1.0 - both);
  let first = (Rs - T121) * sqrt(both);
  let second = first * sqrt(both);
  let sum = R12 + Rs + 2.0 * first * sensitivity(path, turn) + 2.0 * second * sensitivity(2.0 * path, 2.0 * turn);
  return clamp(sum, vec3f(0.0), vec3f(1.0));
}

// The Fourier transform of the eye's sensitivities at an optical path difference in nanometres, as linear Rec. 709. [1] section 4
fn sensitivity(path: f32, turn: vec3f) -> vec3f {
  let phase = 2.0 * PI * path * 1e-9;
  let value = vec3f(5.4856e-13, 4.4201e-13, 5.2481e-13);
  let place = vec3f(1.6810e6, 1.7953e6, 2.2084e6);
  let variance = vec3f(4.3278e9, 9.3046e9, 6.6121e9);
  var xyz = value * sqrt(2.0 * PI * variance) * cos(place * phase + turn) * exp(-phase * phase * variance);
  // Red has a second hump.
  xyz.x += 9.7470e-14 * sqrt(2.0 * PI * 4.5282e9) * cos(2.2399e6 * phase + turn.x) * exp(-4.5282e9 * phase * phase);
  let toRec709 = mat3x3f(
    3.2404542, -0.9692660, 0.0556434,
    -1.5371385, 1.8760108, -0.2040259,
    -0.4985314, 0.0415560, 1.0572252,
  );
  return toRec709 * (xyz / 1.0685e-7);
}
