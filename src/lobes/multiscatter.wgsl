// What GGX with height-correlated Smith masking loses because it follows light to one microfacet only, and gives back.
//
// The lobe is scaled so that, for F = 1, it reflects all light. One factor for all wi: cheap and sampled as before, but not
// reciprocal; Kulla and Conty's second lobe would be, at the price of another table and another sampler.
//
// [1] Turquin 2019, "Practical multiple scattering compensation for microfacet models"
// [2] Heitz 2014, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", JCGT 3(2)
import package::minMax::greater;

// The share of light from above that a white microsurface, seen under cosTheta, does not reflect: 1 − E(cosTheta, alpha).
//
// A rational fit in G1 and alpha²: G1, which depends on alpha·tan alone, straightens out the crease of E where cosTheta and
// alpha both go to 0. It lies below the truth, so that the gain makes no light: with E by quadrature in doubles,
// E / (1 − loss) is in [0.9925, 1.0005] for all alpha <= 1 and cosTheta > 0. tests/gpu/bsdf/multiscatter.test.ts
fn multiscatterLoss(cosTheta: f32, alpha: f32) -> f32 {
  let a2 = alpha * alpha;
  let slope = sqrt(cosTheta * cosTheta + a2 * greater(1.0 - cosTheta * cosTheta, 0.0));
  let G1 = 2.0 * cosTheta / (cosTheta + slope); // [2] eq. 43, 72
  let powers = vec4f(1.0, G1, G1 * G1, G1 * G1 * G1);
  let numerator = vec4f(0.0366, 0.60388, -0.57955, -0.06241) + a2 * vec4f(2.31107, 0.43625, -3.65943, 1.26107);
  let denominator = vec4f(1.0, 3.48818, -5.56619, 1.31168) + a2 * (vec4f(-0.12477, 2.0529, -1.80205, 0.0)
    + a2 * (vec4f(0.28982, -0.04811, 0.0, 0.0) + a2 * vec4f(-0.09916, 0.0, 0.0, 0.0)));
  return greater(G1 * dot(powers, numerator) / dot(powers, denominator), 0.0);
}

// What to multiply the lobe by: 1 + F0·(1 − E)/E. [1]
fn multiscatterGain(cosTheta: f32, alpha: f32, F0: vec3f) -> vec3f {
  let loss = multiscatterLoss(cosTheta, alpha);
  return 1.0 + F0 * (loss / (1.0 - loss));
}
