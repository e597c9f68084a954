// Points on emitters, for next-event estimation, and the density with which they are chosen.
//
// [1] Shirley, Wang, Zimmerman 1996, "Monte Carlo Techniques for Direct Lighting Calculations", TOG 15(1)
// [2] Pharr, Jakob, Humphreys 2023, "Physically Based Rendering", 4th ed., section 6.2.4
// [3] Heitz 2019, "A Low-Distortion Map Between Triangle and Square"
import package::bsdf::bsdfExpect;
import package::constants::{NONE, TWO_PI};
import package::dimensions::LIGHT_TRIANGLE;
import package::directions::{circle, uniformSphere};
import package::frame::{frameAround, toLocal, toWorld};
import package::order::{greater, lesser};
import package::sampler::{Sampler, point};
import package::scene::{chooseLight, lightAt, lightBoundOf, shapeOf};
import package::meshLights::sampleMesh;
import package::surface::Surface;

const SPHERE_LIGHT = 0u;
const QUAD_LIGHT = 1u;
const TRIANGLE_LIGHT = 2u;
const POINT_LIGHT = 3u;
const MESH_LIGHT = 4u;

// One emitter, packed by compile/packScene.ts.
struct Light {
  // Centre of a sphere, corner of a quad or triangle, position of a point; of a mesh, where its triangles stand in
  // `shiningTriangles` and how many there are.
  position: vec3f,
  // Radius of a sphere, area of a quad, triangle or mesh.
  size: f32,
  edge1: vec3f,
  kind: u32,
  edge2: vec3f,
  // What a ray that hits it names, NONE for a point and a mesh.
  id: u32,
  // Radiance; intensity of a point.
  radiance: vec3f,
  // Of the side a quad or triangle shines to, unit: from its edges in f32 it would take products of four lengths.
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
  // Per steradian, the choice of light included; 0 for a point light, which no ray can hit.
  pdf: f32,
  // What shines, as a ray would hit it; NONE for a point.
  id: u32,
  // Of the choice: see LightChoice.
  totalWeight: f32,
}

// A point on a light that may shine on the surface: `u` chooses the light and the point, `pick` the triangle of a mesh.
fn sampleLight(surface: Surface, u: vec2f, pick: vec2f) -> LightSample {
  let choice = chooseLight(surface, u);
  let p = surface.p;
  let light = lightAt(choice.index);
  let kind = light.kind;
  var sample: LightSample;
  @if(SPHERE_LIGHTS && !UNIFORM) if (isKind(kind, SPHERE_LIGHT)) { sample = sampleSphere(p, light.position, light.size, choice.u); }
  @if(SPHERE_LIGHTS && UNIFORM) if (isKind(kind, SPHERE_LIGHT)) { sample = sampleSphereSurface(p, light.position, light.size, choice.u); }
  @if(QUAD_LIGHTS) if (isKind(kind, QUAD_LIGHT)) { sample = samplePlanar(p, light, choice.u); }
  @if(TRIANGLE_LIGHTS) if (isKind(kind, TRIANGLE_LIGHT)) { sample = samplePlanar(p, light, squareToTriangle(choice.u)); }
  @if(POINT_LIGHTS) if (isKind(kind, POINT_LIGHT)) { sample = samplePoint(p, light.position); }
  sample.id = light.id;
  @if(MESH_LIGHTS) if (isKind(kind, MESH_LIGHT)) { sample = sampleMesh(p, light, choice.u, pick); }
  sample.estimate *= select(light.radiance / choice.probability, vec3f(0.0), choice.probability == 0.0);
  sample.pdf *= choice.probability;
  sample.totalWeight = choice.totalWeight;
  return sample;
}

// The point that chooses the triangle of a mesh.
fn trianglePick(samples: Sampler, dimension: u32) -> vec2f {
  @if(MESH_LIGHTS) return point(samples, dimension | LIGHT_TRIANGLE);
  @if(!MESH_LIGHTS) return vec2f(0.0);
}

// Whether this light is of a kind; known at compile time when the scene has only one.
fn isKind(kind: u32, expected: u32) -> bool {
  @if(ONE_LIGHT_KIND) return true;
  @if(!ONE_LIGHT_KIND) return kind == expected;
}

// What a light of unit strength in the ball `bound` (centre, radius) is expected to add to what the surface sends to the
// viewer; finite near the ball, and 0 only where nothing in the ball is above the surface.
@if(MANY_LIGHTS)
fn lightShare(surface: Surface, bound: vec4f) -> f32 {
  let toLight = bound.xyz - surface.p;
  let d2 = greater(dot(toLight, toLight), 1e-20);
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

// The same for the light on a primitive.
@if(MANY_LIGHTS)
fn lightShareOf(id: u32, surface: Surface) -> f32 {
  let bound = lightBoundOf(id);
  @if(!FLAT_LIGHTS) return lightShare(surface, bound);
  @if(FLAT_LIGHTS) {
    let shape = shapeOf(id);
    return select(lightShare(surface, bound), flatLightShare(surface, bound, shape.xyz), shape.w == 0.0);
  }
}

// Uniform in the cone that the sphere fills. [2]
// Cones are measured by sin², and 1 − cos by sin²/(1 + cos), so that a tiny cone keeps its digits.
@if(SPHERE_LIGHTS && !UNIFORM)
fn sampleSphere(p: vec3f, center: vec3f, radius: f32, u: vec2f) -> LightSample {
  let toCenter = center - p;
  let d2 = dot(toCenter, toCenter);
  let sin2Max = radius * radius / greater(d2, 1e-36);
  if (sin2Max >= 1.0) { return LightSample(vec3f(0.0, 0.0, 1.0), 0.0, vec3f(0.0), 0.0, NONE, 0.0); }
  let oneMinusCos = u.x * coneOneMinusCos(sin2Max);
  let cosTheta = 1.0 - oneMinusCos;
  let sin2 = oneMinusCos * (1.0 + cosTheta);
  let d = sqrt(d2);
  let wi = normalize(toWorld(frameAround(toCenter / d), vec3f(sqrt(sin2) * circle(u.y), cosTheta)));
  let distance = d * (cosTheta - sqrt(greater(sin2Max - sin2, 0.0)));
  let solidAngle = TWO_PI * coneOneMinusCos(sin2Max);
  return LightSample(wi, distance, vec3f(solidAngle), 1.0 / solidAngle, NONE, 0.0);
}

fn coneOneMinusCos(sin2Max: f32) -> f32 {
  return sin2Max / (1.0 + sqrt(1.0 - sin2Max));
}

// Density of sampleSphere towards any point of the sphere that p sees.
fn sphereLightPdf(p: vec3f, center: vec3f, radius: f32) -> f32 {
  let toCenter = center - p;
  let sin2Max = radius * radius / greater(dot(toCenter, toCenter), 1e-36);
  return select(0.0, 1.0 / (TWO_PI * coneOneMinusCos(lesser(sin2Max, 1.0))), sin2Max < 1.0);
}

// The baseline's choice: uniform on the whole surface, half of which p cannot see. [1]
@if(SPHERE_LIGHTS && UNIFORM)
fn sampleSphereSurface(p: vec3f, center: vec3f, radius: f32, u: vec2f) -> LightSample {
  let n = uniformSphere(u);
  return fromArea(p, center + radius * n, n, 2.0 * TWO_PI * radius * radius);
}

// Uniform on a quad or, with u folded, on a triangle.
@if(QUAD_LIGHTS || TRIANGLE_LIGHTS)
fn samplePlanar(p: vec3f, light: Light, u: vec2f) -> LightSample {
  return fromArea(p, light.position + u.x * light.edge1 + u.y * light.edge2, light.normal, light.size);
}

// [3]
@if(TRIANGLE_LIGHTS || MESH_LIGHTS)
fn squareToTriangle(u: vec2f) -> vec2f {
  return select(vec2f(0.5 * u.x, u.y - 0.5 * u.x), vec2f(u.x - 0.5 * u.y, 0.5 * u.y), u.x > u.y);
}

// Turns a uniform density on an area into one per solid angle, seen from p. n is the emitting side.
@if(QUAD_LIGHTS || TRIANGLE_LIGHTS || MESH_LIGHTS || (SPHERE_LIGHTS && UNIFORM))
fn fromArea(p: vec3f, q: vec3f, n: vec3f, area: f32) -> LightSample {
  let toLight = q - p;
  let d2 = dot(toLight, toLight);
  let d = sqrt(greater(d2, 1e-36));
  let wi = toLight / d;
  let cosLight = -dot(wi, n);
  if (cosLight <= 0.0 || d2 <= 1e-36) { return LightSample(wi, d, vec3f(0.0), 0.0, NONE, 0.0); }
  let solidAngle = area * cosLight / d2;
  return LightSample(wi, d, vec3f(solidAngle), 1.0 / solidAngle, NONE, 0.0);
}

@if(POINT_LIGHTS)
fn samplePoint(p: vec3f, position: vec3f) -> LightSample {
  let toLight = position - p;
  let d2 = greater(dot(toLight, toLight), 1e-36);
  let d = sqrt(d2);
  return LightSample(toLight / d, d, vec3f(1.0 / d2), 0.0, NONE, 0.0);
}
