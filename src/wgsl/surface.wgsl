// What a ray finds where it hits.
import package::basis::{Frame, frameAround, toLocal};
import package::constants::{LEAST_COMPONENT, NONE};
import package::lights::sphere::sphereLightPdf;
import package::lobes::fresnel::LEAST_ALPHA;
import package::minMax::greater;
import package::ray::{Hit, Ray};
import package::scene::{Bsdf, doubleSidedOf, emissionOf, factorsOf, lightDensityOf, materialOf, seenFrom, unlitOf};
import package::shapes::mesh::consistentNormal;
import package::surfacePoint::{SurfacePoint, sourceAt, surfacePoint};
import package::textures::{colorAt, dataAt};

struct Surface {
  p: vec3f,
  // n on the viewer's side.
  frame: Frame,
  // Of the surface itself, on the viewer's side, where n may be an interpolated one.
  @if(SHADING_NORMALS) ng: vec3f,
  // Towards the viewer, in the local frame.
  wo: vec3f,
  bsdf: Bsdf,
  // Radiance towards the viewer.
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
  var color = vec3f(1.0);
  @if(COLORS) color = found.color.rgb;
  surface.bsdf = bsdfOf(found.id, surface.wo, uv, color);
  @if(EMISSION) {
    @if(!DOUBLE_SIDED) surface.Le = select(vec3f(0.0), emissionOf(found.id), found.front);
    @if(DOUBLE_SIDED) surface.Le = select(vec3f(0.0), emissionOf(found.id), found.front || doubleSidedOf(found.id) > 0.0);
    @if(UNLIT_COLORS) surface.Le *= select(vec3f(1.0), found.color.rgb, unlitOf(found.id) > 0.0);
    @if(EMISSION_TEXTURES) surface.Le *= colorAt(factorsOf(found.id).emissionTexture, uv);
    surface.lightPdf = lightPdf(lightDensityOf(found.id), ray, hit.t, found);
  }
  surface.source = sourceAt(found, hit);
  return surface;
}

// How a primitive scatters towards the viewer, at texture coordinates and with the colour of its vertices.
fn bsdfOf(id: u32, wo: vec3f, uv: vec2f, color: vec3f) -> Bsdf {
  var material = materialOf(id);
  @if(SURFACE_TEXTURES || COLORS) {
    let factors = factorsOf(id);
    var base = factors.baseColor * color;
    var data = vec3f(1.0);
    @if(SURFACE_TEXTURES) base *= colorAt(factors.baseColorTexture, uv);
    @if(SURFACE_TEXTURES) data = dataAt(factors.metallicRoughnessTexture, uv);
    let metallic = factors.metallic * data.b;
    let roughness = factors.roughness * data.g;
    @if(DIFFUSE) material.diffuse = (1.0 - metallic) * base;
    @if(SPECULAR) {
      var isTextured = min(factors.baseColorTexture, factors.metallicRoughnessTexture) != NONE;
      @if(COLORS) isTextured |= any(color != vec3f(1.0));
      material.F0 = select(material.F0, mix(vec3f(material.f0), base, metallic), isTextured);
      // A texture makes no perfect mirrors, nor takes any away: a scene's lobes do not depend on texels.
      material.alpha = select(material.alpha, max(roughness * roughness, LEAST_ALPHA), isTextured && material.alpha > 0.0);
    }
    @if(MULTISCATTER) material.multiscatter *= data.b;
  }
  return seenFrom(material, wo);
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
