// Surfaces that are there in part: a ray meets one with the probability that its alpha tells, or passes. Shadow rays do the same, so
// that leaves cast the shadows of leaves.
//
// Of what is there a clear wall lets some light pass straight. A path does so by chance; of light from a lamp, which goes
// through all walls on its way, each takes its share.
import package::basis::{frameAround, toLocal};
import package::lobes::fresnel::transmittanceAt;
import package::minMax::greatest;
import package::ray::{Hit, Ray, between};
import package::sampler::{Sampler, pcg3d, unitInterval};
import package::scene::{PRIMITIVES, coverageOf, coverTextureOf, cutoffOf, isClearOf, layersThrough, occluded};
import package::shapes::mesh::{colorOn, consistentNormal, uvAt};
import package::surface::{bsdfOf, coatNormal};
import package::surfacePoint::{SurfacePoint, primitiveOf, surfacePoint};
import package::textures::alphaAt;
import package::tree::{Item, TURNED_TRIANGLE, itemAt};
import package::constants::NONE;
import package::uvs::Uvs;

// What the next ray's chances come from. Each surface on its way has its own, by its number and distance.
var<private> chances: vec2u;

// Of a clear wall, in place of the cutoff of a mask. As in lobes/coverage.ts.
const CLEAR = -2.0;

fn drawCoverage(samples: Sampler, dimension: u32) {
  chances = vec2u(samples.seed ^ (dimension * 0x9e3779b9u), samples.index);
}

// As nearer(), of a surface with holes.
fn nearerPart(hit: Hit, t: f32, id: u32, ray: Ray) -> Hit {
  @if(!CLEAR_WALLS) let meets = between(t, hit.t, id, ray) && isCovered(ray, t, id);
  @if(CLEAR_WALLS) let meets = between(t, hit.t, id, ray) && isCovered(ray, t, id) && !passesWall(ray, t, id);
  if (meets) { return Hit(t, id); }
  return hit;
}

// As between(), of a surface with holes.
fn betweenPart(t: f32, distance: f32, id: u32, ray: Ray) -> bool {
  @if(!CLEAR_WALLS) return between(t, distance, id, ray) && isCovered(ray, t, id);
  @if(CLEAR_WALLS) return between(t, distance, id, ray) && isCovered(ray, t, id) && !shinesThrough(ray, t, id);
}

// Whether a ray that meets a closed surface with holes at t gets in there, and so may meet its far side.
fn entersPart(ray: Ray, t: f32, id: u32) -> bool {
  return t > 0.0 && surfacePoint(ray, Hit(t, id)).front;
}

// What the clear walls that occluded() has met let through: of light on its way; and, of what is left of a path that passed them, its
// colour.
@if(CLEAR_WALLS)
var<private> clearness: vec3f;
@if(COLORED_WALLS)
var<private> tint: vec3f;

// Whether a path passes the wall.
@if(CLEAR_WALLS)
fn passesWall(ray: Ray, t: f32, id: u32) -> bool {
  @if(PICK) return false;
  @if(!PICK) {
    let chance = greatest(wallAt(ray, t, id));
    return unitInterval(pcg3d(vec3u(chances.x ^ (id * 0x85ebca6bu), chances.y, bitcast<u32>(t))).y) < chance;
  }
}

// Whether light passes the wall; counts what it leaves there.
@if(CLEAR_WALLS)
fn shinesThrough(ray: Ray, t: f32, id: u32) -> bool {
  let through = wallAt(ray, t, id);
  clearness *= through;
  @if(COLORED_WALLS) tint *= through / select(1.0, greatest(through), greatest(through) > 0.0);
  return any(through > vec3f(0.0));
}

// What a wall lets pass straight of the light along a ray; nothing if it is none.
@if(CLEAR_WALLS)
fn wallAt(ray: Ray, t: f32, id: u32) -> vec3f {
  if (isClearOf(primitiveOf(id)) == 0.0) { return vec3f(0.0); }
  return throughWall(ray, surfacePoint(ray, Hit(t, id)));
}

@if(CLEAR_WALLS)
fn throughWall(ray: Ray, found: SurfacePoint) -> vec3f {
  if (isClearOf(found.id) == 0.0) { return vec3f(0.0); }
  // As it is met: what it reflects and what it lets through are of one normal, or they would be more together than there is.
  let side = select(-1.0, 1.0, found.front);
  var n = side * found.n;
  @if(SHADING_NORMALS) n = select(n, consistentNormal(side * found.shading, n, -ray.d), found.isTriangle);
  @if(!COAT_NORMAL) let wo = vec3f(0.0, 0.0, abs(dot(ray.d, n)));
  @if(COAT_NORMAL) let frame = frameAround(n);
  @if(COAT_NORMAL) let wo = toLocal(frame, -ray.d);
  @if(COAT_NORMAL) coatNormal = toLocal(frame, consistentNormal(side * found.coatN, side * found.n, -ray.d));
  var uv = Uvs(0.0);
  @if(TEXTURES) uv = found.uv;
  var color = vec3f(1.0);
  @if(COLORS) color = found.color.rgb;
  let bsdf = bsdfOf(found.id, wo, uv, color);
  let passes = bsdf.transmitted * transmittanceAt(bsdf, wo.z);
  @if(!COAT && !SHEEN) return passes;
  @if(COAT || SHEEN) return passes * layersThrough(bsdf, wo, -wo);
}

// A path that met a wall did so for all that would have met it.
@if(CLEAR_WALLS)
fn oddsOf(ray: Ray, found: SurfacePoint) -> f32 {
  let met = 1.0 - greatest(throughWall(ray, found));
  return select(0.0, 1.0 / met, met > 0.0);
}

// How the walls that a path has passed on its way to what it met have coloured it.
@if(COLORED_WALLS)
fn tintBefore(ray: Ray, distance: f32) -> vec3f {
  tint = vec3f(1.0);
  let met = occluded(ray, distance, NONE);
  return tint;
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
    @if(CLEAR_WALLS) if (cutoff == CLEAR) { return true; }
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
