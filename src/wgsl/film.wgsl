// Sums of any number of samples that stay as exact as f32 is.
//
// A plain f32 sum of a constant sky rounds every sample in the same direction, by up to half a ULP of the sum: after 10⁶
// samples it is off by per cents, and after 2²⁴ it stands still. Here a sum has two parts: `sum`, a multiple of a unit of
// 2 to 4 ULP of itself, and `carry`, what is left below that unit, kept for the next time as a 16-bit share.
// Readers need `sum` only.
//
// No error-free transformation, for compilers may reassociate: units are powers of two, so products with them and
// differences from their multiples are exact whatever the rounding.

struct FilmPixel {
  // Not negative; w counts samples, up to 2²⁴: see renderer/settings.ts.
  sum: vec4f,
  // Three unorm16 shares of quantum(sum).
  carry: vec2u,
}

// Adds one dispatch's samples. Each call loses at most 2⁻¹⁵ ULP of the sum, and half a ULP of the samples.
fn filmAdd(pixel: FilmPixel, samples: vec4f) -> FilmPixel {
  let before = pixel.sum.rgb;
  let share = vec3f(unpack2x16unorm(pixel.carry.x), unpack2x16unorm(pixel.carry.y).x);
  let fresh = samples.rgb + share * quantum(before);
  let unit = 0.5 * quantum(before + fresh);
  let perUnit = inverse(unit);
  // A sum that grows into the next binade is no multiple of its unit any more: the difference is carried too.
  let kept = floor(before * perUnit) * unit;
  let rest = fresh + (before - kept);
  let moved = floor(rest * perUnit) * unit;
  let sum = kept + moved;
  let left = (rest - moved) * inverse(quantum(sum));
  let carry = vec2u(pack2x16unorm(left.xy), pack2x16unorm(vec2f(left.z, 0.0)));
  return FilmPixel(vec4f(sum, pixel.sum.w + samples.w), carry);
}

// 4 ULP of a sum, a power of two, half of which is a normal number.
fn quantum(sum: vec3f) -> vec3f {
  let exponent = max(bitcast<vec3u>(sum) & vec3u(0x7f800000u), vec3u(23u << 23u));
  return bitcast<vec3f>(exponent - vec3u(21u << 23u));
}

// 1/x, exactly, for a power of two.
fn inverse(x: vec3f) -> vec3f {
  return bitcast<vec3f>(vec3u(254u << 23u) - bitcast<vec3u>(x));
}
