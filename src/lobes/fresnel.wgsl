// How much an interface reflects: by Schlick's approximation, and exactly where light gets into a solid.
//
// [1] Schlick 1994, "An Inexpensive BRDF Model for Physically-based Rendering", eq. 15
// [2] Born, Wolf 1999, "Principles of Optics", 7th ed., section 1.5.2
import package::lobes::ggx::ggxSlope;
import package::lobes::iridescence::filmReflectance;
import package::minMax::{greater, greatest};
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

// What the interface lets through to what is below it, by Schlick's weight.
@if(SPECULAR && !TINTED)
fn transmittance(bsdf: Bsdf, schlick: f32) -> f32 {
  return 1.0 - bsdf.f0 - (bsdf.f90 - bsdf.f0) * schlick;
}

@if(TINTED)
fn transmittance(bsdf: Bsdf, schlick: f32) -> f32 {
  return 1.0 - bsdf.f0 - (bsdf.dielectricF90 - bsdf.f0) * schlick;
}

// What an interface does to light, where that is not Schlick's alone.
struct Interface {
  // Reflectance.
  F: vec3f,
  // What it lets through to what is below it.
  through: f32,
}

@if(EXACT_FRESNEL)
fn interfaceAt(bsdf: Bsdf, cosTheta: f32) -> Interface {
  var weight = schlickWeight(cosTheta);
  @if(REFRACTIVE) {
    if (bsdf.eta > 0.0) { weight = dielectricWeight(cosTheta, bsdf.eta); }
  }
  var result = Interface(schlickFresnel(bsdf, weight), transmittance(bsdf, weight));
  // Dielectrics reflect less under some angle than at normal incidence: the weight may be negative, by rounding or for an ior above 3.7.
  @if(TINTED) result.F = max(result.F, vec3f(0.0));
  @if(IRIDESCENCE) {
    if (bsdf.iridescence > 0.0) {
      var above = cosTheta;
      @if(REFRACTIVE) {
        // A film reflects as much from within a solid: all of it, where the solid's interface does.
        if (bsdf.eta > 0.0 && !package::surface::seesFront) { above = sqrt(greater(refractedCos2(cosTheta, bsdf.eta), 0.0)); }
      }
      let film = filmReflectance(above, bsdf.filmIor, bsdf.filmThickness, bsdf.F0);
      result.F = mix(result.F, film, bsdf.iridescence);
      result.through = mix(result.through, 1.0 - greatest(film), bsdf.iridescence);
    }
  }
  return result;
}

@if(SPECULAR)
fn reflectanceAt(bsdf: Bsdf, cosTheta: f32) -> vec3f {
  @if(!EXACT_FRESNEL) return schlickFresnel(bsdf, schlickWeight(cosTheta));
  @if(EXACT_FRESNEL) return interfaceAt(bsdf, cosTheta).F;
}

@if(SPECULAR)
fn transmittanceAt(bsdf: Bsdf, cosTheta: f32) -> f32 {
  @if(!EXACT_FRESNEL) return transmittance(bsdf, schlickWeight(cosTheta));
  @if(EXACT_FRESNEL) return interfaceAt(bsdf, cosTheta).through;
}

// In place of Schlick's weight the one that makes the reflectance of a solid what it is; 1 for total reflection.
fn dielectricWeight(cosTheta: f32, eta: f32) -> f32 {
  let ratio = (eta - 1.0) / (eta + 1.0);
  let f0 = ratio * ratio;
  return (dielectricFresnel(cosTheta, eta) - f0) / (1.0 - f0);
}

// Reflectance of a smooth dielectric for unpolarised light; eta is the index of refraction beyond relative to the one before. [2]
fn dielectricFresnel(cosI: f32, eta: f32) -> f32 {
  let cos2T = refractedCos2(cosI, eta);
  if (cos2T <= 0.0) { return 1.0; }
  let cosT = sqrt(cos2T);
  let parallel = (eta * cosI - cosT) / (eta * cosI + cosT);
  let across = (cosI - eta * cosT) / (cosI + eta * cosT);
  return 0.5 * (parallel * parallel + across * across);
}

// The square of the refracted direction's cosine; not positive for total reflection. Snell's law
fn refractedCos2(cosI: f32, eta: f32) -> f32 {
  // 1 − (1 − cos²) / eta², so that eta = 1 leaves cos² as it is.
  let inverse = 1.0 / eta;
  return (1.0 - inverse) * (1.0 + inverse) + cosI * cosI * inverse * inverse;
}

// About the cosine under which the viewer sees the microfacets: at grazing angles those that he sees are turned towards him.
@if(EXACT_FRESNEL)
fn expectedCosine(bsdf: Bsdf, wo: vec3f) -> f32 {
  return ggxSlope(wo.z, bsdf.alpha);
}

// The luminance that the interface is expected to reflect.
@if(SPECULAR)
fn fresnelShare(bsdf: Bsdf, wo: vec3f) -> f32 {
  @if(!EXACT_FRESNEL) return luminance(schlickFresnel(bsdf, schlickWeight(wo.z)));
  @if(EXACT_FRESNEL) return luminance(reflectanceAt(bsdf, expectedCosine(bsdf, wo)));
}

fn luminance(c: vec3f) -> f32 {
  return dot(c, vec3f(0.2126, 0.7152, 0.0722));
}
