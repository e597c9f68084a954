// The baseline estimator, as in the real-time ray tracer this project grew from: uniform hemisphere directions of density
// 1/2π, light points uniform on the emitter's surface, no multiple importance sampling. Same expectation as path.wgsl.
import package::lobes::bsdf::{bsdfEval, bsdfSampleUniform};
import package::camera::cameraRay;
import package::constants::NONE;
import package::dimensions::{DIRECTION, LIGHT, LOBE, PIXEL, dimensionAt};
import package::basis::{toLocal, toWorld};
import package::lights::light::{sampleLight, lightPick};
import package::ray::makeRay;
import package::sampler::{Sampler, point, subsample};
import package::scene::{closestHit, environment, occluded};
import package::surface::{Surface, surfaceAt};
import package::frameUniforms::{countRay, frame};

fn Li(pixel: vec2u, samples: Sampler) -> vec3f {
  var L = vec3f(0.0);
  var beta = vec3f(1.0);
  var ray = cameraRay(pixel, point(samples, PIXEL));
  // Whether emitters that this ray hits have been counted already, by light sampling at its origin.
  var counted = false;
  for (var depth = 0u; ; depth++) {
    let hit = closestHit(ray);
    countRay();
    if (hit.id == NONE) {
      @if(ENVIRONMENT) L += beta * environment();
      break;
    }
    let surface = surfaceAt(ray, hit);
    @if(EMISSION) L += select(beta * surface.Le, vec3f(0.0), counted && surface.lightPdf > 0.0);
    if (depth >= frame.maxBounces) { break; }

    @if(LIGHTS) L += beta * directLight(surface, samples, dimensionAt(depth, LIGHT));

    let choice = point(samples, dimensionAt(depth, LOBE));
    let next = bsdfSampleUniform(surface.bsdf, surface.wo, point(samples, dimensionAt(depth, DIRECTION)), choice.x);
    let wi = toWorld(surface.frame, next.wi);
    beta *= next.weight;
    @if(SHADING_NORMALS) beta *= select(0.0, 1.0, dot(wi, surface.ng) > 0.0);
    counted = next.pdf > 0.0;
    if (all(beta == vec3f(0.0))) { break; }
    ray = makeRay(surface.p, wi, surface.source);
  }
  return L;
}

@if(LIGHTS)
fn directLight(surface: Surface, samples: Sampler, dimension: u32) -> vec3f {
  @if(!MANY_LIGHT_SAMPLES) return oneLight(surface, samples, dimension);
  @if(MANY_LIGHT_SAMPLES) {
    var sum = vec3f(0.0);
    for (var i = 0u; i < frame.lightSamples; i++) {
      sum += oneLight(surface, subsample(samples, i, frame.lightSamples), dimension);
    }
    return sum / f32(frame.lightSamples);
  }
}

@if(LIGHTS)
fn oneLight(surface: Surface, samples: Sampler, dimension: u32) -> vec3f {
  let light = sampleLight(surface, point(samples, dimension), lightPick(samples, dimension));
  var reflected = bsdfEval(surface.bsdf, surface.wo, toLocal(surface.frame, light.wi)).rgb * light.estimate;
  @if(SHADING_NORMALS) reflected *= select(0.0, 1.0, dot(light.wi, surface.ng) > 0.0);
  if (all(reflected == vec3f(0.0))) { return vec3f(0.0); }
  countRay();
  return select(reflected, vec3f(0.0), occluded(makeRay(surface.p, light.wi, surface.source), light.distance, light.id));
}
