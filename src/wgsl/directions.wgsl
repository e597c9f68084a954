// Directions from points in [0, 1)². Local frame, z = n.
import package::minMax::greater;

// (cos φ, sin φ) for φ = 2π·turns, turns in [0, 1], to 8·2⁻²³. WGSL's own may be off by 2⁻¹¹, and are by 2e-4 on a software
// adapter: directions would not be unit, and points not on their sphere.
fn circle(turns: f32) -> vec2f {
  // Sine and cosine of φ/2 − π/2, by minimax polynomials, doubled.
  let x = turns - 0.5;
  let x2 = x * x;
  let s = x * (3.14159258 + x2 * (-5.16770688 + x2 * (2.55003138 + x2 * (-0.59804517 + x2 * 0.07722013))));
  let c = 0.99999995 + x2 * (-4.93479286 + x2 * (4.05841191 + x2 * (-1.33188016 + x2 * 0.2196968)));
  return vec2f(2.0 * s * s - 1.0, -2.0 * s * c);
}

// Density cos θ / π.
fn cosineHemisphere(u: vec2f) -> vec3f {
  return vec3f(sqrt(u.x) * circle(u.y), sqrt(1.0 - u.x));
}

// Density 1 / 2π.
fn uniformHemisphere(u: vec2f) -> vec3f {
  let z = 1.0 - u.x;
  return vec3f(sqrt(greater(1.0 - z * z, 0.0)) * circle(u.y), z);
}

// Density 1 / 4π.
fn uniformSphere(u: vec2f) -> vec3f {
  let z = 1.0 - 2.0 * u.x;
  return vec3f(sqrt(greater(1.0 - z * z, 0.0)) * circle(u.y), z);
}
