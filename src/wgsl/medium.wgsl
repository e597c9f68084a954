// What light loses in the solids that it goes through. KHR_materials_volume
//
// A path remembers what it is in, and what is around that: two levels are enough for a solid in a solid. Where it meets the inside of a
// solid it has been in that one, wherever it started. Where a camera sees something else first, a look beyond that tells what it is in.
//
// [1] Pharr, Jakob, Humphreys 2023, "Physically Based Rendering", 4th ed., eq. 11.10
import package::constants::{FAR, NONE};
import package::frameUniforms::{countRay, frame};
import package::ray::{Hit, Ray, makeRay};
import package::scene::{closestHit, isVolumeOf, sigmaOf};
import package::surface::Surface;
import package::surfacePoint::{SurfacePoint, otherSourceAt, sourceAt, surfacePoint};

// Absorption coefficients, per unit of length.
var<private> medium: vec3f;
var<private> around: vec3f;
// Whether the path has found out what the camera is in.
@if(IMMERSED)
var<private> isKnown: bool;
// How far in front of the camera its first ray starts.
var<private> ahead: f32;

// Surfaces that a look for what the camera is in goes through, at most.
const MOST_SIDES = 8u;

// ray: a path's first.
fn enterScene(ray: Ray) {
  medium = vec3f(0.0);
  around = vec3f(0.0);
  @if(IMMERSED) isKnown = false;
  // Of an orthographic camera this is not known.
  ahead = select(frame.near / dot(ray.d, frame.forward), 0.0, frame.near > FAR);
}

// The transmittance of a way through the medium. [1]
fn absorbed(distance: f32) -> vec3f {
  let way = distance + ahead;
  ahead = 0.0;
  return exp(-way * medium);
}

// To be called where a path meets a surface, before what it loses on its way is counted.
fn meetSide(ray: Ray, surface: Surface) {
  let isSolid = isVolumeOf(surface.id) > 0.0;
  if (isSolid && !surface.front) {
    medium = sigmaOf(surface.id);
    @if(IMMERSED) isKnown = true;
  }
  @if(IMMERSED) {
    if (!isKnown) { medium = mediumBefore(makeRay(surface.below, ray.d, surface.otherSource), isSolid); }
    @if(OCEANS) {
      // What has no other side may lie behind.
      if (!isKnown && all(medium == vec3f(0.0))) { medium = mediumBefore(makeRay(ray.o, -ray.d, NONE), false); }
    }
    isKnown = true;
  }
}

// What a ray goes through before it gets into a solid, or not: the first one that it leaves again without having entered it.
fn mediumBefore(start: Ray, isInside: bool) -> vec3f {
  var ray = start;
  var way = 0.0;
  var entered = select(0, 1, isInside);
  for (var i = 0u; i < MOST_SIDES; i++) {
    let hit = closestHit(ray);
    countRay();
    if (hit.id == NONE) { break; }
    way += hit.t;
    let found = surfacePoint(ray, hit);
    if (isVolumeOf(found.id) > 0.0) {
      if (!found.front && entered <= 0) {
        if (holds(found, hit, ray.d, way)) { return sigmaOf(found.id); }
      } else {
        entered += select(-1, 1, found.front);
      }
    }
    ray = goneThrough(found, hit, ray.d);
  }
  return vec3f(0.0);
}

// Whether a solid that is left along d reaches back all of the way. Where two touch, a ray that leaves the one starts on the other and
// is not seen to enter it.
fn holds(left: SurfacePoint, at: Hit, d: vec3f, way: f32) -> bool {
  var p = left.p;
  @if(MESHES) p -= left.clearance * left.n;
  var ray = makeRay(p, -d, sourceAt(left, at));
  var rest = way;
  for (var i = 0u; i < MOST_SIDES; i++) {
    let hit = closestHit(ray);
    countRay();
    rest -= hit.t;
    if (hit.id == NONE || rest <= 0.0) { break; }
    let found = surfacePoint(ray, hit);
    if (found.id == left.id) { return false; }
    // Still in there as far as it knows: it meets the solid's other side even where it starts on it.
    ray = makeRay(goneThrough(found, hit, -d).o, -d, sourceAt(left, at));
  }
  return true;
}

// The ray that goes on behind a surface.
fn goneThrough(found: SurfacePoint, hit: Hit, d: vec3f) -> Ray {
  var p = found.p;
  @if(MESHES) p += select(found.clearance, -found.clearance, found.front) * found.n;
  return makeRay(p, d, otherSourceAt(found, hit));
}

// What a ray that leaves a surface gets into. wi in world space.
fn mediumTowards(surface: Surface, wi: vec3f) -> vec3f {
  let isBelow = dot(surface.frame.n, wi) < 0.0;
  if (!isBelow || isVolumeOf(surface.id) == 0.0) { return medium; }
  return select(around, sigmaOf(surface.id), surface.front);
}

// To be called where a path goes on from a surface, along `ray`. wi in the local frame.
fn crossSide(surface: Surface, wi: vec3f, ray: Ray) {
  if (wi.z >= 0.0 || isVolumeOf(surface.id) == 0.0) { return; }
  if (surface.front) {
    around = medium;
    medium = sigmaOf(surface.id);
    return;
  }
  medium = around;
  around = vec3f(0.0);
  // Of two solids that touch, the second may have been entered before the first was left.
  @if(NESTED) if (any(medium > vec3f(0.0))) { medium = mediumBefore(ray, false); }
}
