// The path tracing estimator: next-event estimation and lobe sampling, combined by multiple importance sampling.
//
// [1] Veach 1997, "Robust Monte Carlo Methods for Light Transport Simulation", sections 9.2 and 10.2
// [2] Arvo, Kirk 1990, "Particle Transport and Image Synthesis"
import package::basis::{toLocal, toWorld};
import package::camera::cameraRay;
import package::constants::{NEAR2, NONE};
import package::coverage::{drawCoverage, tintBefore};
import package::dimensions::{DIRECTION, LENS_POINT, LIGHT, LOBE, PIXEL, dimensionAt};
import package::directLight::{DirectLight, directLight, lightSampleCount, unhidden};
import package::emitters::inEmitterWindow;
import package::dispersion::{drawColor, disperse};
import package::frameUniforms::{countRay, frame};
import package::lens::lensRay;
import package::lights::directional::skyLightPdf;
import package::lights::light::{lightPick, lightShareOf, sampleLight};
import package::medium::{absorbed, crossSide, enterScene, meetSide};
import package::minMax::{greater, lesser};
import package::sampler::{Sampler, independent, point};
import package::scene::{FIRST_SKY_LIGHT, LIGHT_COUNT, bsdfEval, bsdfSample, closestHit, environment, lightAt, lightWeight};
import package::surface::{Surface, leave, leaves, surfaceAt};
import package::surfacePoint::primitiveOf;

// Paths shorter than this are never ended at random. [2]
const ROULETTE_DEPTH = 4u;

// Radiance that arrives in a pixel of the camera.
fn Li(pixel: vec2u, samples: Sampler) -> vec3f {
  var L = vec3f(0.0);
  var beta = vec3f(1.0);
  @if(!LENS) var ray = cameraRay(pixel, point(samples, PIXEL));
  @if(LENS) var ray = lensRay(pixel, point(samples, PIXEL), point(samples, LENS_POINT));
  // Density of ray.d, per steradian; 0 for directions that light sampling cannot find too. Negative where rays of their own
  // look for what emits: see emitters.wgsl.
  var pdf = select(0.0, -1.0, inEmitterWindow(pixel));
  // Where the ray started, and the weight of all lights there.
  @if(MANY_LIGHTS) var last: Surface;
  @if(MANY_LIGHTS) var totalWeight = 1.0;
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
      @if(SKY_DISKS) {
        for (var i = FIRST_SKY_LIGHT; i < LIGHT_COUNT; i++) {
          let light = lightAt(i);
          var lightPdf = lightSampleCount() * skyLightPdf(light, ray.d);
          if (lightPdf == 0.0) { continue; }
          @if(MANY_LIGHTS) lightPdf *= lightWeight(i, last) / greater(totalWeight, NEAR2);
          L += beta * light.radiance * select(powerHeuristic(pdf, lightPdf), 1.0, pdf <= 0.0);
        }
      }
      break;
    }
    let surface = surfaceAt(ray, hit);
    @if(CLEAR_WALLS) beta *= surface.odds;
    @if(ABSORPTION) meetSide(ray, surface);
    @if(ABSORPTION) beta *= absorbed(hit.t);
    @if(DISPERSION) beta *= disperse(surface.id);
    @if(EMISSION) {
      var lightPdf = lightSampleCount() * surface.lightPdf;
      @if(MANY_LIGHTS) lightPdf *= lightShareOf(primitiveOf(hit.id), last) / greater(totalWeight, NEAR2);
      let weight = select(powerHeuristic(pdf, lightPdf), 1.0, pdf == 0.0);
      L += beta * surface.Le * select(weight, 0.0, pdf < 0.0);
    }
    if (depth >= frame.maxBounces) { break; }

    @if(LIGHTS) {
      let direct = directLight(surface, samples, dimensionAt(depth, LIGHT));
      L += beta * direct.L;
      @if(MANY_LIGHTS) last = surface;
      @if(MANY_LIGHTS) totalWeight = direct.totalWeight;
    }

    var choice = vec2f(0.0);
    @if(LOBES) choice = point(samples, dimensionAt(depth, LOBE));
    @if(!LOBES) choice.y = independent(samples, depth);
    let next = bsdfSample(surface.bsdf, surface.wo, point(samples, dimensionAt(depth, DIRECTION)), choice.x);
    let wi = toWorld(surface.frame, next.wi);
    beta *= next.weight;
    @if(SHADING_NORMALS) beta *= select(0.0, 1.0, leaves(surface, wi));
    pdf = next.pdf;
    let survival = select(lesser(greater(greater(beta.r, beta.g), beta.b), 1.0), 1.0, depth < ROULETTE_DEPTH);
    if (choice.y >= survival || all(beta == vec3f(0.0))) { break; }
    beta /= survival;
    ray = leave(surface, wi);
    @if(ABSORPTION) crossSide(surface, next.wi, ray);
  }
  return L;
}

@if(LIGHTS)
fn oneLight(surface: Surface, samples: Sampler, dimension: u32) -> DirectLight {
  let light = sampleLight(surface, point(samples, dimension), lightPick(samples, dimension));
  let value = bsdfEval(surface.bsdf, surface.wo, toLocal(surface.frame, light.wi));
  let weight = select(powerHeuristic(lightSampleCount() * light.pdf, value.pdf), 1.0, light.pdf == 0.0);
  return DirectLight(unhidden(surface, light, value.f * light.estimate * weight), light.totalWeight);
}

// Weight of a direction drawn with density `pdf` when another technique would have drawn it with density `other`.
// [1] eq. 9.11 with β = 2, divided through so that no square overflows. `pdf` > 0.
fn powerHeuristic(pdf: f32, other: f32) -> f32 {
  let ratio = lesser(other / pdf, 1e9);
  return 1.0 / (1.0 + ratio * ratio);
}
