// Sheen: fibres that stand off a surface, the "Charlie" distribution of [1], as in KHR_materials_sheen.
//
// Directions are unit, in the local frame (z = n), both above the surface. wo points to the viewer, wi to the light.
//
// [1] Estevez, Kulla 2017, "Production Friendly Microfacet Sheen BRDF"
import package::constants::INV_PI;
import package::lobes::fresnel::luminance;
import package::lobes::lobe::{BsdfValue, Directions, LEAST_COSINE};
import package::minMax::{greater, greatest, lesser};
import package::scene::Bsdf;

fn sheenShare(bsdf: Bsdf) -> f32 {
  return luminance(bsdf.sheenColor) * lesser(bsdf.sheenAlbedo, 1.0);
}

// Closer to the surface the masking of [1] no longer outdoes 1/cos, and fibres would reflect any amount of light.
const LEAST_SLANT = 1e-4;

fn sheenValue(bsdf: Bsdf, at: Directions) -> BsdfValue {
  let cosO = greater(at.wo.z, LEAST_SLANT);
  let cosI = greater(at.wi.z, LEAST_SLANT);
  let alpha = bsdf.sheenRoughness * bsdf.sheenRoughness;
  let wm = normalize(at.wo + at.wi);
  // At grazing angles the fibres of [1] reflect more light than there is.
  let most = greater(greater(bsdf.sheenAlbedo, sheenAlbedo(cosI, bsdf.sheenRoughness)), 1.0);
  let G = 1.0 / (1.0 + sheenLambda(cosO, alpha) + sheenLambda(cosI, alpha));
  let f = charlieD(wm, alpha) * G / (4.0 * cosO * most);
  return BsdfValue(bsdf.sheenColor * f, 0.5 * INV_PI);
}

fn sheenExpect(bsdf: Bsdf) -> f32 {
  return luminance(bsdf.sheenColor) * 0.5;
}

// How much of what lies below is seen: what the fibres leave, of both directions the less.
fn sheenThrough(bsdf: Bsdf, wi: vec3f) -> f32 {
  let albedo = greater(bsdf.sheenAlbedo, sheenAlbedo(abs(wi.z), bsdf.sheenRoughness));
  return 1.0 - greatest(bsdf.sheenColor) * lesser(albedo, 1.0);
}

fn sheenOut(bsdf: Bsdf) -> f32 {
  return 1.0 - greatest(bsdf.sheenColor) * lesser(bsdf.sheenAlbedo, 1.0);
}

// Density of fibres' normals, per steradian. [1] eq. 2
fn charlieD(wm: vec3f, alpha: f32) -> f32 {
  let sin2 = wm.x * wm.x + wm.y * wm.y;
  return (2.0 + 1.0 / alpha) * pow(greater(sin2, LEAST_COSINE), 0.5 / alpha) * (0.5 * INV_PI);
}

// Smith's Λ, fitted. [1] eq. 3, 4
fn sheenLambda(cosTheta: f32, alpha: f32) -> f32 {
  let mirrored = 2.0 * sheenFit(0.5, alpha) - sheenFit(1.0 - cosTheta, alpha);
  return exp(select(mirrored, sheenFit(cosTheta, alpha), cosTheta < 0.5));
}

fn sheenFit(x: f32, alpha: f32) -> f32 {
  let q = (1.0 - alpha) * (1.0 - alpha);
  let power = pow(greater(x, LEAST_COSINE), mix(0.19823, 0.16801, q));
  return mix(21.5473, 25.3245, q) / (1.0 + mix(3.82987, 3.32435, q) * power)
    + mix(-1.97760, -1.27393, q) * x + mix(-4.32054, -4.85967, q);
}

// Of roughnesses from LEAST_ROUGHNESS to 1.
const LEAST_ROUGHNESS = 0.07;
const ROWS = 16u;
const COLUMNS = 16u;

// What white fibres reflect of uniform light: a row per roughness, evenly spaced; the cubes of whose columns' numbers are evenly
// spaced cosines. By quadrature in doubles, raised so that between them it is never below the truth: it is above it by up to 0.04, at
// cosines below 0.001 by 0.07, for roughnesses below 0.2 by 0.3. tests/gpu/bsdf/sheen.test.ts
const ALBEDO = array<f32, ROWS * COLUMNS>(
  2.677, 2.8548, 2.983, 2.656, 2.0517, 1.4018, 0.8583, 0.446, 0.1792, 0.045, 0.006, 0.0005, 0.0001, 0.0001, 0.0001, 0.0001,
  1.4689, 1.5741, 1.7036, 1.6152, 1.3896, 1.1084, 0.8381, 0.5796, 0.3513, 0.181, 0.0766, 0.0237, 0.0049, 0.0005, 0.0001, 0.0001,
  1.0519, 1.1251, 1.235, 1.2091, 1.0881, 0.9196, 0.735, 0.5555, 0.3938, 0.2568, 0.1475, 0.0718, 0.0274, 0.0073, 0.0009, 0.0001,
  0.8534, 0.9133, 1.0129, 1.0075, 0.9291, 0.812, 0.6784, 0.5424, 0.4135, 0.297, 0.1971, 0.1169, 0.0589, 0.0235, 0.0059, 0.0002,
  0.7473, 0.7986, 0.8943, 0.899, 0.8424, 0.7521, 0.6459, 0.5354, 0.4273, 0.3261, 0.2345, 0.1555, 0.0916, 0.0457, 0.0165, 0.0017,
  0.6899, 0.737, 0.8314, 0.8411, 0.7967, 0.7227, 0.6323, 0.5374, 0.4426, 0.3515, 0.2667, 0.1898, 0.1233, 0.0707, 0.0319, 0.0063,
  0.6623, 0.7076, 0.8019, 0.8162, 0.7797, 0.714, 0.6334, 0.5476, 0.4613, 0.3772, 0.2968, 0.2218, 0.1539, 0.097, 0.051, 0.0151,
  0.6548, 0.6988, 0.795, 0.8123, 0.7804, 0.7205, 0.6454, 0.5651, 0.4839, 0.404, 0.3265, 0.2527, 0.1838, 0.1238, 0.0723, 0.028,
  0.6618, 0.7051, 0.804, 0.8239, 0.7948, 0.7377, 0.6655, 0.5883, 0.5097, 0.4322, 0.3563, 0.283, 0.2129, 0.1506, 0.095, 0.0442,
  0.6793, 0.7218, 0.8237, 0.8459, 0.8183, 0.7625, 0.6913, 0.6153, 0.5378, 0.4612, 0.3859, 0.3123, 0.2412, 0.1768, 0.1182, 0.0626,
  0.7039, 0.7455, 0.8505, 0.8743, 0.8472, 0.7913, 0.7201, 0.6441, 0.5668, 0.4902, 0.4147, 0.3404, 0.2679, 0.2019, 0.141, 0.0822,
  0.7325, 0.7724, 0.8799, 0.9053, 0.8779, 0.8214, 0.7492, 0.6724, 0.5943, 0.5173, 0.4411, 0.3661, 0.2924, 0.225, 0.1625, 0.1017,
  0.7606, 0.7982, 0.9074, 0.9339, 0.9059, 0.8484, 0.775, 0.6973, 0.6186, 0.5409, 0.4642, 0.3884, 0.3139, 0.2457, 0.1823, 0.1204,
  0.7828, 0.8179, 0.9278, 0.9552, 0.9265, 0.8682, 0.7941, 0.7157, 0.6367, 0.5588, 0.4821, 0.4062, 0.3315, 0.263, 0.1994, 0.1376,
  0.793, 0.8261, 0.9355, 0.963, 0.9344, 0.876, 0.8022, 0.7241, 0.6459, 0.5689, 0.4929, 0.418, 0.344, 0.2763, 0.2134, 0.1524,
  0.7826, 0.8102, 0.9198, 0.9522, 0.9244, 0.8676, 0.7957, 0.7198, 0.6438, 0.5689, 0.4954, 0.4225, 0.3505, 0.2847, 0.2237, 0.1644
);

fn sheenAlbedo(cosTheta: f32, roughness: f32) -> f32 {
  let row = (roughness - LEAST_ROUGHNESS) * (f32(ROWS - 1u) / (1.0 - LEAST_ROUGHNESS));
  let column = pow(greater(cosTheta, 0.0), 1.0 / 3.0) * f32(COLUMNS - 1u);
  let i = min(u32(row), ROWS - 2u);
  let j = min(u32(column), COLUMNS - 2u);
  let at = i * COLUMNS + j;
  let upper = mix(ALBEDO[at], ALBEDO[at + 1u], column - f32(j));
  let lower = mix(ALBEDO[at + COLUMNS], ALBEDO[at + COLUMNS + 1u], column - f32(j));
  return mix(upper, lower, row - f32(i));
}
