import { describe, expect, test } from "vitest";
import type { Light, Scene, SceneObject, Vec3 } from "../../src/scene/schema";
import { renderScene } from "../support/device";
import { polygonIrradiance, sphereIrradiance } from "../support/irradiance";
import { measurePoint, ROUNDING } from "../support/statistics";

// A grey Lambert plane through the origin, facing +y, and a camera that sees no more of it than the origin: all pixels show
// albedo·E/π, E the irradiance there.
const ALBEDO = 0.5;
// Degrees. At a distance of 10 and 4° of elevation the image covers 2.5e-3 of the plane, and the steepest light below, at
// 0.01 above it, changes by 3·x²/2h² = 0.1 % at the image's edge; all others by less than 1e-6.
const FIELD_OF_VIEW = 1e-4;
// Relative error of one pixel's estimate that all samples share: f32 arithmetic of some ten operations on coordinates
// that are exact to 2⁻²⁴.
const ARITHMETIC = 1e-5;

const ESTIMATORS = ["path", "uniform"] as const;

type Lit = { readonly objects?: SceneObject[]; readonly lights?: Light[]; readonly elevation?: number };

async function expectIrradiance(lit: Lit, expected: number, estimator: "path" | "uniform", seed: number) {
  const { image, stats } = await renderScene(litPlane(lit), {
    size: [32, 32],
    samples: 64,
    seed,
    settings: { estimator, maxBounces: 1 },
  });
  const { mean, standardError } = measurePoint(image);
  expect(stats.badSamples).toBe(0);
  const radiance = (ALBEDO * expected) / Math.PI;
  expect(Math.abs(mean - radiance)).toBeLessThanOrEqual(4 * standardError + (ROUNDING + ARITHMETIC) * radiance);
  return standardError / radiance;
}

function litPlane({ objects = [], lights = [], elevation = 30 }: Lit): Scene {
  const angle = (elevation * Math.PI) / 180;
  return {
    camera: {
      position: [10 * Math.cos(angle), 10 * Math.sin(angle), 0],
      target: [0, 0, 0],
      verticalFov: FIELD_OF_VIEW,
    },
    materials: {
      floor: { baseColor: [ALBEDO, ALBEDO, ALBEDO], ior: 1 },
      lamp: { baseColor: [0, 0, 0], ior: 1, emission: [1, 1, 1] },
    },
    objects: [{ type: "plane", point: [0, 0, 0], normal: [0, 1, 0], material: "floor" }, ...objects],
    lights,
  };
}

const FLAT_LIGHTS: Readonly<Record<string, { corner: Vec3; edge1: Vec3; edge2: Vec3 }>> = {
  "overhead, parallel": { corner: [-1, 2, -1], edge1: [2, 0, 0], edge2: [0, 0, 2] },
  "close and large": { corner: [-6, 1, -4], edge1: [7, 0, 0], edge2: [0, 0, 7] },
  "small and far": { corner: [-30, 40, 1], edge1: [0.1, 0, 0.02], edge2: [0, 0.02, 0.1] },
  "upright, standing on the plane": { corner: [-2, 0, -1], edge1: [0, 2, 0], edge2: [0, 0, 3] },
  "tilted, half below the horizon": { corner: [-2, -1, -1], edge1: [0.5, 2, 0.3], edge2: [-0.4, 0.6, 3] },
};

describe.each(Object.keys(FLAT_LIGHTS))("a plane lit by a flat light, %s,", (name) => {
  const { corner, edge1, edge2 } = FLAT_LIGHTS[name]!;
  const [b, d] = [add(corner, edge1), add(corner, edge2)];

  test.each(ESTIMATORS)("shows the irradiance of a quad, %s estimator, seed 1", async (estimator) => {
    const expected = polygonIrradiance([0, 0, 0], [corner, b, add(b, edge2), d]);
    expect(expected).toBeGreaterThan(0);
    const quad: SceneObject = { type: "quad", corner, edge1, edge2, material: "lamp" };
    await expectIrradiance({ objects: [quad] }, expected, estimator, 1);
  });

  test.each(ESTIMATORS)("shows the irradiance of a triangle, %s estimator, seed 2", async (estimator) => {
    const expected = polygonIrradiance([0, 0, 0], [corner, b, d]);
    const triangle: SceneObject = { type: "triangle", vertices: [corner, b, d], material: "lamp" };
    await expectIrradiance({ objects: [triangle] }, expected, estimator, 2);
  });

  test.each(ESTIMATORS)(
    "shows the irradiance of a mesh of uneven triangles, %s estimator, seed 10",
    async (estimator) => {
      const expected = polygonIrradiance([0, 0, 0], [corner, b, add(b, edge2), d]);
      await expectIrradiance({ objects: [unevenMesh(corner, edge1, edge2)] }, expected, estimator, 10);
    },
  );

  test("stays dark behind it, seed 3", async () => {
    const quad: SceneObject = { type: "quad", corner, edge1: edge2, edge2: edge1, material: "lamp" };
    await expectIrradiance({ objects: [quad] }, 0, "path", 3);
  });
});

describe.each([0, 30])("a plane lit by a glowing box turned by %d°", (rotationY) => {
  test.each(ESTIMATORS)("shows the sum of its visible faces, %s estimator, seed 4", async (estimator) => {
    const center: Vec3 = [-1.5, 1.2, 0.7];
    const size: Vec3 = [1, 0.8, 1.6];
    const faces = boxFaces(center, size, rotationY);
    const expected = faces.reduce((sum, face) => sum + polygonIrradiance([0, 0, 0], face), 0);
    await expectIrradiance(
      { objects: [{ type: "box", center, size, rotationY, material: "lamp" }] },
      expected,
      estimator,
      4,
    );
  });
});

// Distance of the light's centre in radii, and the camera's elevation, low enough to look under the light.
const DISTANCES = [
  { distance: 1.01, elevation: 4 },
  { distance: 1.1, elevation: 10 },
  { distance: 2, elevation: 30 },
  { distance: 100, elevation: 30 },
  { distance: 1e4, elevation: 30 },
];

describe.each(DISTANCES)("a plane $distance radii below the centre of a sphere light", ({ distance, elevation }) => {
  test.each(ESTIMATORS)("shows E = L·π·(r/d)² = power / 4πd², %s estimator, seed 5", async (estimator) => {
    const light: Light = { type: "sphere", position: [0, distance, 0], radius: 1, power: [100, 100, 100] };
    await expectIrradiance({ lights: [light], elevation }, 100 / (4 * Math.PI * distance ** 2), estimator, 5);
  });
});

describe.each([
  ["aslant", [-3, 4, 1], 0.5],
  ["close above the horizon", [-2, 0.6, 0], 0.5],
  ["cut by the horizon", [-2, 0.2, 1], 0.5],
  ["mostly below the horizon", [-2, -0.4, 0], 0.5],
] as const)("a sphere light %s", (_, position, radius) => {
  test.each(ESTIMATORS)("gives the irradiance of its visible part, %s estimator, seed 6", async (estimator) => {
    // Radiance 1: power 4π²r².
    const power = 4 * Math.PI ** 2 * radius ** 2;
    const light: Light = { type: "sphere", position, radius, power: [power, power, power] };
    await expectIrradiance({ lights: [light] }, sphereIrradiance([0, 0, 0], position, radius), estimator, 6);
  });

  test.each(ESTIMATORS)("gives the same as a glowing sphere, %s estimator, seed 7", async (estimator) => {
    const ball: SceneObject = { type: "sphere", center: position, radius, material: "lamp" };
    await expectIrradiance({ objects: [ball] }, sphereIrradiance([0, 0, 0], position, radius), estimator, 7);
  });
});

test.each(ESTIMATORS)(
  "a point light gives E = power·cos θ / 4πd², without noise, %s estimator, seed 8",
  async (estimator) => {
    const light: Light = { type: "point", position: [-3, 4, 1], power: [100, 100, 100] };
    const d2 = 9 + 16 + 1;
    const noise = await expectIrradiance(
      { lights: [light] },
      (100 * (4 / Math.sqrt(d2))) / (4 * Math.PI * d2),
      estimator,
      8,
    );
    expect(noise).toBeLessThan(1e-6);
  },
);

test.each([0.01, 0.03, 0.1, 0.3, 1, 3])(
  "a sphere light of radius %d gives what its power says, whatever its size, seed 9",
  async (radius) => {
    const light: Light = { type: "sphere", position: [-6, 8, 0], radius, power: [100, 100, 100] };
    await expectIrradiance({ lights: [light] }, (100 * 0.8) / (4 * Math.PI * 100), "path", 9);
  },
);

/** A quad as a mesh: two rows of three, each cut in two, of which the largest has forty times the area of the smallest. */
function unevenMesh(corner: Vec3, edge1: Vec3, edge2: Vec3): SceneObject {
  const [columns, rows] = [
    [0, 0.05, 0.4, 1],
    [0, 0.3, 1],
  ] as const;
  const positions = rows.flatMap((v) =>
    columns.flatMap((u) => [0, 1, 2].map((axis) => corner[axis]! + u * edge1[axis]! + v * edge2[axis]!)),
  );
  const indices = [0, 1, 2, 4, 5, 6].flatMap((a) => [a, a + 1, a + 4, a + 1, a + 5, a + 4]);
  return { type: "mesh", positions, indices, material: "lamp" };
}

function boxFaces(center: Vec3, size: Vec3, rotationY: number): Vec3[][] {
  const angle = (rotationY * Math.PI) / 180;
  const corner = (x: number, y: number, z: number): Vec3 => {
    const [u, v, w] = [(x * size[0]) / 2, (y * size[1]) / 2, (z * size[2]) / 2];
    // Counter-clockwise from above, in a right-handed frame: x turns towards −z.
    return add(center, [u * Math.cos(angle) + w * Math.sin(angle), v, w * Math.cos(angle) - u * Math.sin(angle)]);
  };
  return [1, -1].flatMap((s) => [
    orient(s, [corner(s, -1, -1), corner(s, 1, -1), corner(s, 1, 1), corner(s, -1, 1)]),
    orient(s, [corner(-1, s, -1), corner(-1, s, 1), corner(1, s, 1), corner(1, s, -1)]),
    orient(s, [corner(-1, -1, s), corner(1, -1, s), corner(1, 1, s), corner(-1, 1, s)]),
  ]);
}

/** Written counter-clockwise for the face on the positive side. */
function orient(side: number, face: Vec3[]): Vec3[] {
  return side > 0 ? face : face.toReversed();
}

function add(a: Vec3, b: Vec3): Vec3 {
  return [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
}
