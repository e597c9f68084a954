// A ray never meets the surface it leaves at its own origin. Analytic primitives are flat or convex, so instead of
// moving the origin off the surface by an epsilon, the ray names the primitive it starts on and the intersectors leave
// that one out (flat, or convex seen from outside) or take only its far side (seen from inside). No scale enters.
import package::constants::{FAR, INSIDE, LEAST_COMPONENT, NONE};

struct Ray {
  o: vec3f,
  // Unit.
  d: vec3f,
  // 1/d, finite: see safeInverse.
  inverse: vec3f,
  // Primitive the ray starts on, with INSIDE set when it starts on the inner side; NONE in free space.
  source: u32,
}

struct Hit {
  t: f32,
  id: u32,
}

fn makeRay(o: vec3f, d: vec3f, source: u32) -> Ray {
  return Ray(o, d, safeInverse(d), source);
}

// 1/d with components at or near zero replaced, so that slab distances are huge but finite and never 0·inf.
fn safeInverse(d: vec3f) -> vec3f {
  return 1.0 / select(d, vec3f(LEAST_COMPONENT), abs(d) < vec3f(LEAST_COMPONENT));
}

fn noHit() -> Hit {
  return Hit(FAR, NONE);
}

// Keeps the nearer of `hit` and primitive `id` at `t`; any t <= 0 is a miss.
fn nearer(hit: Hit, t: f32, id: u32, ray: Ray) -> Hit {
  let closer = (t > 0.0) & (t < hit.t) & (id != ray.source);
  return Hit(select(hit.t, t, closer), select(hit.id, id, closer));
}

// Whether primitive `id` at `t` lies strictly between the ray's origin and the point at `distance`.
fn between(t: f32, distance: f32, id: u32, ray: Ray) -> bool {
  return (t > 0.0) & (t < distance) & (id != ray.source);
}

// The same ray as one that starts inside of closed primitive `id`: what it meets is the far side.
@if(HOLES)
fn innerRay(ray: Ray, id: u32) -> Ray {
  return Ray(ray.o, ray.d, ray.inverse, id | INSIDE);
}
