// What is not unrolled into the program: the triangles of meshes, and other shapes where there are many, in a binary tree of
// boxes.
//
// Nodes and items are in textures: a software adapter loads a texel's four words for little more than one word of a buffer,
// and graphics hardware has a cache for them.
//
// [1] Aila, Laine 2009, "Understanding the Efficiency of Ray Traversal on GPUs"
// [2] Ize 2013, "Robust BVH Ray Traversal", JCGT 2(2)
import package::box::turnedBoxIntersect;
import package::constants::FAR;
import package::planar::{Shear, quadIntersect, shearOf, triangleIntersect};
import package::ray::{Hit, Ray, between, nearer};
import package::sphere::sphereIntersect;
import package::scene::{PRIMITIVES, STACK_SIZE};

// Four texels each, rows of 8192; see compile/packTree.ts. Written by the renderer when the geometry changes.
@group(0) @binding(5) var nodes: texture_2d<u32>;
// Three texels each, rows of 8192, by slot; see compile/packItems.ts. Written by the renderer when the geometry changes.
@group(0) @binding(6) var items: texture_2d<u32>;

// A triangle: its vertices, in the order of compile/rims.ts. A sphere: centre and, in w, radius. A quad: centre, dual vectors of
// its half edges and, in w, the length of the longer one. A box: centre, half size, cosine and sine of its turn.
struct Item {
  a: vec3f,
  b: vec3f,
  c: vec3f,
  w: f32,
  // The primitive it is, or is a part of.
  id: u32,
  kind: u32,
}

const MESH_TRIANGLE = 0u;
// Its vertices run clockwise seen from its front.
const TURNED_TRIANGLE = 1u;
const TRIANGLE = 2u;
const SPHERE = 3u;
const QUAD = 4u;
const BOX = 5u;

// A link is the index of a node, or LEAF, how many items the leaf has and the slot of the first.
const LEAF = 0x80000000u;
const COUNT_SHIFT = 27u;
const SLOT_MASK = 0x07ffffffu;
// A leaf of nothing: where every ray ends.
const NOTHING = LEAF;

// A box is met if the ray enters it before it leaves all its slabs, but for the rounding of these operations and of 1/d,
// 2.5 ULP. [2]
const PADDING = 1.0000019;

// Links that wait for their turn, `waiting` of them.
var<private> stack: array<u32, STACK_SIZE>;
var<private> waiting: u32;

fn itemAt(slot: u32) -> Item {
  let a = texel(items, 3u * slot);
  let b = texel(items, 3u * slot + 1u);
  let c = texel(items, 3u * slot + 2u);
  return Item(bitcast<vec3f>(a.xyz), bitcast<vec3f>(b.xyz), bitcast<vec3f>(c.xyz), bitcast<f32>(c.w), a.w, b.w);
}

// Distance to an item that a ray would name `id`, not positive for a miss.
fn itemIntersect(ray: Ray, shear: Shear, slot: u32, id: u32) -> f32 {
  let item = itemAt(slot);
  var t = -1.0;
  @if(TREE_TRIANGLES) t = triangleIntersect(shear, item.a, item.b, item.c);
  @if(TREE_SPHERES) t = select(t, sphereIntersect(ray, item.a, item.w, id), item.kind == SPHERE);
  @if(TREE_QUADS) t = select(t, quadIntersect(ray, item.a, cross(item.b, item.c), item.b, item.c, item.w), item.kind == QUAD);
  @if(TREE_BOXES) t = select(t, turnedBoxIntersect(ray, item.a, item.b, item.c.xy, id), item.kind == BOX);
  return t;
}

fn texel(texture: texture_2d<u32>, index: u32) -> vec4u {
  return textureLoad(texture, vec2u(index & 8191u, index >> 13u), 0);
}

// The nearer of `found` and what the ray meets in the tree.
fn treeClosest(ray: Ray, found: Hit) -> Hit {
  let shear = shearOf(ray);
  var hit = found;
  var link = 0u;
  waiting = 0u;
  loop {
    link = nextLeaf(ray, link, hit.t);
    if (link == NOTHING) { break; }
    let first = link & SLOT_MASK;
    let end = first + ((link & ~LEAF) >> COUNT_SHIFT);
    for (var slot = first; slot < end; slot++) {
      let id = PRIMITIVES + slot;
      hit = nearer(hit, itemIntersect(ray, shear, slot, id), id, ray);
    }
    link = nextWaiting(NOTHING, true);
  }
  return hit;
}

// Whether something in the tree other than `target_` lies between the ray's origin and the point at `distance`.
fn treeOccludes(ray: Ray, distance: f32, target_: u32) -> bool {
  let shear = shearOf(ray);
  var blocked = false;
  var link = 0u;
  waiting = 0u;
  loop {
    link = nextLeaf(ray, link, distance);
    if (link == NOTHING) { break; }
    let first = link & SLOT_MASK;
    let end = first + ((link & ~LEAF) >> COUNT_SHIFT);
    for (var slot = first; slot < end; slot++) {
      let id = PRIMITIVES + slot;
      blocked |= between(itemIntersect(ray, shear, slot, id), distance, id, ray) & (id != target_);
    }
    if (blocked) { break; }
    link = nextWaiting(NOTHING, true);
  }
  return blocked;
}

// The nearest leaf in or after `start` whose box the ray enters before `limit`. [1]
fn nextLeaf(ray: Ray, start: u32, limit: f32) -> u32 {
  var link = start;
  loop {
    if ((link & LEAF) != 0u) { break; }
    let lower0 = texel(nodes, 4u * link);
    let upper0 = texel(nodes, 4u * link + 1u);
    let lower1 = texel(nodes, 4u * link + 2u);
    let upper1 = texel(nodes, 4u * link + 3u);
    let t0 = enter(ray, bitcast<vec3f>(lower0.xyz), bitcast<vec3f>(upper0.xyz), limit);
    let t1 = enter(ray, bitcast<vec3f>(lower1.xyz), bitcast<vec3f>(upper1.xyz), limit);
    let isFirst = t0 <= t1;
    stack[waiting] = select(lower0.w, upper0.w, isFirst);
    waiting += select(0u, 1u, max(t0, t1) < FAR);
    link = nextWaiting(select(upper0.w, lower0.w, isFirst), min(t0, t1) >= FAR);
  }
  return link;
}

// Distance at which a ray enters a box; FAR if it does not, or not before `limit`.
fn enter(ray: Ray, lower: vec3f, upper: vec3f, limit: f32) -> f32 {
  let toLower = (lower - ray.o) * ray.inverse;
  let toUpper = (upper - ray.o) * ray.inverse;
  let enters = min(toLower, toUpper);
  let leaves = max(toLower, toUpper);
  let near = max(max(enters.x, enters.y), max(enters.z, 0.0));
  let far = min(min(leaves.x, leaves.y), leaves.z);
  return select(FAR, near, (near <= far * PADDING) & (near <= limit * PADDING));
}

// The link itself or, where it leads nowhere, the last of those that wait.
fn nextWaiting(link: u32, isDone: bool) -> u32 {
  let isEmpty = waiting == 0u;
  waiting -= select(0u, 1u, isDone & !isEmpty);
  return select(link, select(stack[waiting], NOTHING, isEmpty), isDone);
}
