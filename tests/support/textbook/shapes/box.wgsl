// The textbook's slabs.
import package::constants::INSIDE;
import package::ray::Ray;

fn boxIntersect(ray: Ray, center: vec3f, halfSize: vec3f, id: u32) -> f32 {
  return slabs(center - halfSize - ray.o, center + halfSize - ray.o, ray.d);
}

fn turnedBoxIntersect(ray: Ray, center: vec3f, halfSize: vec3f, turn: vec2f, id: u32) -> f32 {
  let local = turnBack(center - ray.o, turn);
  return slabs(local - halfSize, local + halfSize, turnBack(ray.d, turn));
}

fn slabs(low: vec3f, high: vec3f, d: vec3f) -> f32 {
  let a = low / d;
  let b = high / d;
  let enter = min(a, b);
  let leave = max(a, b);
  let near = max(max(enter.x, enter.y), enter.z);
  let far = min(min(leave.x, leave.y), leave.z);
  return select(-1.0, select(near, far, near <= 1e-4), near <= far);
}

fn turnBack(v: vec3f, turn: vec2f) -> vec3f {
  return vec3f(turn.x * v.x - turn.y * v.z, v.y, turn.y * v.x + turn.x * v.z);
}

fn turnForth(v: vec3f, turn: vec2f) -> vec3f {
  return vec3f(turn.x * v.x + turn.y * v.z, v.y, turn.x * v.z - turn.y * v.x);
}

fn boxNormal(ray: Ray, point: vec3f, center: vec3f, halfSize: vec3f, turn: vec2f, id: u32) -> vec3f {
  let local = turnBack(point - center, turn) / halfSize;
  let size = abs(local);
  let x = size.x >= max(size.y, size.z);
  let y = !x & (size.y >= size.z);
  return turnForth(sign(local) * vec3f(select(0.0, 1.0, x), select(0.0, 1.0, y), select(1.0, 0.0, x | y)), turn);
}
