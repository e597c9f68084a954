// From linear Rec. 709 radiance to display values.
//
// [1] Hill 2017, "BakingLab", ACES.hlsl: a fit of the ACES reference rendering and output transforms
// [2] IEC 61966-2-1, sRGB

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
