// min() and max() of numbers that are not NaN: on a software adapter those of WGSL take twenty instructions, for the NaN.

fn lesser(a: f32, b: f32) -> f32 {
  return select(b, a, a < b);
}

fn greater(a: f32, b: f32) -> f32 {
  return select(b, a, a > b);
}

// The greatest of three.
fn greatest(c: vec3f) -> f32 {
  return greater(greater(c.x, c.y), c.z);
}
