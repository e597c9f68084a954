// Shows the film: mean radiance, exposed, tone-mapped, sRGB-encoded.
import package::tonemap::{acesFitted, encodeSrgb};

struct View {
  filmSize: vec2u,
  targetSize: vec2u,
  // Factor on radiance.
  exposure: f32,
}

@group(0) @binding(0) var<uniform> view: View;
// Radiance sums and sample counts, half 0 then half 1.
@group(0) @binding(1) var<storage, read> film: array<vec4f>;

@vertex
fn coverTarget(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
  return vec4f(vec2f(vec2u(index << 1u, index) & vec2u(2u)) * 2.0 - 1.0, 0.0, 1.0);
}

@fragment
fn show(@builtin(position) position: vec4f) -> @location(0) vec4f {
  let pixel = min(vec2u(position.xy * vec2f(view.filmSize) / vec2f(view.targetSize)), view.filmSize - 1u);
  let index = pixel.y * view.filmSize.x + pixel.x;
  let sum = film[index] + film[view.filmSize.x * view.filmSize.y + index];
  let radiance = sum.rgb / max(sum.w, 1.0);
  return vec4f(encodeSrgb(acesFitted(radiance * view.exposure)), 1.0);
}
