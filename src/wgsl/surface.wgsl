// What a ray finds where it hits.
import package::bsdf::{Bsdf, specularShare};
import package::constants::{INSIDE};
import package::frame::{Frame, frameAround, toLocal};
import package::lights::sphereLightPdf;
import package::ray::{Hit, Ray};
import package::scene::{material, shapeNormal, shapeOf};

// Packed by compile/packScene.ts, one per primitive.
struct Material {
  F0: vec3f,
  alpha: f32,
  diffuse: vec3f,
  f0: f32,
  emission: vec3f,
  // Density of light sampling: per area on flat emitters, of the choice of light on spheres; 0 if never sampled.
  lightDensity: f32,
  f90: f32,
  // 1 for the masking "schlick-beckmann", else 0.
  schlickBeckmann: f32,
}

struct Surface {
  p: vec3f,
  // n on the viewer's side.
  frame: Frame,
  // Towards the viewer, in the local frame.
  wo: vec3f,
  bsdf: Bsdf,
  // Radiance towards the viewer; only the front side emits.
  Le: vec3f,
  // Density, per steradian, with which light sampling at the ray's origin finds this point.
  lightPdf: f32,
  // What a ray that leaves from here names as its source.
  source: u32,
}

fn surfaceAt(ray: Ray, hit: Hit) -> Surface {
  let shape = shapeOf(hit.id);
  let found = material(hit.id);
  var p = ray.o + hit.t * ray.d;
  var n = shape.xyz;
  @if(SPHERES) {
    // Back onto the sphere: the point is then as exact as the radius, however far the ray came.
    let isSphere = shape.w > 0.0;
    let radial = normalize(select(n, p - shape.xyz, isSphere));
    p = select(p, shape.xyz + shape.w * radial, isSphere);
    n = radial;
  }
  @if(BOXES) n = shapeNormal(hit.id, p, n);
  let cosine = -dot(ray.d, n);
  let front = cosine > 0.0;

  var surface: Surface;
  surface.p = p;
  surface.frame = frameAround(select(-n, n, front));
  surface.wo = toLocal(surface.frame, -ray.d);
  surface.bsdf = Bsdf(found.diffuse, found.F0, found.f0, found.f90, found.alpha, found.schlickBeckmann, 0.0);
  surface.bsdf.specularShare = specularShare(surface.bsdf, surface.wo.z);
  @if(EMISSION) {
    surface.Le = select(vec3f(0.0), found.emission, front);
    surface.lightPdf = lightPdf(found.lightDensity, shape, ray, hit.t, cosine);
  }
  surface.source = hit.id;
  @if(SPHERES || BOXES) surface.source |= select(INSIDE, 0u, front || isFlat(hit.id, shape));
  return surface;
}

@if(SPHERES || BOXES)
fn isFlat(id: u32, shape: vec4f) -> bool {
  return shape.w == 0.0;
}

@if(EMISSION)
fn lightPdf(density: f32, shape: vec4f, ray: Ray, t: f32, cosine: f32) -> f32 {
  let flat = density * t * t / max(abs(cosine), 1e-18);
  @if(SPHERE_EMITTERS) return select(flat, density * sphereLightPdf(ray.o, shape.xyz, shape.w), shape.w > 0.0);
  @if(!SPHERE_EMITTERS) return flat;
}
