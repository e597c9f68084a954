// Traces sampleCount paths per pixel and adds them to one half of the film.
import package::estimator::Li;
import package::film::{FilmPixel, filmAdd};
import package::emitters::{inEmitterWindow, emitterLight};
import package::sampler::makeSampler;
import package::slice::slicePixel;
import package::frameUniforms::{frame, rayCount};

// Radiance sums and, in w, the number of samples in them. Half 0, then half 1; rows from the top. Written here only.
@group(0) @binding(2) var<storage, read_write> film: array<vec4f>;

struct Counters {
  // Rays traced, modulo 2³².
  rays: atomic<u32>,
  // Samples that were not finite and have been dropped.
  badSamples: atomic<u32>,
}

// Written here, cleared and read by the renderer.
@group(0) @binding(3) var<storage, read_write> counters: Counters;

// What the sums in `film` leave over: see FilmPixel. Written and read here only.
@group(0) @binding(4) var<storage, read_write> carries: array<vec2u>;

@compute @workgroup_size(8, 8)
fn trace(
  @builtin(workgroup_id) group: vec3u,
  @builtin(num_workgroups) groups: vec3u,
  @builtin(local_invocation_index) lane: u32,
) {
  let pixel = slicePixel(group, groups, lane);
  if (any(pixel >= frame.size)) { return; }
  var sum = vec4f(0.0);
  for (var i = 0u; i < frame.sampleCount; i++) {
    let samples = makeSampler(pixel, frame.half, frame.seed, frame.firstSample + i);
    let L = Li(pixel, samples);
    sum += select(vec4f(0.0), vec4f(L, 1.0), isFinite(L));
  }
  addToFilm(pixel, sum);
  let badSamples = frame.sampleCount - u32(sum.w);
  if (badSamples > 0u) { atomicAdd(&counters.badSamples, badSamples); }
}

// Adds what the same paths leave out: see emitters.wgsl. Where paths have been dropped, which is a bug anyway, emitters come out
// that much too bright.
@if(VISIBLE_EMITTERS)
@compute @workgroup_size(8, 8)
fn traceEmitters(
  @builtin(workgroup_id) group: vec3u,
  @builtin(num_workgroups) groups: vec3u,
  @builtin(local_invocation_index) lane: u32,
) {
  let pixel = slicePixel(group, groups, lane);
  if (!inEmitterWindow(pixel)) { return; }
  var sum = vec3f(0.0);
  for (var i = 0u; i < frame.sampleCount; i++) {
    sum += emitterLight(pixel, makeSampler(pixel, frame.half, frame.seed, frame.firstSample + i));
  }
  addToFilm(pixel, vec4f(sum, 0.0));
}

fn addToFilm(pixel: vec2u, sum: vec4f) {
  let index = (frame.half * frame.size.y + pixel.y) * frame.size.x + pixel.x;
  let total = filmAdd(FilmPixel(film[index], carries[index]), sum);
  film[index] = total.sum;
  carries[index] = total.carry;
  atomicAdd(&counters.rays, rayCount);
}

// By bits: WGSL lets a compiler assume that no value is infinite or NaN.
fn isFinite(L: vec3f) -> bool {
  return all((bitcast<vec3u>(L) & vec3u(0x7f800000u)) != vec3u(0x7f800000u));
}
