// Light that arrives in a pixel straight from emitters, by rays of its own that go no further.
//
// Nothing in a picture is as noisy as the edge of an emitter, which is far brighter than all around it, and no other noise costs
// as little to remove: in the window where the camera may see an emitter, paths leave this light out, and more rays than
// paths look for it. Splitting as in [1].
//
// [1] Arvo, Kirk 1990, "Particle Transport and Image Synthesis", section 5
import package::camera::cameraRay;
import package::constants::NONE;
import package::coverage::{drawCoverage, tintBefore};
import package::dimensions::{EMITTER_LENS_POINT, EMITTER_PIXEL};
import package::lens::lensRay;
import package::medium::{absorbed, enterScene, meetSide};
import package::sampler::{Sampler, point, subsample};
import package::scene::closestHit;
import package::surface::surfaceAt;
import package::frameUniforms::{countRay, frame};

// Rays per path.
const EMITTER_RAYS = 8u;

// Whether the pixel lies in the emitters' window, and so leaves them to emitterLight().
fn inEmitterWindow(pixel: vec2u) -> bool {
  return all(pixel >= frame.emittersFrom) & all(pixel < frame.emittersTo);
}

@if(VISIBLE_EMITTERS)
fn emitterLight(pixel: vec2u, samples: Sampler) -> vec3f {
  var sum = vec3f(0.0);
  for (var i = 0u; i < EMITTER_RAYS; i++) {
    @if(!LENS) let ray = cameraRay(pixel, point(subsample(samples, i, EMITTER_RAYS), EMITTER_PIXEL));
    @if(LENS) let part = subsample(samples, i, EMITTER_RAYS);
    @if(LENS) let ray = lensRay(pixel, point(part, EMITTER_PIXEL), point(part, EMITTER_LENS_POINT));
    @if(HOLES) drawCoverage(subsample(samples, i, EMITTER_RAYS), EMITTER_PIXEL);
    let hit = closestHit(ray);
    countRay();
    @if(!CLEAR_WALLS && !ABSORPTION) if (hit.id != NONE) { sum += surfaceAt(ray, hit).Le; }
    @if(CLEAR_WALLS || ABSORPTION) if (hit.id != NONE) {
      let surface = surfaceAt(ray, hit);
      var Le = surface.Le;
      @if(ABSORPTION) {
        if (any(Le > vec3f(0.0))) {
          enterScene(ray);
          meetSide(ray, surface);
          Le *= absorbed(hit.t);
        }
      }
      @if(CLEAR_WALLS) Le *= surface.odds;
      @if(COLORED_WALLS) Le *= tintBefore(ray, hit.t);
      sum += Le;
    }
  }
  return sum / f32(EMITTER_RAYS);
}
