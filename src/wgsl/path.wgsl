// The path tracing estimator: next-event estimation and lobe sampling, combined by multiple importance sampling.
//
// [1] Veach 1997, "Robust Monte Carlo Methods for Light Transport Simulation", sections 9.2 and 10.2
// [2] Arvo, Kirk 1990, "Particle Transport and Image Synthesis"
import package::lobes::bsdf::{bsdfEval, bsdfSample};
import package::camera::cameraRay;
import package::constants::{NEAR2, NONE};
import package::dimensions::{DIRECTION, LIGHT, LOBE, PIXEL, dimensionAt};
import package::basis::{toLocal, toWorld};
import package::emitters::inEmitterWindow;
import package::lights::light::{lightShareOf, sampleLight, lightPick};
import package::minMax::{greater, lesser};
import package::ray::makeRay;
import package::sampler::{Sampler, independent, point, subsample};
import package::scene::{closestHit, environment, occluded};
import package::surface::{Surface, surfaceAt};
import package::surfacePoint::primitiveOf;
import package::frameUniforms::{countRay, frame};

// Paths shorter than this are never ended at random. [2]
const ROULETTE_DEPTH = 4u;

// Radiance that arrives in a pixel of the camera.
fn Li(pixel: vec2u, samples: Sampler) -> vec3f {
  var L = vec3f(0.0);
  var beta = vec3f(1.0);
  var ray = cameraRay(pixel, point(samples, PIXEL));
  // Density of ray.d, per steradian; 0 for directions that light sampling cannot find too. Negative where rays of their own
  // look for what emits: see emitters.wgsl.
  var pdf = select(0.0, -1.0, inEmitterWindow(pixel));
  // Where the ray started, and the weight of all lights there.
  @if(MANY_LIGHTS) var last: Surface;
  @if(MANY_LIGHTS) var totalWeight = 1.0;
  for (var depth = 0u; ; depth++) {
    let hit = closestHit(ray);
    countRay();
    if (hit.id == NONE) {
      @if(ENVIRONMENT) L += beta * environment();
      break;
    }
    let surface = surfaceAt(ray, hit);
    @if(EMISSION) {
      var lightPdf = lightSampleCount() * surface.lightPdf;
      @if(MANY_LIGHTS) lightPdf *= lightShareOf(primitiveOf(hit.id), last) / greater(totalWeight, NEAR2);
      let weight = select(powerHeuristic(pdf, lightPdf), 1.0, pdf == 0.0);
      L += beta * surface.Le * select(weight, 0.0, pdf < 0.0);
    }
    if (depth >= frame.maxBounces) { break; }

    @if(LIGHTS) {
      let direct = directLight(surface, samples, dimensionAt(depth, LIGHT));
      L += beta * direct.rgb;
      @if(MANY_LIGHTS) last = surface;
      @if(MANY_LIGHTS) totalWeight = direct.a;
    }

    var choice = vec2f(0.0);
    @if(LOBES) choice = point(samples, dimensionAt(depth, LOBE));
    @if(!LOBES) choice.y = independent(samples, depth);
    let next = bsdfSample(surface.bsdf, surface.wo, point(samples, dimensionAt(depth, DIRECTION)), choice.x);
    let wi = toWorld(surface.frame, next.wi);
    beta *= next.weight;
    @if(SHADING_NORMALS) beta *= select(0.0, 1.0, dot(wi, surface.ng) > 0.0);
    pdf = next.pdf;
    let survival = select(lesser(greater(greater(beta.r, beta.g), beta.b), 1.0), 1.0, depth < ROULETTE_DEPTH);
    if (choice.y >= survival || all(beta == vec3f(0.0))) { break; }
    beta /= survival;
    ray = makeRay(surface.p, wi, surface.source);
  }
  return L;
}

// Light that arrives straight from an emitter and is reflected towards the viewer; in a the total weight of the lights.
@if(LIGHTS)
fn directLight(surface: Surface, samples: Sampler, dimension: u32) -> vec4f {
  @if(!MANY_LIGHT_SAMPLES) return oneLight(surface, samples, dimension, 1.0);
  @if(MANY_LIGHT_SAMPLES) {
    var sum = vec4f(0.0);
    for (var i = 0u; i < frame.lightSamples; i++) {
      sum += oneLight(surface, subsample(samples, i, frame.lightSamples), dimension, lightSampleCount());
    }
    return sum / lightSampleCount();
  }
}

@if(LIGHTS)
fn oneLight(surface: Surface, samples: Sampler, dimension: u32, sampleCount: f32) -> vec4f {
  let light = sampleLight(surface, point(samples, dimension), lightPick(samples, dimension));
  let f = bsdfEval(surface.bsdf, surface.wo, toLocal(surface.frame, light.wi));
  let weight = select(powerHeuristic(sampleCount * light.pdf, f.a), 1.0, light.pdf == 0.0);
  var reflected = f.rgb * light.estimate * weight;
  @if(SHADING_NORMALS) reflected *= select(0.0, 1.0, dot(light.wi, surface.ng) > 0.0);
  if (all(reflected == vec3f(0.0))) { return vec4f(vec3f(0.0), light.totalWeight); }
  countRay();
  let hidden = occluded(makeRay(surface.p, light.wi, surface.source), light.distance, light.id);
  return vec4f(select(reflected, vec3f(0.0), hidden), light.totalWeight);
}

fn lightSampleCount() -> f32 {
  @if(MANY_LIGHT_SAMPLES) return f32(frame.lightSamples);
  @if(!MANY_LIGHT_SAMPLES) return 1.0;
}

// Weight of a direction drawn with density `pdf` when another technique would have drawn it with density `other`.
// [1] eq. 9.11 with β = 2, divided through so that no square overflows. `pdf` > 0.
fn powerHeuristic(pdf: f32, other: f32) -> f32 {
  let ratio = lesser(other / pdf, 1e9);
  return 1.0 / (1.0 + ratio * ratio);
}
