// Orthonormal frame around a normal.
//
// [1] Duff et al. 2017, "Building an Orthonormal Basis, Revisited", JCGT 6(1)

struct Frame {
  t: vec3f,
  b: vec3f,
  n: vec3f,
}

// [1] listing 3
fn frameAround(n: vec3f) -> Frame {
  let s = select(-1.0, 1.0, n.z >= 0.0);
  let a = -1.0 / (s + n.z);
  let b = n.x * n.y * a;
  return Frame(vec3f(1.0 + s * n.x * n.x * a, s * b, -s * n.x), vec3f(b, s + n.y * n.y * a, -n.y), n);
}

// The frame whose t is as close to a direction as can be: any where the two are parallel.
fn frameAlong(direction: vec3f, n: vec3f) -> Frame {
  let t = direction - dot(direction, n) * n;
  let size = length(t);
  if (size < 1e-6) { return frameAround(n); }
  let unit = t / size;
  return Frame(unit, cross(n, unit), n);
}

fn toLocal(frame: Frame, v: vec3f) -> vec3f {
  return vec3f(dot(v, frame.t), dot(v, frame.b), dot(v, frame.n));
}

fn toWorld(frame: Frame, v: vec3f) -> vec3f {
  return v.x * frame.t + v.y * frame.b + v.z * frame.n;
}
