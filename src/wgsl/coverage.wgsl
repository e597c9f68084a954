// Surfaces that are there in part: a ray meets one with the probability that its alpha tells, or passes. Shadow rays do the same, so
// that leaves cast the shadows of leaves.
import package::ray::{Hit, Ray, between};
import package::sampler::{Sampler, pcg3d, unitInterval};
import package::scene::{PRIMITIVES, coverageOf, coverTextureOf, cutoffOf};
import package::shapes::mesh::{colorOn, uvAt};
import package::textures::alphaAt;
import package::tree::{Item, TURNED_TRIANGLE, itemAt};

// What the next ray's chances come from. Each surface on its way has its own, by its number and distance.
var<private> chances: vec2u;

fn drawCoverage(samples: Sampler, dimension: u32) {
  chances = vec2u(samples.seed ^ (dimension * 0x9e3779b9u), samples.index);
}

// As nearer(), of a surface with holes.
fn nearerPart(hit: Hit, t: f32, id: u32, ray: Ray) -> Hit {
  if (between(t, hit.t, id, ray) && isCovered(ray, t, id)) { return Hit(t, id); }
  return hit;
}

// As between(), of a surface with holes.
fn betweenPart(t: f32, distance: f32, id: u32, ray: Ray) -> bool {
  return between(t, distance, id, ray) && isCovered(ray, t, id);
}

// Whether the ray meets surface `id` at t.
fn isCovered(ray: Ray, t: f32, id: u32) -> bool {
  @if(!TREE) return decides(coverageOf(id), cutoffOf(id), t, id);
  @if(TREE) {
    if (id < PRIMITIVES) { return decides(coverageOf(id), cutoffOf(id), t, id); }
    let slot = id - PRIMITIVES;
    let item = itemAt(slot);
    let cutoff = cutoffOf(item.id);
    if (cutoff == 0.0) { return true; }
    var alpha = coverageOf(item.id);
    @if(ALPHA_TEXTURES || COLORS) {
      // Of shapes only meshes have vertices.
      if (item.kind <= TURNED_TRIANGLE) {
        let weights = weightsAt(ray, t, item);
        @if(ALPHA_TEXTURES) alpha *= alphaAt(coverTextureOf(item.id), uvAt(slot, weights));
        @if(COLORS) alpha *= colorOn(slot, weights).a;
      }
    }
    return decides(alpha, cutoff, t, id);
  }
}

// Whether a surface of this alpha is there.
fn decides(alpha: f32, cutoff: f32, t: f32, id: u32) -> bool {
  if (cutoff > 0.0) { return alpha >= cutoff; }
  @if(PICK) return alpha >= 0.5;
  @if(!PICK) return unitInterval(pcg3d(vec3u(chances.x ^ (id * 0x85ebca6bu), chances.y, bitcast<u32>(t))).x) < alpha;
}

// Barycentric coordinates of where the ray meets a triangle of a mesh.
@if(ALPHA_TEXTURES || COLORS)
fn weightsAt(ray: Ray, t: f32, item: Item) -> vec3f {
  let e1 = item.b - item.a;
  let e2 = item.c - item.a;
  let q = ray.o + t * ray.d - item.a;
  // In the plane of the two axes along which the triangle is widest.
  let n = cross(e1, e2);
  let size = abs(n);
  let isX = (size.x >= size.y) & (size.x >= size.z);
  let isY = !isX & (size.y >= size.z);
  let area = select(select(n.z, n.y, isY), n.x, isX);
  let b = select(select(cross2(q.xy, e2.xy), cross2(q.zx, e2.zx), isY), cross2(q.yz, e2.yz), isX);
  let c = select(select(cross2(e1.xy, q.xy), cross2(e1.zx, q.zx), isY), cross2(e1.yz, q.yz), isX);
  return select(vec3f(1.0 - (b + c) / area, b / area, c / area), vec3f(1.0, 0.0, 0.0), area == 0.0);
}

fn cross2(a: vec2f, b: vec2f) -> f32 {
  return a.x * b.y - a.y * b.x;
}
