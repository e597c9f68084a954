// The textbook's rays: they start anywhere, and hits closer than a fixed epsilon do not count.
import package::constants::{FAR, NONE};

const EPSILON = 1e-4;

struct Ray {
  o: vec3f,
  d: vec3f,
  inverse: vec3f,
  source: u32,
}

struct Hit {
  t: f32,
  id: u32,
}

fn makeRay(o: vec3f, d: vec3f, source: u32) -> Ray {
  return Ray(o, d, 1.0 / d, source);
}

fn safeInverse(d: vec3f) -> vec3f {
  return 1.0 / d;
}

fn noHit() -> Hit {
  return Hit(FAR, NONE);
}

fn nearer(hit: Hit, t: f32, id: u32, ray: Ray) -> Hit {
  let closer = (t > EPSILON) & (t < hit.t);
  return Hit(select(hit.t, t, closer), select(hit.id, id, closer));
}

fn between(t: f32, distance: f32, id: u32, ray: Ray) -> bool {
  return (t > EPSILON) & (t < distance - EPSILON);
}
