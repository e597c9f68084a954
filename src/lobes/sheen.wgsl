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

fn sheenValue(bsdf: Bsdf, at: Directions) -> BsdfValue {
  let cosO = greater(at.wo.z, LEAST_COSINE);
  let cosI = greater(at.wi.z, LEAST_COSINE);
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
// spaced cosines. By quadrature in doubles, raised by up to 0.014 (0.18 for roughnesses below 0.2, at grazing angles) so that
// between them it is never below the truth. tests/gpu/bsdf/sheen.test.ts
const ALBEDO = array<f32, ROWS * COLUMNS>(
  2.6769, 2.7875, 2.9542, 2.656, 2.0517, 1.4018, 0.8524, 0.4369, 0.1738, 0.0416, 0.006, 0.0004, 0.0001, 0.0001, 0.0001, 0.0001,
  1.4689, 1.5364, 1.6693, 1.5956, 1.3836, 1.1084, 0.8349, 0.5736, 0.347, 0.1747, 0.0748, 0.0237, 0.0049, 0.0005, 0.0001, 0.0001,
  1.0519, 1.1026, 1.2189, 1.2021, 1.0831, 0.9179, 0.735, 0.5555, 0.3935, 0.2544, 0.1464, 0.0713, 0.0274, 0.0073, 0.0009, 0.0001,
  0.8533, 0.8958, 0.9999, 1.002, 0.9248, 0.8101, 0.6779, 0.5424, 0.4131, 0.2959, 0.1967, 0.1164, 0.0588, 0.0235, 0.0058, 0.0002,
  0.7472, 0.7852, 0.8833, 0.8946, 0.8387, 0.7501, 0.6453, 0.5354, 0.4273, 0.3256, 0.2341, 0.1552, 0.0914, 0.0457, 0.0164, 0.0017,
  0.6898, 0.7253, 0.8235, 0.8411, 0.7965, 0.7224, 0.6322, 0.5374, 0.4426, 0.3515, 0.2665, 0.1897, 0.1231, 0.0707, 0.0319, 0.0063,
  0.6622, 0.6962, 0.792, 0.8138, 0.7773, 0.7124, 0.6327, 0.5475, 0.4613, 0.3771, 0.2967, 0.2217, 0.1537, 0.097, 0.0509, 0.0151,
  0.6547, 0.6879, 0.7864, 0.8118, 0.7796, 0.7198, 0.6449, 0.565, 0.4838, 0.4039, 0.3265, 0.2526, 0.1836, 0.1237, 0.0723, 0.028,
  0.6617, 0.6942, 0.795, 0.8235, 0.7941, 0.7371, 0.6652, 0.5882, 0.5097, 0.4321, 0.3563, 0.2829, 0.2127, 0.1505, 0.095, 0.0442,
  0.6792, 0.7111, 0.8145, 0.8455, 0.8177, 0.762, 0.691, 0.6152, 0.5378, 0.4611, 0.3859, 0.3122, 0.2409, 0.1766, 0.1181, 0.0626,
  0.7038, 0.7349, 0.8414, 0.8743, 0.847, 0.7911, 0.72, 0.6441, 0.5667, 0.4901, 0.4146, 0.3403, 0.2676, 0.2017, 0.1409, 0.0821,
  0.7319, 0.7618, 0.8706, 0.9051, 0.8776, 0.8211, 0.749, 0.6723, 0.5942, 0.5171, 0.441, 0.366, 0.2921, 0.2248, 0.1624, 0.1016,
  0.759, 0.7876, 0.8982, 0.9335, 0.9056, 0.848, 0.7749, 0.6972, 0.6185, 0.5407, 0.4641, 0.3884, 0.3137, 0.2455, 0.1822, 0.1203,
  0.78, 0.8072, 0.9189, 0.9546, 0.9261, 0.8678, 0.7939, 0.7156, 0.6366, 0.5586, 0.482, 0.4061, 0.3313, 0.2628, 0.1993, 0.1374,
  0.7893, 0.8152, 0.9267, 0.9623, 0.9339, 0.8755, 0.8018, 0.7239, 0.6457, 0.5686, 0.4928, 0.4179, 0.3438, 0.2761, 0.2133, 0.1521,
  0.781, 0.8061, 0.9163, 0.9518, 0.9241, 0.8673, 0.7955, 0.7197, 0.6437, 0.5688, 0.4953, 0.4225, 0.3504, 0.2846, 0.2237, 0.1642
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
