// Thin walls: light passes them straight, and each takes (1 − F)·baseColor·transmission of it, whatever its shape and wherever it comes from.

import { describe, expect, test } from "vitest";
import { PathTracer } from "../../../src/renderer/pathTracer";
import type { Material, Rgb, Scene, SceneObject } from "../../../src/scene/schema";
import { testDevice } from "../../support/device";
import { asExpected, expectColor, look, meanColor, schlick } from "../../support/glass";

const material = "pane";
const TINT: Rgb = [0.9, 0.5, 0.25];
const PANE: Material = { transmission: 1, roughness: 0, baseColor: TINT };
const BLACK: Material = { baseColor: [0, 0, 0], ior: 1 };
const BEHIND: Rgb = [1, 2, 3];

const wall: SceneObject = {
  type: "quad",
  corner: [-50, -50, -9],
  edge1: [100, 0, 0],
  edge2: [0, 100, 0],
  material: "wall",
};
const quadMesh = {
  type: "mesh",
  positions: [-3, -3, 0, 3, -3, 0, 3, 3, 0, -3, 3, 0],
  indices: [0, 1, 2, 0, 2, 3],
  material,
} as const;

/** Before a glowing wall; how often a ray meets it. */
const SHAPES: Readonly<Record<string, readonly [crossings: number, object: SceneObject]>> = {
  quad: [1, { type: "quad", corner: [-3, -3, 0], edge1: [6, 0, 0], edge2: [0, 6, 0], material }],
  triangle: [
    1,
    {
      type: "triangle",
      vertices: [
        [-9, -9, 0],
        [9, -9, 0],
        [0, 9, 0],
      ],
      material,
    },
  ],
  plane: [1, { type: "plane", point: [0, 0, 0], normal: [0, 0, 1], material }],
  sphere: [2, { type: "sphere", center: [0, 0, 0], radius: 3, material }],
  box: [2, { type: "box", center: [0, 0, 0], size: [6, 6, 2], material }],
  mesh: [1, quadMesh],
  "mesh with normals": [1, { ...quadMesh, normals: [0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1] }],
};

/** So narrow a view that all is met head on: 1 − cos⁵ is below 1e-8. */
function before(objects: readonly SceneObject[], pane: Material = PANE, more: Partial<Scene> = {}): Scene {
  return {
    camera: { position: [0, 0, 5], target: [0, 0, 0], verticalFov: 0.2 },
    materials: { pane, wall: { ...BLACK, emission: BEHIND } },
    objects: [...objects, wall],
    maxBounces: 0,
    ...more,
  };
}

const after = (L: Rgb, passes: readonly number[], crossings = 1) =>
  L.map((value, i) => value * passes[i]! ** crossings) as unknown as Rgb;
/** What a pane lets through. */
const clear = (cosine = 1, tint: readonly number[] = TINT) => tint.map((value) => value * (1 - schlick(cosine)));

describe.each(Object.entries(SHAPES))("a wall seen through a %s, seeds 1–4", (name, [crossings, object]) => {
  test("is as bright as it should be", async () => {
    // A path passes with the chance of the brightest channel, so that all of the noise is a coin's.
    expectColor(await look(before([object])), after(BEHIND, clear(), crossings));
  });

  test.runIf(/^(quad|sphere|mesh)$/.test(name))("is so in a tree too", async () => {
    const crowd = Array.from(
      { length: 40 },
      (_, i): SceneObject => ({ type: "sphere", center: [i - 20, -30, 0], radius: 0.4, material: "wall" }),
    );
    expectColor(await look(before([object, ...crowd])), after(BEHIND, clear(), crossings));
  });
});

test.each([
  ["quads", 64, { type: "quad", corner: [-3, -3, 0], edge1: [6, 0, 0], edge2: [0, 6, 0], material }],
] as const)("of the light behind 64 panes (1 − F)⁶⁴ comes through, of %s, seeds 1–4", async (_name, count, object) => {
  const pane = { ...PANE, baseColor: [1, 0.99, 0.98] as const, ior: 1.2 };
  const objects = Array.from({ length: count }, (_, i): SceneObject => ({ ...object, corner: [-3, -3, -i * 0.01] }));
  const passes = pane.baseColor.map((value) => value * (1 - schlick(1, 1.2)));
  expectColor(await look(before(objects, pane)), after(BEHIND, passes, count));
});

describe("seen from the inside of a bubble off its middle, a wall is dimmed once, seeds 1–4", () => {
  test.each([
    ["forwards", -0.6],
    ["backwards", 0.6],
  ])("%s", async (_name, z) => {
    const bubble: SceneObject = { type: "sphere", center: [0, 0, z], radius: 1, material };
    const scene = before([bubble]);
    const camera = { ...scene.camera!, position: [0, 0, 0], target: [0, 0, -1] } as const;
    expectColor(await look({ ...scene, camera }), after(BEHIND, clear()));
  });

  test("and of a bubble that is there in part, as often as it is there", async () => {
    const bubble: SceneObject = { type: "sphere", center: [0, 0, -0.6], radius: 1, material };
    const scene = before([bubble], { ...BLACK, alpha: 0.5, alphaMode: "blend" });
    const camera = { ...scene.camera!, position: [0, 0, 0], target: [0, 0, -1] } as const;
    expectColor(await look({ ...scene, camera }), after(BEHIND, [0.5, 0.5, 0.5]));
    const forwards = { ...camera, target: [0, 0, 1] } as const;
    const other: SceneObject = { ...wall, corner: [50, -50, 9], edge1: [-100, 0, 0] } as SceneObject;
    expectColor(await look({ ...scene, objects: [bubble, other], camera: forwards }), after(BEHIND, [0.5, 0.5, 0.5]));
  });
});

describe("a pane", () => {
  test("at 60° takes what it reflects there, seeds 1–4", async () => {
    const slant: SceneObject = { type: "plane", point: [0, 0, 0], normal: [Math.sin(Math.PI / 3), 0, 0.5], material };
    expectColor(await look(before([slant])), after(BEHIND, clear(0.5)), 1e-3);
  });

  test("takes nothing of an ior of 1, seeds 1–4", async () => {
    expectColor(await look(before([SHAPES.quad![1]], { ...PANE, ior: 1 })), after(BEHIND, TINT));
  });

  test("that lets half through passes half, seeds 1–4", async () => {
    const half = { ...PANE, transmission: 0.5 };
    expectColor(await look(before([SHAPES.quad![1]], half)), after(BEHIND, clear(), 1).map((v) => v / 2) as never);
  });

  test("that is there in part passes all of the rest, seeds 1–4", async () => {
    const part = { ...PANE, alpha: 0.25, alphaMode: "blend" } as const;
    const passes = clear().map((value) => 0.75 + 0.25 * value);
    expectColor(await look(before([SHAPES.quad![1]], part)), after(BEHIND, passes));
  });

  test("of metal passes nothing, seeds 1–4", async () => {
    expectColor(await look(before([SHAPES.quad![1]], { ...PANE, metallic: 1 })), [0, 0, 0]);
  });

  test("is coloured by its vertices, seeds 1–4", async () => {
    const colors = Array.from({ length: 4 }, () => [...TINT, 1]).flat();
    const white = { ...PANE, baseColor: [1, 1, 1] as const };
    expectColor(await look(before([{ ...quadMesh, colors }], white)), after(BEHIND, clear()));
  });

  test("is coloured by its texture, and as clear as another tells, seeds 1–4", async () => {
    const texture = (...texel: number[]) => ({ width: 1, height: 1, texels: texel });
    const textured = {
      ...PANE,
      baseColor: [1, 1, 1] as const,
      baseColorTexture: "color",
      transmissionTexture: "clear",
    };
    const textures = { color: texture(255, 0, 255, 255), clear: texture(51, 0, 0, 255) };
    const mesh = { ...quadMesh, uvs: [0, 0, 1, 0, 1, 1, 0, 1] };
    const [passes] = [clear(1, [0.2, 0, 0.2])];
    expectColor(await look(before([mesh], textured, { textures })), after(BEHIND, passes!));
  });

  test("colours the sky, seeds 1–4", async () => {
    const scene = before([SHAPES.quad![1]]);
    const sky = { ...scene, objects: [SHAPES.quad![1]], environment: { radiance: BEHIND } };
    expectColor(await look(sky), after(BEHIND, clear()));
  });

  test("that glows adds its light to what comes through, seeds 1–4", async () => {
    const glowing = { ...PANE, emission: [0.5, 0.25, 0] as const };
    const expected = after(BEHIND, clear()).map((value, i) => value + glowing.emission[i]!);
    expectColor(await look(before([SHAPES.quad![1]], glowing)), expected as never);
  });

  test("is picked", async () => {
    const scene = before([SHAPES.quad![1]]);
    const tracer = await PathTracer.create({ scene, width: 16, height: 16, device: await testDevice() });
    expect(await tracer.pick(8, 8)).toMatchObject({ kind: "object", index: 0 });
    tracer.dispose();
  });
});

describe("in a sky of 1, a pane is not brighter than it, seeds 1–4", () => {
  const inSky = (pane: Material, more: Partial<Scene> = {}, object: SceneObject = SHAPES.quad![1]): Scene => ({
    camera: { position: [2.6, 0, 1.5], target: [0, 0, 0], verticalFov: 20 }, // at 60°
    materials: { pane: { ...PANE, baseColor: [1, 1, 1], ...pane } },
    objects: [object],
    environment: { radiance: [1, 1, 1] },
    maxBounces: 8,
    ...more,
  });

  test("nor darker, if it is clear", async () => {
    expectColor(await look(inSky({})), [1, 1, 1]);
  });

  test.each<[string, Material]>([
    ["with a clear coat", { clearcoat: 1 }],
    ["with a rough coat", { clearcoat: 1, clearcoatRoughness: 0.5 }],
    ["with sheen", { sheenColor: [1, 1, 1], sheenRoughness: 0.5 }],
    ["with a film", { iridescence: 1 }],
    ["of microfacets", { roughness: 0.5 }],
    ["of microfacets with a coat", { roughness: 0.5, clearcoat: 1 }],
  ])("%s", async (_name, pane) => {
    const { color, error } = meanColor(await look(inSky(pane)));
    for (const [i, value] of color.entries()) {
      expect(value).toBeLessThan(1 + 4 * error[i]! + 1e-3);
      expect(value).toBeGreaterThan(0.75);
    }
  });

  test("with a normal map", async () => {
    // Leans by 30° towards the viewer, or away: then it is seen at grazing angles.
    const lean = (x: number) => ({ width: 1, height: 1, texels: [Math.round(127.5 * (1 + x)), 128, 238, 255] });
    const mesh = { ...quadMesh, uvs: [0, 1, 1, 1, 1, 0, 0, 0] };
    for (const x of [0.5, -0.5]) {
      const scene = inSky({ normalTexture: "lean" }, { textures: { lean: lean(x) } }, mesh);
      const { color, error } = meanColor(await look(scene));
      expect(color[1]!, `${x}`).toBeLessThan(1 + 4 * error[1]! + 1e-3);
    }
  });
});

test("with ior 1, a wall of microfacets loses what is scattered more than once, seeds 1–4", async () => {
  // All of it passes, mirrored at the wall, as GGX with F = 1 would reflect it: head on, of α = 0.36, ∫ D·G·(wo·m) dm.
  const alpha = 0.36;
  const steps = 4000;
  let albedo = 0;
  for (let i = 0; i < steps; i++) {
    // As in directionalAlbedo.ts, whose integrand does not depend on φ head on.
    const u = (i + 0.5) / steps;
    const cosM = 1 / Math.sqrt(1 + (alpha ** 2 * u) / (1 - u));
    const cosI = 2 * cosM ** 2 - 1;
    if (cosI <= 0) continue;
    const lambda = 0.5 * (Math.sqrt(1 + (alpha ** 2 * (1 - cosI ** 2)) / cosI ** 2) - 1);
    albedo += 1 / (1 + lambda) / steps;
  }
  const scene: Scene = {
    camera: { position: [0, 0, 5], target: [0, 0, 0], verticalFov: 0.2 },
    materials: { pane: { ...PANE, baseColor: [1, 1, 1], roughness: 0.6, ior: 1 } },
    objects: [SHAPES.quad![1]],
    environment: { radiance: [1, 1, 1] },
    maxBounces: 1,
  };
  for (const estimator of ["path", "uniform"] as const)
    expectColor(await look(scene, { settings: { estimator }, samples: 256 }), [albedo, albedo, albedo], 1e-4);
});

describe("light through a pane", () => {
  const floor: SceneObject = { type: "plane", point: [0, 0, 0], normal: [0, 1, 0], material: "floor" };
  const lit = (objects: readonly SceneObject[], lights: Scene["lights"]): Scene => ({
    camera: { position: [0, 5, 0.01], target: [0, 0, 0], verticalFov: 0.001 }, // all pixels see one point, to 1e-5 of E
    materials: { floor: { ior: 1 }, pane: PANE },
    objects: [floor, ...objects],
    lights,
    maxBounces: 1,
  });
  // 10 m up, 3 m aside, and the camera between it and the pane.
  const point: Scene["lights"] = [{ type: "point", position: [3, 10, 0], power: [1000, 1000, 1000] }];
  const ball: Scene["lights"] = [{ type: "sphere", position: [3, 10, 0], radius: 0.3, power: [1000, 1000, 1000] }];
  const cosine = 10 / Math.hypot(3, 10);
  const E = (1000 / (4 * Math.PI)) * (cosine / (9 + 100));
  const card: SceneObject = { type: "quad", corner: [1, 6, -1], edge1: [0, 0, 2], edge2: [2, 0, 0], material };
  const bubble: SceneObject = { type: "sphere", center: [3, 10, 0], radius: 1, material };
  const box: SceneObject = { type: "box", center: [1.8, 6, 0], size: [2, 1, 2], material };

  test.each<[string, SceneObject, number, number]>([
    ["a card", card, 1, cosine],
    ["a box", box, 2, cosine],
    ["a bubble around it", bubble, 1, 1],
  ])("from a point is dimmed by %s without any noise, seeds 1–4", async (_name, object, crossings, cos) => {
    const L = E / Math.PI;
    expectColor(await look(lit([object], point)), after([L, L, L], clear(cos), crossings), 3e-5);
  });

  test.each<[string, SceneObject, number]>([
    ["a card", card, 1],
    ["a box", box, 2],
  ])("from a ball is dimmed by %s, seeds 1–4", async (_name, object, crossings) => {
    const L = E / Math.PI;
    // Over the ball, whose half angle is 0.03, F differs by 1e-4 at most, and the cosine cancels to second order.
    expectColor(await look(lit([object], ball)), after([L, L, L], clear(cosine), crossings), 5e-4);
  });

  test.each(["path", "uniform"] as const)(
    "from a ball in a bubble comes in full, but for the bubble, %s estimator, seeds 1–4",
    async (estimator) => {
      const L = E / Math.PI;
      const measured = await look(lit([bubble], ball), { samples: 256, settings: { estimator } });
      // From within 0.3 m of the middle the bubble is met at cosines of 0.95 and more: F differs by less than 1e-5.
      expectColor(measured, after([L, L, L], clear(1)), 5e-4);
    },
  );

  test("reflected by a glossy floor is the same by both estimators, and no firefly, seeds 1–4", async () => {
    const scene: Scene = {
      ...lit([card], ball),
      camera: { position: [-3, 10, 0.01], target: [0, 0, 0], verticalFov: 6 },
      materials: { floor: { metallic: 1, roughness: 0.4 }, pane: { ...PANE, baseColor: [1, 0.8, 0.6] } },
    };
    const path = await look(scene, { samples: 64 });
    const uniform = await look(scene, { samples: 512, settings: { estimator: "uniform" } });
    const [a, b] = [meanColor(path), meanColor(uniform)];
    for (const i of [0, 1, 2]) {
      const sigma = Math.hypot(a.error[i]!, b.error[i]!);
      expect(Math.abs(a.color[i]! - b.color[i]!)).toBeLessThan(4 * sigma);
      // Each pixel by 256 samples whose weights MIS bounds: of the mean of all to 1 %.
      expect(a.error[i]! / a.color[i]!).toBeLessThan(0.01);
    }
    expect(Math.max(...path.mean)).toBeLessThan(1.5 * Math.max(...(asExpected(uniform).image as Float64Array)));
  });
});
