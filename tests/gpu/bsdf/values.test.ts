import { afterAll, describe, expect, test } from "vitest";
import type { Material, Vec3 } from "../../../src/scene/schema";
import { type BsdfInput, evaluateBsdf } from "../../support/deviceBsdf";
import { dot, normalize } from "../../support/directionBins";
import { etaOf } from "../../support/interfaces";
import { add, alphasOf, scale, scattered } from "../../support/khrMaterials";
import { createRandom, randomDirection } from "../../support/random";
import { recordStability, type StabilityRow } from "../../support/stabilityRows";

// What the lobes of glTF's extensions scatter, against doubles, and exchanged.

const ULP = 2 ** -23;
const INPUTS = 4000;
const ROUGHNESS = [0.2, 0.4, 0.7, 1];
const COLOR = [0.9, 0.5, 0.1] as const;
const GLASS: Material = { transmission: 1, thickness: 1, baseColor: COLOR };

const MATERIALS: Readonly<Record<string, Material>> = {
  "rough glass": GLASS,
  diamond: { ...GLASS, ior: 2.4 },
  "a bubble of air in water, as a solid of ior 0.75": { ...GLASS, ior: 0.75 },
  "half of a solid, half Lambert": { ...GLASS, transmission: 0.5 },
  "a rough wall": { transmission: 0.7, baseColor: COLOR },
  "a tinted dielectric": { specular: 0.6, specularColor: [1, 0.2, 3], baseColor: COLOR },
  "tinted glass": { ...GLASS, specular: 0.6, specularColor: [1, 0.2, 3] },
  "an anisotropic metal": { metallic: 1, anisotropy: 0.7, baseColor: COLOR },
  "an anisotropic wall": { transmission: 0.7, anisotropy: 0.5, baseColor: COLOR },
  "anisotropic glass": { ...GLASS, anisotropy: 0.7 },
  "diffuse transmission": { diffuseTransmission: 0.4, diffuseTransmissionColor: [0.2, 1, 0.6], baseColor: COLOR },
  "an iridescent dielectric": { iridescence: 0.8, iridescenceThickness: 350, baseColor: COLOR },
  "an iridescent metal": {
    metallic: 1,
    iridescence: 1,
    iridescenceIor: 1.8,
    iridescenceThickness: 500,
    baseColor: COLOR,
  },
  "an iridescent wall": { transmission: 0.9, iridescence: 1, iridescenceThickness: 250 },
  "iridescent glass": { ...GLASS, iridescence: 1, iridescenceThickness: 450 },
  "a coat on a dielectric": { clearcoat: 0.8, clearcoatRoughness: 0.5, baseColor: COLOR },
  "a coat on glass": { ...GLASS, clearcoat: 1, clearcoatRoughness: 0.3 },
  "a mirror coat on Lambert": { ior: 1, clearcoat: 1, baseColor: COLOR },
};

const rows: StabilityRow[] = [];
afterAll(() => recordStability("lobe-values", rows));

describe.each(Object.keys(MATERIALS))("%s, seed 22,", (name) => {
  const base = MATERIALS[name]!;
  const materials = ROUGHNESS.map((roughness): Material => ({ ...base, roughness }));
  const isSolid = etaOf(base, true) !== undefined;

  test("scatters what its papers and extensions say, and as much with wo and wi exchanged", async () => {
    const random = createRandom(22);
    const hasBelow = base.transmission || base.diffuseTransmission;
    const inputs = Array.from({ length: INPUTS }, (_, i) => {
      const material = i % materials.length;
      const front = !isSolid || random() < 0.5;
      const wo = upward(random);
      const wi = upward(random);
      return { material, wo, x: hasBelow && random() < 0.5 ? ([wi[0], wi[1], -wi[2]] as Vec3) : wi, front };
    });
    const there = await evaluateBsdf(materials, inputs);
    const back = await evaluateBsdf(materials, inputs.map(exchanged));
    let [worst, asymmetry, counted] = [0, 0, 0];
    for (const [i, { material, wo, x: wi, front }] of inputs.entries()) {
      const exact = scattered(materials[material]!, wo, wi, front);
      // Radiance is not scaled by eta²: f of the way in is eta² times f of the way out.
      const eta = wi[2] < 0 ? (etaOf(base, front) ?? 1) : 1;
      const allowed = allowedOf(materials[material]!, wo, wi, eta);
      const largest = Math.max(...exact);
      for (const c of [0, 1, 2]) {
        const f = there[4 * i + c]! / Math.abs(wi[2]);
        const returned = (back[4 * i + c]! / wo[2]) * eta ** 2;
        if (exact[c]! === 0) expect(f).toBe(0);
        // Colours of a film are sums that cancel.
        const measure = base.iridescence ? largest : exact[c]!;
        if (!(measure > 1e-9)) continue; // what the shader flushes, or two ends of a cut
        counted++;
        worst = Math.max(worst, Math.abs(f - exact[c]!) / measure / allowed);
        asymmetry = Math.max(asymmetry, Math.abs(returned - f) / measure / allowed);
      }
    }
    console.log(`${name}: ${worst.toFixed(3)} of the bound, exchanged ${asymmetry.toFixed(3)}; ${counted} values`);
    rows.push({
      case: `${name}: f against doubles, and f(wo, wi) = f(wi, wo) or eta² times that, roughness 0.2 to 1`,
      asserted: "relative difference; worst is in units of its bound",
      inputs: counted,
      worst: Math.max(worst, asymmetry),
    });
    expect(counted).toBeGreaterThan(INPUTS);
    expect(worst).toBeLessThan(1);
    expect(asymmetry).toBeLessThan(1);
  });
});

/** The same pair of directions, seen from the other end. */
function exchanged({ material, wo, x, front }: BsdfInput): BsdfInput {
  if (x[2] > 0) return { material: material!, wo: x, x: wo, front: front! };
  // The normal points to the viewer: the frame of the other side.
  return { material: material!, wo: [x[0], x[1], -x[2]], x: [wo[0], wo[1], -wo[2]], front: !front };
}

/**
 * Relative. f32 makes vectors unit to 2⁻²³, and their weighted sum, of which the normal is made, good to that over its length; D
 * changes by up to 4/α per radian of it, Fresnel's equations by 1/cos of the refracted direction, the Jacobian as the square of
 * its denominator. The cosines of a film's phases are good to 2⁻¹¹ by WGSL.
 */
function allowedOf(material: Material, wo: Vec3, wi: Vec3, eta: number): number {
  const alpha = Math.min(...alphasOf(material));
  const mirrored: Vec3 = eta === 1 ? [wi[0], wi[1], Math.abs(wi[2])] : wi;
  const sum = add(wo, scale(mirrored, eta));
  const length = Math.hypot(...sum);
  const m = normalize(scale(sum, Math.sign(sum[2])));
  const [cosO, cosI] = [dot(wo, m), dot(mirrored, m)];
  const least = Math.min(Math.abs(cosO), Math.abs(cosI));
  const solid = Math.max(etaOf(material, true) ?? 0, etaOf(material, false) ?? 0);
  const cosT = Math.sqrt(Math.max(Math.abs(1 - solid ** 2 * (1 - cosO ** 2)), 1e-9));
  const bend = eta === 1 ? 1 : Math.abs(cosO + eta * cosI);
  const film = material.iridescence ? 2 ** 12 : 0;
  return (
    ULP *
    (100 + 40 / length + 16 / length / alpha + 10 / least ** 2 + (10 * eta) / bend + (10 * solid ** 2) / cosT + film)
  );
}

function upward(random: () => number): Vec3 {
  const [x, y, z] = randomDirection(random);
  const [a, b, c] = normalize([x, y, Math.max(Math.abs(z), 1e-2)]);
  return [Math.fround(a), Math.fround(b), Math.fround(c)];
}
