// Boxes, as one slab test in the box's own frame.
//
// [1] Kay, Kajiya 1986, "Ray Tracing Complex Scenes"
// [2] Ize 2013, "Robust BVH Ray Traversal", JCGT 2(2)
import package::constants::{INSIDE, NEAR};
import package::minMax::{greater, lesser};
import package::ray::{Ray, safeInverse};
import package::scene::cutoffOf;
import package::surfacePoint::primitiveOf;

// Rounding of the slab distances can let a ray slip between two faces; widening the exit closes the gap. [2] eq. 4
const SLAB_PADDING = 1.00000024;

// Axis-aligned box by centre and half size; distance to entry, or to exit from inside, <= 0 for a miss.
fn boxIntersect(ray: Ray, center: vec3f, halfSize: vec3f, id: u32) -> f32 {
  return slabs(center - ray.o, halfSize, ray.inverse, ray.source == (id | INSIDE));
}

// Box turned about the y axis by the angle whose cosine and sine are `turn`.
fn turnedBoxIntersect(ray: Ray, center: vec3f, halfSize: vec3f, turn: vec2f, id: u32) -> f32 {
  return slabs(turnBack(center - ray.o, turn), halfSize, safeInverse(turnBack(ray.d, turn)), ray.source == (id | INSIDE));
}

// `middle` is the way from the ray's origin to the box's centre, in the box's frame.
fn slabs(middle: vec3f, halfSize: vec3f, inverse: vec3f, fromInside: bool) -> f32 {
  // A face on which the origin lies is at distance 0, because ±halfSize is exact: whatever a compiler fuses, the sum is the
  // same. Of middle·inverse ± halfSize·|inverse| it fuses one product, and the rounding of the other remains.
  let ahead = halfSize * sign(inverse);
  let enter = (middle - ahead) * inverse;
  let leave = (middle + ahead) * inverse;
  let near = greater(greater(enter.x, enter.y), enter.z);
  let far = lesser(lesser(leave.x, leave.y), leave.z);
  let t = select(-1.0, select(near, far, near <= 0.0), near <= far * SLAB_PADDING);
  // From its inner side a box is always left again, also from an edge that rounding puts outside of another face.
  return select(t, greater(far, NEAR), fromInside);
}

// World to box: the inverse rotation.
fn turnBack(v: vec3f, turn: vec2f) -> vec3f {
  return vec3f(turn.x * v.x - turn.y * v.z, v.y, turn.y * v.x + turn.x * v.z);
}

// Box to world.
fn turnForth(v: vec3f, turn: vec2f) -> vec3f {
  return vec3f(turn.x * v.x + turn.y * v.z, v.y, turn.x * v.z - turn.y * v.x);
}

// Outward normal where a ray hits the box: that of the face the point is nearest to, in proportion to the box, among those
// that the ray can hit. Near an edge, where rounding decides which face is nearest, a face turned away would send the path
// to the wrong side of the surface.
fn boxNormal(ray: Ray, point: vec3f, center: vec3f, halfSize: vec3f, turn: vec2f, id: u32) -> vec3f {
  let local = turnBack(point - center, turn) / halfSize;
  // As in slabs(): a ray that starts on a face and meets the box goes through it.
  let isInside = (ray.source == (id | INSIDE)) | all(abs(turnBack(ray.o - center, turn)) <= halfSize);
  let leaving = turnBack(ray.d, turn) * local > vec3f(0.0);
  let met = leaving == vec3<bool>(isInside);
  @if(!HOLES) let size = select(vec3f(0.0), abs(local), met);
  // Rays may have passed the near side of a box with holes.
  @if(HOLES) let size = select(vec3f(0.0), abs(local), met | vec3<bool>(cutoffOf(primitiveOf(id)) != 0.0));
  let x = (size.x >= size.y) & (size.x >= size.z);
  let y = !x & (size.y >= size.z);
  return turnForth(sign(local) * vec3f(select(0.0, 1.0, x), select(0.0, 1.0, y), select(1.0, 0.0, x | y)), turn);
}
