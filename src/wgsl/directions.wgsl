// Directions from points in [0, 1)². Local frame, z = n.
import package::constants::{PI, TWO_PI};

// (cos φ, sin φ) for φ = 2π·turns, turns in [0, 1].
fn circle(turns: f32) -> vec2f {
  let phi = TWO_PI * turns;
  return vec2f(cos(phi), sin(phi));
}

// Density cos θ / π.
fn cosineHemisphere(u: vec2f) -> vec3f {
  return vec3f(sqrt(u.x) * circle(u.y), sqrt(1.0 - u.x));
}

// Density 1 / 2π.
fn uniformHemisphere(u: vec2f) -> vec3f {
  let z = 1.0 - u.x;
  return vec3f(sqrt(max(1.0 - z * z, 0.0)) * circle(u.y), z);
}

// Density 1 / 4π.
fn uniformSphere(u: vec2f) -> vec3f {
  let z = 1.0 - 2.0 * u.x;
  return vec3f(sqrt(max(1.0 - z * z, 0.0)) * circle(u.y), z);
}
