// The baseline estimator, as in the real-time ray tracer this project grew from: uniform hemisphere directions of density
// 1/2π, light points uniform on the emitter's surface, no multiple importance sampling. Same expectation as path.wgsl.
import package::basis::{toLocal, toWorld};
import package::camera::cameraRay;
import package::constants::NONE;
import package::coverage::{drawCoverage, tintBefore};
import package::dimensions::{DIRECTION, LENS_POINT, LIGHT, LOBE, PIXEL, dimensionAt};
import package::directLight::{DirectLight, directLight, unhidden};
import package::dispersion::{drawColor, disperse};
import package::frameUniforms::{countRay, frame};
import package::lens::lensRay;
import package::lights::directional::skyRadiance;
import package::lights::light::{lightPick, sampleLight};
import package::medium::{absorbed, crossSide, enterScene, meetSide};
import package::sampler::{Sampler, point};
import package::scene::{bsdfEval, bsdfSampleUniform, closestHit, environment};
import package::surface::{Surface, leave, leaves, surfaceAt};

fn Li(pixel: vec2u, samples: Sampler) -> vec3f {
  var L = vec3f(0.0);
  var beta = vec3f(1.0);
  @if(!LENS) var ray = cameraRay(pixel, point(samples, PIXEL));
  @if(LENS) var ray = lensRay(pixel, point(samples, PIXEL), point(samples, LENS_POINT));
  // Whether emitters that this ray hits have been counted already, by light sampling at its origin.
  var counted = false;
  @if(ABSORPTION) enterScene(ray);
  @if(DISPERSION) drawColor(samples);
  for (var depth = 0u; ; depth++) {
    @if(HOLES) drawCoverage(samples, dimensionAt(depth, PIXEL));
    let hit = closestHit(ray);
    countRay();
    @if(COLORED_WALLS) beta *= tintBefore(ray, hit.t);
    if (hit.id == NONE) {
      @if(ABSORPTION) beta *= absorbed(hit.t);
      @if(ENVIRONMENT) L += beta * environment();
      @if(SKY_DISKS) L += select(beta * skyRadiance(ray.d), vec3f(0.0), counted);
      break;
    }
    let surface = surfaceAt(ray, hit);
    @if(CLEAR_WALLS) beta *= surface.odds;
    @if(ABSORPTION) meetSide(ray, surface);
    @if(ABSORPTION) beta *= absorbed(hit.t);
    @if(DISPERSION) beta *= disperse(surface.id);
    @if(EMISSION) L += select(beta * surface.Le, vec3f(0.0), counted && surface.lightPdf > 0.0);
    if (depth >= frame.maxBounces) { break; }

    @if(LIGHTS) L += beta * directLight(surface, samples, dimensionAt(depth, LIGHT)).L;

    let choice = point(samples, dimensionAt(depth, LOBE));
    let next = bsdfSampleUniform(surface.bsdf, surface.wo, point(samples, dimensionAt(depth, DIRECTION)), choice.x);
    let wi = toWorld(surface.frame, next.wi);
    beta *= next.weight;
    @if(SHADING_NORMALS) beta *= select(0.0, 1.0, leaves(surface, wi));
    counted = next.pdf > 0.0;
    if (all(beta == vec3f(0.0))) { break; }
    ray = leave(surface, wi);
    @if(ABSORPTION) crossSide(surface, next.wi, ray);
  }
  return L;
}

@if(LIGHTS)
fn oneLight(surface: Surface, samples: Sampler, dimension: u32) -> DirectLight {
  let light = sampleLight(surface, point(samples, dimension), lightPick(samples, dimension));
  let value = bsdfEval(surface.bsdf, surface.wo, toLocal(surface.frame, light.wi));
  return DirectLight(unhidden(surface, light, value.f * light.estimate), light.totalWeight);
}
