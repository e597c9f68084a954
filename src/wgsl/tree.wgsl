// What is not unrolled into the program: the triangles of meshes, and other shapes where there are many, in a binary tree of
// boxes.
//
// Nodes and items are in textures: a software adapter loads a texel's four words for little more than one word of a buffer,
// and graphics hardware has a cache for them. It has no vector shifts either: bytes stay where they are, and what multiplies
// them takes their place into account.
//
// [1] Aila, Laine 2009, "Understanding the Efficiency of Ray Traversal on GPUs"
// [2] Ize 2013, "Robust BVH Ray Traversal", JCGT 2(2)
// [3] Ylitie, Karras, Laine 2017, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs"
import package::constants::FAR;
import package::coverage::{betweenPart, entersPart, nearerPart};
import package::minMax::{greater, lesser};
import package::ray::{Hit, Ray, between, innerRay, nearer};
import package::scene::{PRIMITIVES, STACK_SIZE, itemIntersect, shapeOf};
import package::shapes::triangle::{Shear, shearOf};

// Two texels each, rows of 4096 nodes; see tree/packTree.ts. Written by the renderer when the geometry changes.
@group(0) @binding(5) var nodes: texture_2d<u32>;
// Three texels each, rows of 2048 slots; see tree/packItems.ts. Written by the renderer when the geometry changes.
@group(0) @binding(6) var items: texture_2d<u32>;

// Three vectors and a number, as the file of its kind packs them; of a triangle of a mesh its vertices, in the order of
// shapes/rims.ts.
struct Item {
  a: vec3f,
  b: vec3f,
  c: vec3f,
  w: f32,
  // The primitive it is, or is a part of.
  id: u32,
  kind: u32,
}

// Kinds of items, before those that shapes.ts numbers: a triangle of a mesh.
const MESH_TRIANGLE = 0u;
// Its vertices run clockwise seen from its front.
const TURNED_TRIANGLE = 1u;

// A link is the index of a node, or LEAF, how many items the leaf has and the slot of the first.
const LEAF = 0x80000000u;
const COUNT_SHIFT = 24u;
const ONE_ITEM = 1u << COUNT_SHIFT;
const SLOT_MASK = 0x00ffffffu;
// A leaf of nothing: where every ray ends.
const NOTHING = LEAF;

// A box is met if the ray enters it before it leaves all its slabs, but for the rounding of these operations and of 1/d,
// 2.5 ULP. [2] What rounding moves a slab that lies near the ray's origin is less than boxes are larger than what they hold.
const PADDING = 1.0000019;

// Links that wait for their turn, `waiting` of them.
var<private> stack: array<u32, STACK_SIZE>;
var<private> waiting: u32;

fn itemAt(slot: u32) -> Item {
  let at = vec2u(3u * (slot & 2047u), slot >> 11u);
  let a = textureLoad(items, at, 0);
  let b = textureLoad(items, at + vec2u(1u, 0u), 0);
  let c = textureLoad(items, at + vec2u(2u, 0u), 0);
  return Item(bitcast<vec3f>(a.xyz), bitcast<vec3f>(b.xyz), bitcast<vec3f>(c.xyz), bitcast<f32>(c.w), a.w, b.w);
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
      @if(!TREE_HOLES) hit = nearer(hit, itemIntersect(ray, shear, slot, id), id, ray);
      @if(TREE_HOLES && !TREE_CLOSED) hit = nearerPart(hit, itemIntersect(ray, shear, slot, id), id, ray);
      @if(TREE_HOLES && TREE_CLOSED) {
        for (var side = 0u; side < 2u; side++) { hit = nearerPart(hit, sideOf(ray, shear, slot, id, side), id, ray); }
      }
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
      @if(!TREE_HOLES) blocked |= between(itemIntersect(ray, shear, slot, id), distance, id, ray) & (id != target_);
      @if(TREE_HOLES && !TREE_CLOSED) blocked |= betweenPart(itemIntersect(ray, shear, slot, id), distance, id, ray) & (id != target_);
      @if(TREE_HOLES && TREE_CLOSED) {
        for (var side = 0u; side < 2u; side++) {
          blocked |= betweenPart(sideOf(ray, shear, slot, id, side), distance, id, ray) & (id != target_);
        }
      }
    }
    if (blocked) { break; }
    link = nextWaiting(NOTHING, true);
  }
  return blocked;
}

// Where a ray meets an item's near side, 0, and where it leaves a closed one that it may have entered, 1; not positive if it does not.
// One function of both, so that what they lead to is in a program once.
@if(TREE_HOLES && TREE_CLOSED)
fn sideOf(ray: Ray, shear: Shear, slot: u32, id: u32, side: u32) -> f32 {
  let near = itemIntersect(ray, shear, slot, id);
  if (side == 0u) { return near; }
  let item = itemAt(slot);
  let isFlat = item.kind <= TURNED_TRIANGLE || shapeOf(item.id).w == 0.0;
  if (isFlat || !entersPart(ray, near, id)) { return -1.0; }
  return itemIntersect(innerRay(ray, id), shear, slot, id);
}

// The nearest leaf in or after `start` whose box the ray enters before `limit`. [1]
fn nextLeaf(ray: Ray, start: u32, limit: f32) -> u32 {
  var link = start;
  loop {
    if ((link & LEAF) != 0u) { break; }
    let at = vec2u(2u * (link & 4095u), link >> 12u);
    let node = textureLoad(nodes, at, 0);
    let boxes = textureLoad(nodes, at + vec2u(1u, 0u), 0);

    // Distances along the ray to the node's corner, and per step of its grid. [3] section 4.3
    let corner = (bitcast<vec3f>(node.xyz) - ray.o) * ray.inverse;
    let exponents = (vec3u(boxes.w) & vec3u(0x7f80u, 0x7f8000u, 0x7f800000u)) * vec3u(0x10000u, 0x100u, 1u);
    let step = bitcast<vec3f>(exponents) * ray.inverse;
    let halfStep = abs(0.5 * step);
    let bytes = bitcast<vec3i>(boxes.xyz);
    let half0 = vec3f(bytes & vec3i(0xff)) * halfStep;
    let middle0 = vec3f(bytes & vec3i(0xff00)) * (0x1p-8 * step);
    let half1 = vec3f(bytes & vec3i(0xff0000)) * (0x1p-16 * halfStep);
    let middle1 = vec3f(bytes & vec3i(-0x1000000)) * (0x1p-24 * step) + 128.0 * step;
    let t0 = enter(corner + middle0, half0, limit);
    let t1 = enter(corner + middle1, half1, limit);

    let count0 = boxes.w & 7u;
    let count1 = boxes.w & 56u;
    let isLeaf0 = count0 != 0u;
    let leaf0 = LEAF | (count0 * ONE_ITEM) | node.w;
    let leaf1 = LEAF | (count1 * (ONE_ITEM / 8u)) | (node.w + count0);
    let link0 = select(link + 1u, leaf0, isLeaf0);
    let link1 = select(select(node.w, link + 1u, isLeaf0), leaf1, count1 != 0u);

    let isFirst = t0 <= t1;
    let meets0 = t0 < FAR;
    let meets1 = t1 < FAR;
    stack[waiting] = select(link0, link1, isFirst);
    waiting += select(0u, 1u, meets0 & meets1);
    link = nextWaiting(select(link1, link0, isFirst), !(meets0 | meets1));
  }
  return link;
}

// Distance at which a ray enters a box; FAR if it does not, or not before `limit`. The box by the distances to the middles of its
// slabs and half their thickness along the ray.
fn enter(middle: vec3f, half: vec3f, limit: f32) -> f32 {
  let enters = middle - half;
  let leaves = middle + half;
  let near = greater(greater(enters.x, enters.y), greater(enters.z, 0.0));
  let far = lesser(lesser(leaves.x, leaves.y), lesser(leaves.z, limit));
  return select(FAR, near, near <= far * PADDING);
}

// The link itself or, where it leads nowhere, the last of those that wait.
fn nextWaiting(link: u32, isDone: bool) -> u32 {
  let isEmpty = waiting == 0u;
  waiting -= select(0u, 1u, isDone & !isEmpty);
  return select(link, select(stack[waiting], NOTHING, isEmpty), isDone);
}
