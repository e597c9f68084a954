// Where light goes in glass: pictures of striped walls against rays that are traced in doubles.

import { expect, test } from "vitest";
import type { Camera, Material, Rgb, Scene, SceneObject, Vec3 } from "../../../src/scene/schema";
import {
  type Backdrop,
  expectColor,
  expectImage,
  fresnel,
  look,
  picture,
  radiance,
  type Solid,
} from "../../support/glass";
import { createRandom } from "../../support/random";

const GLASS: Material = { transmission: 1, thickness: 1, roughness: 0 };
const DARK: Material = { baseColor: [0, 0, 0], ior: 1 };

// Eight stripes at z = −3, each 0.5 wide, and nothing else.
const COLORS: readonly Rgb[] = [
  [1, 0.2, 0.1],
  [0.1, 1, 0.3],
  [0.2, 0.3, 1],
  [1, 1, 0.5],
];
const stripes = Array.from({ length: 8 }, (_, i): SceneObject => {
  return {
    type: "quad",
    corner: [-2 + i / 2, -2, -3],
    edge1: [0.5, 0, 0],
    edge2: [0, 4, 0],
    material: `stripe${i % 4}`,
  };
});
const materials: Record<string, Material> = Object.fromEntries(
  COLORS.map((emission, i) => [`stripe${i}`, { ...DARK, emission }]),
);
const wall: Backdrop = (o, d) => {
  const t = (-3 - o[2]) / d[2];
  const [x, y] = [o[0] + t * d[0], o[1] + t * d[1]];
  return d[2] < 0 && t > 0 && Math.abs(x) < 2 && Math.abs(y) < 2 ? COLORS[Math.floor(2 * (x + 2)) % 4]! : [0, 0, 0];
};

// The variance of a pixel on the edge of a stripe is told by four seeds: one of three degrees of freedom lies beyond 4.7 of its own standard
// deviations in 1.8 % of all cases, in one of three channels in 5 %.
const PIXELS = 0.93;

const SIZE = 16;
const BOUNCES = 24;
const camera: Camera = { position: [0.4, 0.6, 4], target: [0, 0, 0], verticalFov: 32 };

function scene(solids: readonly Solid[], view: Camera = camera, glass: Material = GLASS): Scene {
  const own = solids.map(({ ior, sigma = [0, 0, 0] }): Material => {
    const attenuationColor = sigma.map((s) => Math.exp(-s)) as unknown as Rgb;
    return { ...glass, ior, attenuationColor, attenuationDistance: 1 };
  });
  return {
    camera: view,
    materials: { ...materials, ...Object.fromEntries(own.map((each, i) => [`solid${i}`, each])) },
    objects: [...solids.map(({ object }, i): SceneObject => ({ ...object, material: `solid${i}` })), ...stripes],
    maxBounces: BOUNCES,
  };
}

const shown = (solids: readonly Solid[], view = camera) =>
  picture(view, SIZE, 8, (o, d) => radiance(o, d, solids, wall, BOUNCES, 1e-5));

const material = "";
const ball: Solid = { object: { type: "sphere", center: [0, 0, 0], radius: 1, material }, ior: 1.5 };
const box: Solid = {
  object: { type: "box", center: [0, 0, 0], size: [1.2, 1, 1.4], rotationY: 35, material },
  ior: 1.5,
};

const SCENES: Readonly<Record<string, readonly [readonly Solid[], Camera?]>> = {
  "a ball": [[ball]],
  "a coloured ball of ior 1.33": [[{ ...ball, ior: 1.33, sigma: [0.2, 0.5, 1] }]],
  "a turned box": [[box]],
  "a ball in a ball": [[ball, { object: { ...ball.object, radius: 0.5, center: [0.1, 0, 0] } as never, ior: 1.2 }]],
  "two balls one behind the other": [
    [
      { object: { type: "sphere", center: [0.2, 0, 0.8], radius: 0.6, material }, ior: 1.5 },
      { object: { type: "sphere", center: [-0.2, 0, -0.9], radius: 0.8, material }, ior: 1.8 },
    ],
  ],
  // Faces seen at up to 70°, of a critical angle of 42°.
  "a box, seen from its inside": [
    [{ ...box, sigma: [0.1, 0.2, 0.3] }],
    { position: [0.1, 0.05, 0.2], target: [-0.2, 0, -1], verticalFov: 100 },
  ],
  // Rays meet its upper face at 85° to 89°.
  "a slab, along its face": [
    [{ object: { type: "box", center: [0, -0.05, 0], size: [3, 0.1, 3], material }, ior: 1.5 }],
    { position: [0, 0.15, 4], target: [0, 0, 0], verticalFov: 12 },
  ],
  "a slab a micrometre thick": [
    [{ object: { type: "box", center: [0, 0, 0], size: [1.6, 1.6, 1e-6], rotationY: 20, material }, ior: 1.5 }],
  ],
};

test.each(Object.entries(SCENES))(
  "stripes seen through %s are where a tracer in doubles has them, seeds 1–4",
  async (_name, one) => {
    const [solids, view] = one;
    expectImage(await look(scene(solids, view), { size: SIZE, samples: 64 }), shown(solids, view), PIXELS);
  },
);

test("colours part as KHR_materials_dispersion has them, seeds 1–4", async () => {
  const dispersion = 4;
  const spread = (1.5 - 1) * 0.025 * dispersion;
  const parts = [-spread, 0, spread].map((shift) => shown([{ ...ball, ior: 1.5 + shift }]));
  const channel = (of: (part: (typeof parts)[number]) => ArrayLike<number>) =>
    Float64Array.from({ length: 3 * SIZE ** 2 }, (_, i) => of(parts[i % 3]!)[i]!);
  const expected = {
    ...parts[1]!,
    image: channel((part) => part.image),
    standardError: channel((part) => part.standardError),
  };
  const measured = await look(scene([ball], camera, { ...GLASS, dispersion }), { size: SIZE, samples: 64 });
  expectImage(measured, expected, PIXELS);
});

test.each([
  ["the nearer first", [0.5, -0.5]],
  ["the farther first", [-0.5, 0.5]],
])("solids that touch each colour their part of the way, %s, seeds 1–4", async (_name, places) => {
  const sigmas: readonly Rgb[] = [
    [0.2, 0.5, 1],
    [1, 0.1, 0.4],
  ];
  const solids = places.map((z, i): Solid => {
    return { object: { type: "box", center: [0, 0, z], size: [4, 4, 1], material }, ior: 1, sigma: sigmas[i]! };
  });
  const straight: Camera = { position: [0.25, 0, 4], target: [0.25, 0, 0], verticalFov: 0.002 };
  const expected = COLORS[0]!.map((L, i) => L * Math.exp(-sigmas[0]![i]! - sigmas[1]![i]!)) as unknown as Rgb;
  expectColor(await look(scene(solids, straight), { size: 8, samples: 4 }), expected);
});

test("a rough ball in a uniform sky is as dark as microfacets in doubles have it, seeds 1–4", async () => {
  const alpha = 0.25;
  const view: Camera = { position: [0, 0, 6], target: [0, 0, 0], verticalFov: 0.002 };
  const rough: Scene = {
    camera: view,
    materials: { glass: { ...GLASS, roughness: 0.5 } },
    objects: [{ type: "sphere", center: [0, 0, 0], radius: 1, material: "glass" }],
    environment: { radiance: [1, 1, 1] },
    maxBounces: 40,
  };
  const random = createRandom(3);
  let [sum, squares] = [0, 0];
  const count = 200000;
  for (let i = 0; i < count; i++) {
    const weight = walk(alpha, random);
    sum += weight;
    squares += weight ** 2;
  }
  const mean = sum / count;
  const error = Math.sqrt((squares / count - mean ** 2) / count);
  const measured = await look(rough, { samples: 256 });
  expectColor(measured, [mean, mean, mean], 5e-4 + (4 * error) / mean);
  expect(mean).toBeLessThan(0.99);
});

/** What is left of a path that meets a ball of ior 1.5 head on, until it is outside again. */
function walk(alpha: number, random: () => number): number {
  let [cosO, weight, isInside] = [1, 1, false];
  for (let bounce = 0; bounce < 40; bounce++) {
    // A ball looks the same from everywhere: of where a path is, its angle with the normal is all that counts.
    const wo: Vec3 = [Math.sqrt(1 - cosO ** 2), 0, cosO];
    const wm = visibleNormal(wo, alpha, random(), random());
    const c = wo[0] * wm[0] + wo[2] * wm[2];
    const eta = isInside ? 1 / 1.5 : 1.5;
    const F = fresnel(c, eta);
    const lambda = (z: number) => 0.5 * (Math.sqrt(1 + (alpha ** 2 * (1 - z ** 2)) / z ** 2) - 1);
    if (random() < F) {
      const z = 2 * c * wm[2] - cosO;
      if (z <= 0) return 0;
      weight *= (1 + lambda(cosO)) / (1 + lambda(cosO) + lambda(z)); // G2 / G1, of height-correlated masking
      if (!isInside) return weight;
      cosO = z;
    } else {
      const cosT = Math.sqrt(1 - (1 - c ** 2) / eta ** 2);
      const z = (c / eta - cosT) * wm[2] - cosO / eta;
      if (z >= 0) return 0;
      weight *= 1 / (1 + lambda(-z)); // G1 of the other side alone
      if (isInside) return weight;
      isInside = true;
      cosO = -z;
    }
    // A chord meets the ball at the angle at which it left.
  }
  return 0;
}

/** Heitz 2018, "Sampling the GGX Distribution of Visible Normals" */
function visibleNormal(wo: Vec3, alpha: number, u: number, v: number): Vec3 {
  const size = Math.hypot(alpha * wo[0], alpha * wo[1], wo[2]);
  const h: Vec3 = [(alpha * wo[0]) / size, (alpha * wo[1]) / size, wo[2] / size];
  const across = Math.hypot(h[0], h[1]);
  const t1: Vec3 = across > 0 ? [-h[1] / across, h[0] / across, 0] : [1, 0, 0];
  const t2: Vec3 = [h[1] * t1[2] - h[2] * t1[1], h[2] * t1[0] - h[0] * t1[2], h[0] * t1[1] - h[1] * t1[0]];
  const [r, phi] = [Math.sqrt(u), 2 * Math.PI * v];
  const p1 = r * Math.cos(phi);
  const s = 0.5 * (1 + h[2]);
  const p2 = (1 - s) * Math.sqrt(1 - p1 ** 2) + s * r * Math.sin(phi);
  const p3 = Math.sqrt(Math.max(0, 1 - p1 ** 2 - p2 ** 2));
  const n = [0, 1, 2].map((i) => p1 * t1[i]! + p2 * t2[i]! + p3 * h[i]!);
  const m: Vec3 = [alpha * n[0]!, alpha * n[1]!, Math.max(0, n[2]!)];
  const length = Math.hypot(...m);
  return [m[0] / length, m[1] / length, m[2] / length];
}
