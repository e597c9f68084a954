// From linear Rec. 709 radiance to display values.
//
// [1] Hill 2017, "BakingLab", ACES.hlsl: a fit of the ACES reference rendering and output transforms
// [2] IEC 61966-2-1, sRGB
// [3] Sobotka 2022, "AgX", https://github.com/sobotka/AgX
// [4] Wrensch 2023, "Minimal AgX Implementation", https://iolite-engine.com/blog_posts/minimal_agx_implementation

// The place of a tone map in TONE_MAPS of `gpu/blitPass.ts`.
const TONE_ACES = 1u;
const TONE_AGX = 2u;

// What a display is sent. Any other kind than the two is linear up to 1, and 1 beyond.
fn displayed(radiance: vec3f, toneMap: u32) -> vec3f {
  switch toneMap {
    case TONE_ACES: { return encodeSrgb(acesFitted(radiance)); }
    case TONE_AGX: { return agxEncoded(radiance); }
    default: { return encodeSrgb(saturate(radiance)); }
  }
}

// [1]
fn acesFitted(color: vec3f) -> vec3f {
  let toRrt = mat3x3f(0.59719, 0.07600, 0.02840, 0.35458, 0.90834, 0.13383, 0.04823, 0.01566, 0.83777);
  let toDisplay = mat3x3f(1.60475, -0.10208, -0.00327, -0.53108, 1.10813, -0.07276, -0.07367, -0.00605, 1.07602);
  let v = toRrt * min(color, vec3f(1e4)); // the fit is 1 there; beyond, its squares would overflow
  let fitted = (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081);
  return saturate(toDisplay * fitted);
}

// [2]
fn encodeSrgb(linear: vec3f) -> vec3f {
  return select(1.055 * pow(max(linear, vec3f(0.0031308)), vec3f(1.0 / 2.4)) - 0.055, 12.92 * linear, linear <= vec3f(0.0031308));
}

// [3], as [4] fits it: the mean squared error of its curve is 3.7e-6. The result is encoded for a display already.
fn agxEncoded(color: vec3f) -> vec3f {
  let inset = mat3x3f(
    0.842479062, 0.0423282423, 0.0423756549,
    0.0784336000, 0.8784686365, 0.0784336000,
    0.0792237451, 0.0791661275, 0.8791429738,
  );
  let outset = mat3x3f(
    1.1968790051, -0.0528968518, -0.0529716355,
    -0.0980208811, 1.1519031299, -0.0980434501,
    -0.0990297441, -0.0989611768, 1.1510736726,
  );
  // Stops around middle grey; both ends of the range are far from where a logarithm of f32 fails.
  let stops = log2(clamp(inset * color, vec3f(exp2(-12.47393)), vec3f(exp2(4.026069))));
  let x = (stops + 12.47393) / (12.47393 + 4.026069);
  let x2 = x * x;
  let x4 = x2 * x2;
  let curve = 15.5 * x4 * x2 - 40.14 * x4 * x + 31.96 * x4 - 6.868 * x2 * x + 0.4298 * x2 + 0.1191 * x - 0.00232;
  return saturate(outset * curve);
}
