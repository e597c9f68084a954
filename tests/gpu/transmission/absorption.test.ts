// What light loses on its way in solids: the law of Beer and Lambert.

import { describe, expect, test } from "vitest";
import type { Material, Rgb, Scene, SceneObject, Vec3 } from "../../../src/scene/schema";
import { expectColor, expectImage, fresnel, look, meanColor, picture, radiance, type Solid } from "../../support/glass";
import { meshObject, placed, smoothSphere } from "../../support/meshes";

const SKY: Rgb = [1, 2, 3];
const COLOR: Rgb = [0.8, 0.5, 0.1];
const DISTANCE = 0.7;
/** Bends no light, and colours it by COLOR over DISTANCE. */
const TINTED: Material = {
  transmission: 1,
  thickness: 1,
  roughness: 0,
  ior: 1,
  attenuationColor: COLOR,
  attenuationDistance: DISTANCE,
};
const sigmaOf = (color: Rgb, distance: number) => color.map((c) => -Math.log(c) / distance) as unknown as Rgb;
const SIGMA = sigmaOf(COLOR, DISTANCE);
const through = (L: Rgb, length: number, sigma = SIGMA) =>
  L.map((value, i) => value * Math.exp(-sigma[i]! * length)) as unknown as Rgb;

const slab: SceneObject = { type: "box", center: [0, 0, 0], size: [4, 4, 1.3], material: "solid" };

/** Seen head on, as by parallel rays. */
function inSky(objects: readonly SceneObject[], solid: Material = TINTED, more: Partial<Scene> = {}): Scene {
  return {
    camera: { position: [0, 0, 5], target: [0, 0, 0], verticalFov: 0.002 },
    materials: { solid, other: TINTED, black: { baseColor: [0, 0, 0], ior: 1 } },
    objects,
    environment: { radiance: SKY },
    maxBounces: 40,
    ...more,
  };
}

/** Of exp() of a device, 3 + 2·|x| ULP, x of up to 5; and of the distance. */
const ROUNDING = 5e-6;
const few = { samples: 4, size: 8 };

test("a slab of ior 1 lets exp(−σd) through, seeds 1–4", async () => {
  expectColor(await look(inSky([slab]), few), through(SKY, 1.3), ROUNDING);
});

test.each<[string, Material, Rgb]>([
  ["over a distance of 1e6 nothing is lost", { attenuationDistance: 1e6 }, through(SKY, 1.3, sigmaOf(COLOR, 1e6))],
  ["over a distance of 1e-6 all", { attenuationDistance: 1e-6 }, [0, 0, 0]],
  ["a colour of 0 takes its channel", { attenuationColor: [0, 0.5, 1] }, [0, 2 * 0.5 ** (1.3 / DISTANCE), 3]],
])("%s, seeds 1–4", async (_name, change, expected) => {
  expectColor(await look(inSky([slab], { ...TINTED, ...change }), few), expected, ROUNDING);
});

test("a slab of ior 1.5 does so with each reflection in it, seeds 1–4", async () => {
  // With r = F and a = exp(−σd), (1 − r)²·a / (1 − r²·a²) passes; what is reflected comes from the sky too: r + r·(1 − r)²·a² / (1 − r²·a²).
  const r = fresnel(1, 1.5);
  const expected = SKY.map((value, i) => {
    const a = Math.exp(-SIGMA[i]! * 1.3);
    return value * (r + ((1 - r) ** 2 * a * (1 + r * a)) / (1 - r ** 2 * a ** 2));
  }) as unknown as Rgb;
  for (const estimator of ["path", "uniform"] as const)
    expectColor(await look(inSky([slab], { ...TINTED, ior: 1.5 }), { settings: { estimator } }), expected, 1e-5);
});

describe.each([1e-3, 1, 1000])("%d times the size", (scale) => {
  test("a ball's colour is that of its chords, seeds 1–4", async () => {
    const ball: SceneObject = { type: "sphere", center: [0, 0, 0], radius: scale, material: "solid" };
    const camera = { position: [0, 0, 4 * scale], target: [0, 0, 0], verticalFov: 32 } as const;
    const scene = { ...inSky([ball], { ...TINTED, attenuationDistance: DISTANCE * scale }), camera };
    const solid: Solid = { object: ball, ior: 1, sigma: SIGMA.map((s) => s / scale) as unknown as Rgb };
    const expected = picture(camera, 16, 8, (o, d) => radiance(o, d, [solid], () => SKY));
    // Grazing rays that one of both misses, at the rim: LEAST in radiance().
    expectImage(await look(scene), { ...expected, bias: expected.bias as Float64Array });
  });
});

test("a mesh's colour is that of a ball, but for what facets cut off, seeds 1–4", async () => {
  const ball = inSky([{ type: "sphere", center: [0, 0, 0], radius: 1, material: "solid" }]);
  const mesh = inSky([meshObject(smoothSphere(4000), "solid")]);
  const [a, b] = [meanColor(await look(ball, few)), meanColor(await look(mesh, few))];
  // Of a chord of 2, each end of a facet's depth, (π/64)²/2 at most.
  for (const i of [0, 1, 2]) {
    const most = Math.exp(SIGMA[i]! * (Math.PI / 64) ** 2);
    expect(b.color[i]! / a.color[i]!).toBeGreaterThan(1 - 1e-4);
    expect(b.color[i]! / a.color[i]!).toBeLessThan(most);
  }
});

describe("one in another", () => {
  const outer: SceneObject = { type: "sphere", center: [0, 0, 0], radius: 1.5, material: "other" };
  const inner: SceneObject = { type: "sphere", center: [0, 0, 0.2], radius: 0.6, material: "solid" };
  const solid: Material = { ...TINTED, attenuationColor: [0.2, 0.9, 0.6] };
  const sigma = sigmaOf([0.2, 0.9, 0.6], DISTANCE);
  const both = inSky([outer, inner], solid);

  test("each takes its part of the way, seeds 1–4", async () => {
    expectColor(await look(both, few), through(through(SKY, 1.8), 1.2, sigma), ROUNDING);
  });

  test.each<[string, Vec3, number, number]>([
    ["of the inner one", [0, 0, 0.3], 1.3 - 0.4 + 0.2, 0.7],
    ["of the outer one before it", [0, 0, 1], 0.2 + 1.1, 1.2],
    ["of the outer one behind it", [0, 0, -1], 0.5, 0],
  ])("so they do seen from the inside %s, seeds 1–4", async (_name, position, inOuter, inInner) => {
    const camera = { position, target: [position[0], position[1], position[2] - 1], verticalFov: 0.002 } as const;
    expectColor(await look({ ...both, camera }, few), through(through(SKY, inOuter), inInner, sigma), ROUNDING);
  });
});

describe("seen from the inside", () => {
  const glow: Material = { baseColor: [0, 0, 0], ior: 1, emission: SKY };
  const camera = { position: [0, 0, 0], target: [0, 0, -1], verticalFov: 0.002 } as const;
  const behind = (z: number): SceneObject => {
    return { type: "quad", corner: [-9, -9, z], edge1: [18, 0, 0], edge2: [0, 18, 0], material: "glow" };
  };
  const scene = (objects: readonly SceneObject[], more: Partial<Scene> = {}): Scene => ({
    ...inSky(objects),
    camera,
    materials: { solid: TINTED, glow },
    environment: { radiance: [0, 0, 0] },
    ...more,
  });
  const ball: SceneObject = { type: "sphere", center: [0, 0, 0.2], radius: 1, material: "solid" };
  const box: SceneObject = { type: "box", center: [0, 0, 0], size: [2, 2, 1.6], material: "solid" };
  const ocean: SceneObject = { type: "plane", point: [0, 0, -0.8], normal: [0, 0, -1], material: "solid" };
  const pool: SceneObject = {
    ...behind(-0.8),
    corner: [9, -9, -0.8],
    edge1: [-18, 0, 0],
    material: "solid",
  } as SceneObject;

  test.each<[string, SceneObject]>([
    ["a ball", ball],
    ["a box", box],
    ["an ocean", ocean],
    ["a pool", pool],
    ["a mesh", meshObject(placed(smoothSphere(4000), 0.8, [0, 0, 0]), "solid")],
  ])("%s takes its part of the light from beyond, seeds 1–4", async (_name, object) => {
    // The mesh is less than a ball by a facet's depth, 0.8·(π/64)² at most.
    const bias = object.type === "mesh" ? 0.8 * (Math.PI / 64) ** 2 * Math.max(...SIGMA) : ROUNDING;
    expectColor(await look(scene([object, behind(-3)]), few), through(SKY, 0.8), bias);
  });

  test.each<[string, SceneObject]>([
    ["a ball", ball],
    ["a box", box],
    ["an ocean", { ...ocean, point: [0, 0, -3] } as SceneObject],
  ])("%s takes its part of the light from what is in it, seeds 1–4", async (_name, object) => {
    expectColor(await look(scene([object, behind(-0.5)]), few), through(SKY, 0.5), ROUNDING);
  });
});

describe("a lamp in a coloured solid", () => {
  const ball: SceneObject = { type: "sphere", center: [0, 0, 0], radius: 3, material: "solid" };
  const white: SceneObject = { type: "sphere", center: [0, 0, 0], radius: 0.5, material: "white" };
  const lights: Scene["lights"] = [{ type: "sphere", position: [1.5, 1, 1], radius: 0.3, power: [50, 50, 50] }];
  const scene: Scene = {
    camera: { position: [0, 0, 8], target: [0, 0, 0], verticalFov: 12 },
    materials: { solid: TINTED, white: { ior: 1, baseColor: [0.8, 0.8, 0.8] } },
    objects: [ball, white],
    lights,
    maxBounces: 3,
  };

  test("lights what is in there by both estimators alike, seeds 1–4", async () => {
    const path = meanColor(await look(scene));
    const uniform = meanColor(await look(scene, { samples: 256, settings: { estimator: "uniform" } }));
    for (const i of [0, 1, 2]) {
      const sigma = Math.hypot(path.error[i]!, uniform.error[i]!);
      expect(Math.abs(path.color[i]! - uniform.color[i]!)).toBeLessThan(4 * sigma);
      expect(sigma / path.color[i]!).toBeLessThan(0.03);
    }
  });

  test("lights a spot by what is left of its way, and of the way to the viewer, seeds 1–4", async () => {
    // The point of the ball nearest to the camera: E by the sphere's intensity, as all of it is above the horizon.
    const p: Vec3 = [0, 0, 0.5];
    const to: Vec3 = [1.5, 1, 0.5];
    const distance = Math.hypot(...to);
    const E = ((50 / (4 * Math.PI)) * (to[2] / distance)) / distance ** 2;
    const L = (0.8 * E) / Math.PI;
    const near = { ...scene, camera: { ...scene.camera!, verticalFov: 0.001 }, maxBounces: 2 };
    // From points of the lamp 0.3 around its middle the way is longer or shorter: σ·0.3²/distance at the most counts, 1 %.
    expectColor(await look(near, { samples: 256 }), through([L, L, L], distance - 0.3 * 0.66 + 3 - p[2]), 0.12);
  });
});
