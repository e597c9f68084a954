// What a ray finds where it hits.
//
// [1] Hanika 2021, "Hacking the Shadow Terminator", Ray Tracing Gems II ch. 4
import package::basis::{Frame, frameAlong, frameAround, toLocal};
import package::constants::{LEAST_COMPONENT, NONE};
import package::coverage::oddsOf;
import package::lights::sphere::sphereLightPdf;
import package::lobes::clearcoat::coatOut;
import package::lobes::fresnel::LEAST_ALPHA;
import package::lobes::iridescence::filmThickness;
import package::minMax::greater;
import package::ray::{Hit, Ray, makeRay};
import package::scene::{Bsdf, doubleSidedOf, emissionOf, factorsOf, lightDensityOf, materialOf, seenFrom, textured, unlitOf};
import package::shapes::mesh::consistentNormal;
import package::surfacePoint::{SurfacePoint, otherSourceAt, sourceAt, surfacePoint};
import package::textures::{colorAt, dataAt};
import package::stretch::stretchAlong;
import package::uvs::Uvs;

// Cosine of the angle from which on rays start on the smooth surface: Cycles' default.
const TERMINATOR = 0.1;

struct Surface {
  p: vec3f,
  // n on the viewer's side.
  frame: Frame,
  // Of the surface itself, on the viewer's side, where n may be an interpolated one.
  @if(SHADING_NORMALS) ng: vec3f,
  // Of the smooth surface that a mesh stands for, likewise, where textures bend n; and the way there.
  @if(SMOOTH && NORMAL_TEXTURES) smoothN: vec3f,
  @if(SMOOTH) lift: vec3f,
  // Towards the viewer, in the local frame.
  wo: vec3f,
  bsdf: Bsdf,
  // Radiance towards the viewer.
  Le: vec3f,
  // Density, per steradian, with which light sampling at the ray's origin finds this point, but for the choice of light.
  lightPdf: f32,
  // What a ray that leaves from here names as its source.
  source: u32,
  // Where one starts that leaves on the other side, and its source.
  @if(BELOW) below: vec3f,
  @if(BELOW) otherSource: u32,
  // Whether the viewer sees the front.
  @if(ABSORPTION || DISPERSION) front: bool,
  // The primitive.
  @if(ABSORPTION || DISPERSION) id: u32,
  // What a path that met this counts for: 1, or more where others have passed.
  @if(CLEAR_WALLS) odds: f32,
}

fn surfaceAt(ray: Ray, hit: Hit) -> Surface {
  let found = surfacePoint(ray, hit);
  var surface: Surface;
  surface.p = found.p;
  var n = select(-found.n, found.n, found.front);
  @if(MESHES) surface.p += found.clearance * n;
  @if(BELOW && !MESHES) surface.below = found.p;
  @if(BELOW && MESHES) surface.below = found.p - found.clearance * n;
  @if(SHADING_NORMALS) {
    surface.ng = n;
    @if(SMOOTH && NORMAL_TEXTURES) surface.smoothN = select(-found.smoothN, found.smoothN, found.front);
    @if(SMOOTH) surface.lift = found.lift;
    let shading = select(-found.shading, found.shading, found.front);
    n = select(n, consistentNormal(shading, n, -ray.d), found.isTriangle);
  }
  @if(!ANISOTROPY) surface.frame = frameAround(n);
  @if(ANISOTROPY) surface.frame = frameAlong(stretchAlong(found), n);
  surface.wo = toLocal(surface.frame, -ray.d);
  var uv = Uvs(0.0);
  @if(TEXTURES) uv = found.uv;
  var color = vec3f(1.0);
  @if(COLORS) color = found.color.rgb;
  @if(REFRACTIVE) seesFront = found.front;
  @if(COAT_NORMAL) {
    let side = select(-1.0, 1.0, found.front);
    coatNormal = toLocal(surface.frame, consistentNormal(side * found.coatN, side * found.n, -ray.d));
  }
  surface.bsdf = bsdfOf(found.id, surface.wo, uv, color);
  @if(EMISSION) {
    @if(!DOUBLE_SIDED) surface.Le = select(vec3f(0.0), emissionOf(found.id), found.front);
    @if(DOUBLE_SIDED) surface.Le = select(vec3f(0.0), emissionOf(found.id), found.front || doubleSidedOf(found.id) > 0.0);
    @if(UNLIT_COLORS) surface.Le *= select(vec3f(1.0), found.color.rgb, unlitOf(found.id) > 0.0);
    @if(EMISSION_TEXTURES) surface.Le *= colorAt(factorsOf(found.id).emissionTexture, uv);
    @if(COAT) surface.Le *= coatOut(surface.bsdf, surface.wo);
    surface.lightPdf = lightPdf(lightDensityOf(found.id), ray, hit.t, found);
  }
  surface.source = sourceAt(found, hit);
  @if(BELOW) surface.otherSource = otherSourceAt(found, hit);
  @if(ABSORPTION || DISPERSION) surface.front = found.front;
  @if(ABSORPTION || DISPERSION) surface.id = found.id;
  @if(CLEAR_WALLS) surface.odds = oddsOf(ray, found);
  return surface;
}

// A ray that leaves a surface. From a mesh with normals it starts on the smooth surface that the mesh stands for, where the triangle
// would cut it off, as in Cycles: or else the boundary of light would be one of triangles. Blended in with the angle at which the
// triangle and the smooth surface end. [1]
fn leave(surface: Surface, wi: vec3f) -> Ray {
  @if(BELOW) {
    if (dot(surface.frame.n, wi) < 0.0) { return makeRay(surface.below, wi, surface.otherSource); }
  }
  @if(!SMOOTH) return makeRay(surface.p, wi, surface.source);
  @if(SMOOTH) {
    let flat = dot(surface.ng, wi);
    @if(NORMAL_TEXTURES) let smooth_ = dot(surface.smoothN, wi);
    @if(!NORMAL_TEXTURES) let smooth_ = dot(surface.frame.n, wi);
    let near = clamp(1.0 - flat / TERMINATOR, 0.0, 1.0);
    let amount = select(near, clamp(2.0 - (flat + smooth_) / TERMINATOR, 0.0, 1.0), smooth_ < TERMINATOR);
    // Below the triangle's horizon the triangle itself may be in the way. Where there is one horizon only, rounding alone puts wi below.
    let isAbove = flat > 0.0 || flat == smooth_;
    return makeRay(surface.p + amount * surface.lift, wi, select(NONE, surface.source, isAbove));
  }
}

// Whether a direction leaves a surface on the viewer's side, whatever the normal that it is shaded with; or on the other side, where
// that is the side it is meant to leave on.
@if(SHADING_NORMALS)
fn leaves(surface: Surface, wi: vec3f) -> bool {
  @if(BELOW) {
    if (dot(surface.frame.n, wi) < 0.0) { return dot(surface.ng, wi) < 0.0; }
  }
  @if(!SMOOTH) return dot(wi, surface.ng) > 0.0;
  @if(SMOOTH && NORMAL_TEXTURES) return dot(wi, surface.smoothN) > 0.0;
  @if(SMOOTH && !NORMAL_TEXTURES) return true; // no lobe sends light below n
}

// What the next bsdfOf() is asked for: which side of a solid; how far the path's colour is from the middle of the spectrum; the normal of
// a clear coat, in the local frame.
@if(REFRACTIVE)
var<private> seesFront: bool = true;
@if(DISPERSION)
var<private> spectralShift: f32;
@if(COAT_NORMAL)
var<private> coatNormal: vec3f = vec3f(0.0, 0.0, 1.0);

// The index of refraction below a surface relative to the one above, on the side that is seen.
@if(REFRACTIVE)
fn etaSeen(bsdf: Bsdf) -> f32 {
  @if(!DISPERSION) let eta = bsdf.eta;
  @if(DISPERSION) let eta = bsdf.eta + spectralShift * bsdf.spread;
  return select(eta, 1.0 / eta, !seesFront && eta > 0.0);
}

// How a primitive scatters towards the viewer, at texture coordinates and with the colour of its vertices.
fn bsdfOf(id: u32, wo: vec3f, uv: Uvs, color: vec3f) -> Bsdf {
  var material = materialOf(id);
  @if(SURFACE_TEXTURES || LOBE_TEXTURES || COLORS) {
    let factors = factorsOf(id);
    var base = factors.baseColor * color;
    var data = vec3f(1.0);
    @if(SURFACE_TEXTURES) base *= colorAt(factors.baseColorTexture, uv);
    @if(SURFACE_TEXTURES) data = dataAt(factors.metallicRoughnessTexture, uv);
    let metallic = factors.metallic * data.b;
    let roughness = factors.roughness * data.g;
    @if(DIFFUSE || TRANSMISSION) material.diffuse = (1.0 - metallic) * base;
    @if(LOBE_TEXTURES) material = textured(material, factors, uv);
    @if(SPECULAR) {
      var isTextured = min(factors.baseColorTexture, factors.metallicRoughnessTexture) != NONE;
      @if(COLORS) isTextured |= any(color != vec3f(1.0));
      @if(SPECULAR_TEXTURES) {
        isTextured |= min(factors.specularTexture, factors.specularColorTexture) != NONE;
        material.specularF0 = min(material.specularF0, vec3f(1.0)) * material.dielectricF90;
        material.f0 = max(max(material.specularF0.r, material.specularF0.g), material.specularF0.b);
        material.f90 = mix(material.dielectricF90, 1.0, metallic);
      }
      @if(!TINTED) material.F0 = select(material.F0, mix(vec3f(material.f0), base, metallic), isTextured);
      @if(TINTED && !SPECULAR_TEXTURES) material.specularF0 = min(material.specularF0, vec3f(1.0)) * material.dielectricF90;
      @if(TINTED) material.F0 = select(material.F0, mix(material.specularF0, base, metallic), isTextured);
      // A texture makes no perfect mirrors, nor takes any away: a scene's lobes do not depend on texels.
      material.alpha = select(material.alpha, max(roughness * roughness, LEAST_ALPHA), isTextured && material.alpha > 0.0);
    }
    @if(MULTISCATTER) material.multiscatter *= data.b;
    @if(FILM_TEXTURES) material.filmThickness = filmThickness(material, dataAt(factors.iridescenceThicknessTexture, uv).g);
    @if(TRANSLUCENT) material.translucent *= (1.0 - metallic) / greater(1.0 - factors.metallic, LEAST_COMPONENT);
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
