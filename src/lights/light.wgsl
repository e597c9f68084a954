// Lights for next-event estimation, and the density with which they are chosen. How a point on one is drawn is in the file of its
// kind.
import package::basis::toLocal;
import package::dimensions::LIGHT_PICK;
import package::minMax::greater;
import package::sampler::{Sampler, point};
import package::scene::{bsdfExpect, chooseLight, doubleSidedOf, lightAt, lightBoundOf, sampleKind, shapeOf};
import package::surface::Surface;

// One light, packed by compile/packScene.ts.
struct Light {
  // Centre of a sphere, corner of a quad or triangle, position of a point; of a mesh, where its triangles stand in
  // `emissiveTriangles` and how many there are.
  position: vec3f,
  // Radius of a sphere or spot, area of a quad, triangle or mesh; of what is infinitely far, 1 − cos of its angular radius.
  size: f32,
  edge1: vec3f,
  // By which function it is sampled: see lights.ts.
  kind: u32,
  edge2: vec3f,
  // What a ray that hits it names; NONE for a mesh and what no ray hits.
  id: u32,
  // Radiance; intensity of a point, irradiance of one that is infinitely far.
  radiance: vec3f,
  // Of the side a quad, triangle or spot shines to, unit: from its edges in f32 it would take products of four lengths. Towards what is
  // infinitely far.
  normal: vec3f,
}

// Which light to sample.
struct LightChoice {
  index: u32,
  // The point that decided, stretched back over [0, 1)².
  u: vec2f,
  probability: f32,
  // Weights of all lights together; 0 when none can reach the point.
  totalWeight: f32,
}

struct LightSample {
  // Unit, towards the light.
  wi: vec3f,
  distance: f32,
  // Radiance / density; 0 when the light does not reach the point.
  estimate: vec3f,
  // Per steradian, the choice of light included; 0 for a light that no ray can hit.
  pdf: f32,
  // What shines, as a ray would hit it; NONE if no ray can. A kind of light leaves NONE where that is the light's own id.
  id: u32,
  // Of the choice: see LightChoice.
  totalWeight: f32,
}

// A point on a light that may shine on the surface: `u` chooses the light and the point, `pick` a part of a light of many parts.
fn sampleLight(surface: Surface, u: vec2f, pick: vec2f) -> LightSample {
  let choice = chooseLight(surface, u);
  let light = lightAt(choice.index);
  var sample = sampleKind(light, surface.p, choice.u, pick);
  sample.id = min(sample.id, light.id);
  sample.estimate *= select(light.radiance / choice.probability, vec3f(0.0), choice.probability == 0.0);
  sample.pdf *= choice.probability;
  sample.totalWeight = choice.totalWeight;
  return sample;
}

// The point that chooses a light's part.
fn lightPick(samples: Sampler, dimension: u32) -> vec2f {
  @if(LIGHT_PICKS) return point(samples, dimension | LIGHT_PICK);
  @if(!LIGHT_PICKS) return vec2f(0.0);
}

// A light no further than 1e-10 away is as good as touching: its share is finite, and so is the product with its size.
const TOUCHING2 = 1e-20;

// What a light of unit strength in the ball `bound` (centre, radius) is expected to add to what the surface sends to the
// viewer; finite near the ball, and 0 only where nothing in the ball is above the surface.
@if(MANY_LIGHTS)
fn lightShare(surface: Surface, bound: vec4f) -> f32 {
  let toLight = bound.xyz - surface.p;
  let d2 = greater(dot(toLight, toLight), TOUCHING2);
  let perDistance = inverseSqrt(d2);
  let size = bound.w * perDistance;
  return bsdfExpect(surface.bsdf, surface.wo, toLocal(surface.frame, toLight * perDistance), size) / greater(d2, bound.w * bound.w);
}

// The same for a flat light that shines along `front`.
@if(MANY_LIGHTS)
fn flatLightShare(surface: Surface, bound: vec4f, front: vec3f) -> f32 {
  let toSurface = surface.p - bound.xyz;
  let height = dot(front, toSurface);
  let facing = (height + bound.w) / (length(toSurface) + bound.w);
  return select(0.0, lightShare(surface, bound) * facing, height > 0.0);
}

// The same for a light of unit irradiance that is infinitely far; `bound` holds the directions to it.
@if(MANY_LIGHTS)
fn skyLightShare(surface: Surface, bound: vec4f) -> f32 {
  return bsdfExpect(surface.bsdf, surface.wo, toLocal(surface.frame, bound.xyz), bound.w);
}

// The same for the light on a primitive.
@if(MANY_LIGHTS)
fn lightShareOf(id: u32, surface: Surface) -> f32 {
  let bound = lightBoundOf(id);
  @if(!FLAT_LIGHTS) return lightShare(surface, bound);
  @if(FLAT_LIGHTS) {
    let shape = shapeOf(id);
    @if(DOUBLE_SIDED) {
      if (doubleSidedOf(id) > 0.0) { return lightShare(surface, bound); }
    }
    return select(lightShare(surface, bound), flatLightShare(surface, bound, shape.xyz), shape.w == 0.0);
  }
}
