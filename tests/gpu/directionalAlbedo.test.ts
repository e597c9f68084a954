import { describe, expect, test } from "vitest";
import type { Material, Scene, SceneObject } from "../../src/scene/schema";
import { renderScene } from "../support/device";
import { directionalAlbedo } from "../support/directionalAlbedo";
import { measurePoint, ROUNDING } from "../support/statistics";

// A plane under a sky of radiance 1, seen under one angle by all pixels: they show the share of the light that it reflects
// towards the camera.
const BASE_COLOR = [1, 0.5, 0.1] as const;
const DEGREES = [0, 45, 75, 85, 89];
// f32: the half vector is normalised from a sum, good to 1e-7, and F turns 5 times that; G at cosines of 0.02 loses
// two digits of its seven.
const ARITHMETIC = 2e-5;

const SURFACES: Readonly<Record<string, Material>> = {
  "a metal of roughness 0.05": { metallic: 1, roughness: 0.05 },
  "a metal of roughness 0.3": { metallic: 1, roughness: 0.3 },
  "a metal of roughness 0.6": { metallic: 1, roughness: 0.6 },
  "a metal of roughness 1": { metallic: 1, roughness: 1 },
  "a Schlick–Beckmann metal of roughness 0.3": { metallic: 1, roughness: 0.3, masking: "schlick-beckmann" },
  "a Schlick–Beckmann metal of roughness 1": { metallic: 1, roughness: 1, masking: "schlick-beckmann" },
  "a plastic of roughness 0.2": { roughness: 0.2 },
  "a plastic of roughness 0.7": { roughness: 0.7 },
  "a half-metal of roughness 0.5": { metallic: 0.5, roughness: 0.5 },
  "a mirror": { metallic: 1, roughness: 0 },
  "a polished plastic": { roughness: 0 },
  "a polished half-metal of ior 2": { metallic: 0.5, roughness: 0, ior: 2 },
};

describe.each(Object.keys(SURFACES))("%s", (name) => {
  const material: Material = { ...SURFACES[name]!, baseColor: BASE_COLOR };
  const estimators = material.roughness === 0.05 ? (["path"] as const) : (["path", "uniform"] as const); // the peak is 1e5 high

  test.each(DEGREES)("reflects what the integral says at %d°, seed 4", async (degrees) => {
    const { metallic = 0, roughness = 1, ior = 1.5, masking = "smith" } = material;
    const albedo = directionalAlbedo({ metallic, roughness, ior, masking }, Math.cos((degrees * Math.PI) / 180));
    for (const estimator of estimators) {
      const { image, stats } = await renderScene(planeUnderSky(material, degrees), {
        size: [32, 32],
        samples: 64,
        seed: 4,
        settings: { estimator, maxBounces: 1 },
      });
      expect(stats.badSamples).toBe(0);
      for (const [c, baseColor] of BASE_COLOR.entries()) {
        const { mean, standardError } = measurePoint(image, c);
        const expected = albedo(baseColor);
        const allowed = 4 * standardError + (ROUNDING + ARITHMETIC) * expected;
        expect(Math.abs(mean - expected), `${estimator}, ${c}: ${mean} ≠ ${expected}`).toBeLessThanOrEqual(allowed);
      }
    }
  });
});

const MIRRORS: Readonly<Record<string, SceneObject>> = {
  sphere: { type: "sphere", center: [0, 0, 0], radius: 1, material: "mirror" },
  plane: { type: "plane", point: [0, -1, 0], normal: [0.2, 1, 0.1], material: "mirror" },
  quad: { type: "quad", corner: [-1, -1, 0], edge1: [2, 0.1, 0], edge2: [0.2, 2, 0.3], material: "mirror" },
  triangle: {
    type: "triangle",
    vertices: [
      [-1, -1, 0],
      [1, -1, 0],
      [0, 1, 0.5],
    ],
    material: "mirror",
  },
  box: { type: "box", center: [0, 0, 0], size: [1, 2, 1], material: "mirror" },
  "turned box": { type: "box", center: [0, 0, 0], size: [1, 2, 1], rotationY: 30, material: "mirror" },
};

test.each(Object.keys(MIRRORS))("a perfect mirror, a %s, is invisible in uniform light, seed 5", async (shape) => {
  const radiance = [0.25, 0.5, 3] as const;
  const { image } = await renderScene(
    {
      camera: { position: [0, 0.3, 4] },
      materials: { mirror: { metallic: 1, roughness: 0 } },
      objects: [MIRRORS[shape]!],
      environment: { radiance },
      maxBounces: 1,
    },
    { size: [32, 32], samples: 16, seed: 5 },
  );
  // F = 1 + 0·(1 − cos)⁵ is exact; only the sum of 16 samples rounds.
  for (let i = 0; i < image.length; i++) {
    if (i % 4 === 3) continue;
    expect(Math.abs(image[i]! / radiance[i % 4]! - 1)).toBeLessThanOrEqual(16 * 2 ** -23);
  }
});

function planeUnderSky(material: Material, degrees: number): Scene {
  const angle = (degrees * Math.PI) / 180;
  return {
    camera: {
      position: [Math.sin(angle), Math.cos(angle), 0],
      target: [0, 0, 0],
      up: [0, 0, -1],
      verticalFov: 1e-4, // the angle varies by 1e-6, which the steepest surface turns into 1e-4 of its albedo at the very edge
    },
    materials: { surface: material },
    objects: [{ type: "plane", point: [0, 0, 0], normal: [0, 1, 0], material: "surface" }],
    environment: { radiance: [1, 1, 1] },
  };
}
