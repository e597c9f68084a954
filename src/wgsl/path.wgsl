// The path tracing estimator: next-event estimation and lobe sampling, combined by multiple importance sampling.
//
// [1] Veach 1997, "Robust Monte Carlo Methods for Light Transport Simulation", sections 9.2 and 10.2
// [2] Arvo, Kirk 1990, "Particle Transport and Image Synthesis"
import package::bsdf::{bsdfEval, bsdfSample};
import package::constants::NONE;
import package::dimensions::{DIRECTION, LIGHT, LOBE, dimensionAt};
import package::frame::{toLocal, toWorld};
import package::lights::sampleLight;
import package::ray::{Ray, makeRay};
import package::sampler::{Sampler, independent, point, subsample};
import package::scene::{closestHit, environment, occluded};
import package::surface::{Surface, surfaceAt};
import package::uniforms::{countRay, frame};

// Paths shorter than this are never ended at random. [2]
const ROULETTE_DEPTH = 4u;

// Radiance that arrives at the origin of `camera` from its direction.
fn Li(camera: Ray, samples: Sampler) -> vec3f {
  var L = vec3f(0.0);
  var beta = vec3f(1.0);
  var ray = camera;
  // Density of ray.d, per steradian; 0 for directions that light sampling cannot find too.
  var pdf = 0.0;
  for (var depth = 0u; ; depth++) {
    let hit = closestHit(ray);
    countRay();
    if (hit.id == NONE) {
      @if(ENVIRONMENT) L += beta * environment();
      break;
    }
    let surface = surfaceAt(ray, hit);
    @if(EMISSION) L += beta * surface.Le * select(powerHeuristic(pdf, lightSampleCount() * surface.lightPdf), 1.0, pdf == 0.0);
    if (depth >= frame.maxBounces) { break; }

    @if(LIGHTS) L += beta * directLight(surface, samples, dimensionAt(depth, LIGHT));

    var choice = vec2f(0.0);
    @if(LOBES) choice = point(samples, dimensionAt(depth, LOBE));
    @if(!LOBES) choice.y = independent(samples, depth);
    let next = bsdfSample(surface.bsdf, surface.wo, point(samples, dimensionAt(depth, DIRECTION)), choice.x);
    beta *= next.weight;
    pdf = next.pdf;
    let survival = select(min(max(max(beta.r, beta.g), beta.b), 1.0), 1.0, depth < ROULETTE_DEPTH);
    if (choice.y >= survival || all(beta == vec3f(0.0))) { break; }
    beta /= survival;
    ray = makeRay(surface.p, toWorld(surface.frame, next.wi), surface.source);
  }
  return L;
}

// Light that arrives straight from an emitter and is reflected towards the viewer.
@if(LIGHTS)
fn directLight(surface: Surface, samples: Sampler, dimension: u32) -> vec3f {
  @if(!MANY_LIGHT_SAMPLES) return oneLight(surface, point(samples, dimension), 1.0);
  @if(MANY_LIGHT_SAMPLES) {
    var sum = vec3f(0.0);
    for (var i = 0u; i < frame.lightSamples; i++) {
      sum += oneLight(surface, point(subsample(samples, i, frame.lightSamples), dimension), lightSampleCount());
    }
    return sum / lightSampleCount();
  }
}

@if(LIGHTS)
fn oneLight(surface: Surface, u: vec2f, sampleCount: f32) -> vec3f {
  let light = sampleLight(surface.p, u);
  let f = bsdfEval(surface.bsdf, surface.wo, toLocal(surface.frame, light.wi));
  let weight = select(powerHeuristic(sampleCount * light.pdf, f.a), 1.0, light.pdf == 0.0);
  let reflected = f.rgb * light.estimate * weight;
  if (all(reflected == vec3f(0.0))) { return vec3f(0.0); }
  countRay();
  return select(reflected, vec3f(0.0), occluded(makeRay(surface.p, light.wi, surface.source), light.distance, light.id));
}

fn lightSampleCount() -> f32 {
  @if(MANY_LIGHT_SAMPLES) return f32(frame.lightSamples);
  @if(!MANY_LIGHT_SAMPLES) return 1.0;
}

// Weight of a direction drawn with density `pdf` when another technique would have drawn it with density `other`.
// [1] eq. 9.11 with β = 2, divided through so that no square overflows. `pdf` > 0.
fn powerHeuristic(pdf: f32, other: f32) -> f32 {
  let ratio = min(other / pdf, 1e9);
  return 1.0 / (1.0 + ratio * ratio);
}
