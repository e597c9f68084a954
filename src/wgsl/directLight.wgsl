// Light that arrives at a surface straight from emitters and is reflected towards the viewer.
import package::coverage::{clearness, drawCoverage};
import package::medium::mediumTowards;
import package::estimator::oneLight;
import package::frameUniforms::{countRay, frame};
import package::lights::light::LightSample;
import package::sampler::{Sampler, subsample};
import package::scene::occluded;
import package::surface::{Surface, leave, leaves};

struct DirectLight {
  L: vec3f,
  // Weight of all lights at the surface: see LightChoice.
  totalWeight: f32,
}

// The mean of the light samples that the settings ask for, each as the estimator weighs it.
@if(LIGHTS)
fn directLight(surface: Surface, samples: Sampler, dimension: u32) -> DirectLight {
  @if(HOLES && !MANY_LIGHT_SAMPLES) drawCoverage(samples, dimension);
  @if(!MANY_LIGHT_SAMPLES) return oneLight(surface, samples, dimension);
  @if(MANY_LIGHT_SAMPLES) {
    var sum: DirectLight;
    for (var i = 0u; i < frame.lightSamples; i++) {
      @if(HOLES) drawCoverage(subsample(samples, i, frame.lightSamples), dimension);
      let one = oneLight(surface, subsample(samples, i, frame.lightSamples), dimension);
      sum.L += one.L;
      sum.totalWeight += one.totalWeight;
    }
    return DirectLight(sum.L / lightSampleCount(), sum.totalWeight / lightSampleCount());
  }
}

// What is left of `reflected` where something hides the light.
@if(LIGHTS)
fn unhidden(surface: Surface, light: LightSample, reflected: vec3f) -> vec3f {
  var L = reflected;
  @if(SHADING_NORMALS) L *= select(0.0, 1.0, leaves(surface, light.wi));
  if (all(L == vec3f(0.0))) { return L; }
  countRay();
  @if(CLEAR_WALLS) clearness = vec3f(1.0);
  let hidden = occluded(leave(surface, light.wi), light.distance, light.id);
  @if(CLEAR_WALLS) L *= clearness;
  @if(ABSORPTION) L *= exp(-light.distance * mediumTowards(surface, light.wi));
  return select(L, vec3f(0.0), hidden);
}

fn lightSampleCount() -> f32 {
  @if(MANY_LIGHT_SAMPLES) return f32(frame.lightSamples);
  @if(!MANY_LIGHT_SAMPLES) return 1.0;
}
