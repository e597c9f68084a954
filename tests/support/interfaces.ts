// What interfaces reflect and where they send light, in doubles, from the papers and the extensions of glTF.
//
// [1] Born, Wolf 1999, "Principles of Optics", 7th ed., section 1.5.2
// [2] KHR_materials_specular, KHR_materials_ior
// [3] KHR_materials_iridescence, and Belcour, Barla 2017, "A Practical Extension to Microfacet Theory for the Modeling of
//     Varying Iridescence", ACM TOG 36(4)
// [4] Lindbloom, "RGB/XYZ Matrices": linear Rec. 709
import type { Material, Vec3 } from "../../src/scene/schema";
import { dot } from "./directionBins";
import { schlickWeight } from "./microfacets";

/** Of unpolarised light; `eta` is the index of refraction beyond the interface relative to the one before it. [1] eq. 21a, 33 */
export function dielectricReflectance(cosI: number, eta: number): number {
  const sinT = Math.sqrt(Math.max(1 - cosI ** 2, 0)) / eta;
  if (sinT >= 1) return 1;
  const cosT = Math.sqrt(1 - sinT ** 2);
  const parallel = (eta * cosI - cosT) / (eta * cosI + cosT);
  const across = (cosI - eta * cosT) / (cosI + eta * cosT);
  return (parallel ** 2 + across ** 2) / 2;
}

/** `w` refracted by a surface of normal `m` on its side; undefined for total reflection. Snell's law */
export function refracted(w: Vec3, m: Vec3, eta: number): Vec3 | undefined {
  const cosI = dot(w, m);
  const along = [0, 1, 2].map((k) => (cosI * m[k]! - w[k]!) / eta);
  const sin2 = along.reduce((sum, component) => sum + component ** 2, 0);
  if (sin2 >= 1) return undefined;
  return along.map((component, k) => component - Math.sqrt(1 - sin2) * m[k]!) as unknown as Vec3;
}

/** The index of refraction beyond the surface of a solid relative to the one before it; undefined of what is no solid. */
export function etaOf({ thickness = 0, transmission = 0, metallic = 0, ior = 1.5 }: Material, front: boolean) {
  if (thickness === 0 || transmission === 0 || metallic === 1) return undefined;
  return front ? ior : 1 / ior;
}

/** Reflectance of a material's interface under an angle, and the share of light that gets to what is below it. [2] */
export function interfaceOf(material: Material, cosine: number, front = true): { F: Vec3; through: number } {
  const { ior = 1.5, metallic = 0, specular = 1, specularColor = [1, 1, 1], baseColor = [1, 1, 1] } = material;
  const { iridescence = 0, iridescenceIor = 1.3, iridescenceThickness = 400 } = material;
  const isMatt = ior === 1 || specular === 0;
  const atNormal = ((ior - 1) / (ior + 1)) ** 2;
  const f0 = specularColor.map((color) => (isMatt ? 0 : Math.min(color * atNormal, 1) * specular));
  const f90 = isMatt ? 0 : specular;
  const eta = etaOf(material, front);
  const weight =
    eta === undefined ? schlickWeight(cosine) : (dielectricReflectance(cosine, eta) - atNormal) / (1 - atNormal);
  // Where a dielectric reflects less than at normal incidence, a colour may have less than nothing to reflect.
  const between = (low: number, high: number) => Math.max(low + (high - low) * weight, 0);
  const dielectric = f0.map((low) => between(low, f90));
  const F = dielectric.map((value, c) => (1 - metallic) * value + metallic * between(baseColor[c]!, 1));
  const through = 1 - Math.max(...dielectric);
  if (iridescence === 0 || (isMatt && metallic === 0)) return { F: F as unknown as Vec3, through };
  // A film reflects as much from below as from above, under the angle that light has above.
  const sin2 = 1 - cosine ** 2;
  const above = eta !== undefined && !front ? Math.sqrt(Math.max(1 - sin2 / eta ** 2, 0)) : cosine;
  const mixed = f0.map((value, c) => (1 - metallic) * value + metallic * baseColor[c]!);
  const film = filmReflectance(above, iridescenceIor, iridescenceThickness, mixed);
  return {
    F: F.map((value, c) => (1 - iridescence) * value + iridescence * film[c]!) as unknown as Vec3,
    through: (1 - iridescence) * through + iridescence * (1 - Math.max(...film)),
  };
}

/** In air, of a thickness in nanometres, on interfaces that reflect `F0` at normal incidence; cut to [0, 1]. [3] */
export function filmReflectance(cosine: number, filmIor: number, thickness: number, F0: readonly number[]): number[] {
  // [3] has films fade out below 0.03, which is of micrometres in the code of its second paper.
  const step = Math.min(thickness / 30, 1);
  const ior = 1 + (filmIor - 1) * step * step * (3 - 2 * step);
  const cos2 = 1 - (1 - cosine ** 2) / ior ** 2;
  if (cos2 < 0) return [1, 1, 1];
  const inside = Math.sqrt(cos2);
  const schlick = (f0: number, cosTheta: number) => f0 + (1 - f0) * schlickWeight(cosTheta);
  const R12 = schlick(((ior - 1) / (ior + 1)) ** 2, cosine);
  const T121 = 1 - R12;
  const bases = F0.map((f0) => {
    const root = Math.sqrt(Math.min(f0, 0.9999));
    return (1 + root) / (1 - root);
  });
  const R23 = bases.map((base) => schlick(((base - ior) / (base + ior)) ** 2, inside));
  const phases = bases.map((base) => Math.PI + (base < ior ? Math.PI : 0));
  const both = R23.map((r) => Math.min(Math.max(R12 * r, 1e-5), 0.9999));
  const Rs = R23.map((r, c) => (T121 ** 2 * r) / (1 - both[c]!));
  const sums = Rs.map((r) => R12 + r);
  for (const order of [1, 2]) {
    const path = 2 * ior * thickness * inside * order;
    const seen = sensitivity(
      path,
      phases.map((phase) => phase * order),
    );
    for (const c of [0, 1, 2]) sums[c]! += 2 * (Rs[c]! - T121) * Math.sqrt(both[c]!) ** order * seen[c]!;
  }
  return sums.map((sum) => Math.min(Math.max(sum, 0), 1));
}

/** [3], as the extension prints it. */
function sensitivity(path: number, shift: readonly number[]): number[] {
  const phase = 2 * Math.PI * path * 1e-9;
  const hump = (value: number, position: number, variance: number, turn: number) =>
    value * Math.sqrt(2 * Math.PI * variance) * Math.cos(position * phase + turn) * Math.exp(-variance * phase ** 2);
  const X = hump(5.4856e-13, 1.681e6, 4.3278e9, shift[0]!) + hump(9.747e-14, 2.2399e6, 4.5282e9, shift[0]!);
  const Y = hump(4.4201e-13, 1.7953e6, 9.3046e9, shift[1]!);
  const Z = hump(5.2481e-13, 2.2084e6, 6.6121e9, shift[2]!);
  const rows = [
    [3.2404542, -1.5371385, -0.4985314],
    [-0.969266, 1.8760108, 0.041556],
    [0.0556434, -0.2040259, 1.0572252],
  ] as const; // [4]
  return rows.map(([x, y, z]) => (x * X + y * Y + z * Z) / 1.0685e-7);
}
