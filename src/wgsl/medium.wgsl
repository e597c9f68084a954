// What light loses in the solids that it goes through. KHR_materials_volume
//
// A path remembers what it is in, and what is around that: two levels are enough for a solid in a solid. Where it meets the inside of a
// solid it has been in that one, wherever it started: so a camera inside of one needs nothing of its own.
//
// [1] Pharr, Jakob, Humphreys 2023, "Physically Based Rendering", 4th ed., eq. 11.10
import package::scene::{isVolumeOf, sigmaOf};
import package::surface::Surface;

// Absorption coefficients, per unit of length.
var<private> medium: vec3f;
var<private> around: vec3f;

fn enterScene() {
  medium = vec3f(0.0);
  around = vec3f(0.0);
}

// The transmittance of a way through the medium. [1]
fn absorbed(distance: f32) -> vec3f {
  return exp(-distance * medium);
}

// To be called where a path meets a surface, before what it loses on its way is counted.
fn meetSide(surface: Surface) {
  if (isVolumeOf(surface.id) > 0.0 && !surface.front) { medium = sigmaOf(surface.id); }
}

// What a ray that leaves a surface gets into. wi in world space.
fn mediumTowards(surface: Surface, wi: vec3f) -> vec3f {
  let isBelow = dot(surface.frame.n, wi) < 0.0;
  if (!isBelow || isVolumeOf(surface.id) == 0.0) { return medium; }
  return select(around, sigmaOf(surface.id), surface.front);
}

// To be called where a path goes on from a surface. wi in the local frame.
fn crossSide(surface: Surface, wi: vec3f) {
  if (wi.z >= 0.0 || isVolumeOf(surface.id) == 0.0) { return; }
  let outer = medium;
  medium = select(around, sigmaOf(surface.id), surface.front);
  around = select(vec3f(0.0), outer, surface.front);
}
