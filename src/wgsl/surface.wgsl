// What a ray finds where it hits.
import package::basis::{Frame, frameAround, toLocal};
import package::constants::{LEAST_COMPONENT, NONE};
import package::lights::sphere::sphereLightPdf;
import package::lobes::bsdf::{Bsdf, specularShare};
import package::lobes::multiscatter::multiscatterGain;
import package::minMax::greater;
import package::ray::{Hit, Ray};
import package::scene::{F0Of, factorsOf, alphaOf, diffuseOf, emissionOf, f0Of, f90Of, lightDensityOf, multiscatterOf, schlickBeckmannOf};
import package::shapes::mesh::consistentNormal;
import package::surfacePoint::{SurfacePoint, sourceAt, surfacePoint};
import package::textures::{colorAt, dataAt};

// Packed by compile/packScene.ts, one per primitive.
struct Material {
  F0: vec3f,
  alpha: f32,
  diffuse: vec3f,
  f0: f32,
  emission: vec3f,
  // Density of light sampling: per area on flat emitters, 1 on spheres; 0 if never sampled. Where there are many lights, times
  // the light's strength: to be multiplied by lightShareOf() and divided by the weight of all lights.
  lightDensity: f32,
  f90: f32,
  // 1 for the masking "schlick-beckmann", else 0.
  schlickBeckmann: f32,
  // Share of the light lost to multiple scattering that is given back: `metallic`, or 0 without the flag.
  multiscatter: f32,
}

struct Surface {
  p: vec3f,
  // n on the viewer's side.
  frame: Frame,
  // Of the surface itself, on the viewer's side, where n may be an interpolated one.
  @if(SHADING_NORMALS) ng: vec3f,
  // Towards the viewer, in the local frame.
  wo: vec3f,
  bsdf: Bsdf,
  // Radiance towards the viewer; only the front side emits.
  Le: vec3f,
  // Density, per steradian, with which light sampling at the ray's origin finds this point, but for the choice of light.
  lightPdf: f32,
  // What a ray that leaves from here names as its source.
  source: u32,
}

fn surfaceAt(ray: Ray, hit: Hit) -> Surface {
  let found = surfacePoint(ray, hit);
  var surface: Surface;
  surface.p = found.p;
  var n = select(-found.n, found.n, found.front);
  @if(MESHES) surface.p += found.clearance * n;
  @if(SHADING_NORMALS) {
    surface.ng = n;
    let shading = select(-found.shading, found.shading, found.front);
    n = select(n, consistentNormal(shading, n, -ray.d), found.isTriangle);
  }
  surface.frame = frameAround(n);
  surface.wo = toLocal(surface.frame, -ray.d);
  var uv = vec2f(0.0);
  @if(TEXTURES) uv = found.uv;
  surface.bsdf = bsdfOf(found.id, surface.wo.z, uv);
  @if(EMISSION) {
    surface.Le = select(vec3f(0.0), emissionOf(found.id), found.front);
    @if(EMISSION_TEXTURES) surface.Le *= colorAt(factorsOf(found.id).emissionTexture, uv);
    surface.lightPdf = lightPdf(lightDensityOf(found.id), ray, hit.t, found);
  }
  surface.source = sourceAt(found, hit);
  return surface;
}

// How a primitive scatters, seen under cosO, at texture coordinates. Reads only what the scene's materials make use of: every
// field costs a gather.
fn bsdfOf(id: u32, cosO: f32, uv: vec2f) -> Bsdf {
  var bsdf: Bsdf;
  @if(DIFFUSE) bsdf.diffuse = diffuseOf(id);
  @if(SPECULAR) {
    bsdf.F0 = F0Of(id);
    bsdf.f0 = f0Of(id);
    bsdf.f90 = f90Of(id);
    bsdf.alpha = alphaOf(id);
  }
  @if(MULTISCATTER) var multiscatter = multiscatterOf(id);
  @if(SURFACE_TEXTURES) {
    let factors = factorsOf(id);
    let base = factors.baseColor * colorAt(factors.baseColorTexture, uv);
    let data = dataAt(factors.metallicRoughnessTexture, uv);
    let metallic = factors.metallic * data.b;
    let roughness = factors.roughness * data.g;
    @if(DIFFUSE) bsdf.diffuse = (1.0 - metallic) * base;
    @if(SPECULAR) {
      let isTextured = min(factors.baseColorTexture, factors.metallicRoughnessTexture) != NONE;
      bsdf.F0 = select(bsdf.F0, mix(vec3f(bsdf.f0), base, metallic), isTextured);
      // A texture makes no perfect mirrors: α stays at what compile/features.ts takes for one.
      bsdf.alpha = select(bsdf.alpha, max(roughness * roughness, 0x1p-24), isTextured);
    }
    @if(MULTISCATTER) multiscatter *= data.b;
  }
  @if(SMITH && SCHLICK_BECKMANN) bsdf.schlickBeckmann = schlickBeckmannOf(id);
  @if(MULTISCATTER) bsdf.gain = multiscatterGain(cosO, bsdf.alpha, bsdf.F0 * multiscatter);
  bsdf.specularShare = specularShare(bsdf, cosO);
  return bsdf;
}

@if(EMISSION)
fn lightPdf(density: f32, ray: Ray, t: f32, found: SurfacePoint) -> f32 {
  let flat = density * t * t / greater(abs(dot(ray.d, found.n)), LEAST_COMPONENT);
  @if(!EMISSIVE_BALLS) return flat;
  @if(EMISSIVE_BALLS) {
    let ball = found.shape;
    return select(flat, density * sphereLightPdf(ray.o, ball.xyz, ball.w), ball.w > 0.0);
  }
}
