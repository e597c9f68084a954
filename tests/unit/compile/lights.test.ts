import { describe, expect, test } from "vitest";
import { lightsOfScene } from "../../../src/compile/lights";
import { primitivesOf } from "../../../src/compile/primitives";
import type { Light as SampledLight } from "../../../src/lights/light";
import { add, cross, length, normalize, scale, subtract } from "../../../src/math/vec3";
import { box, plane, pointLight, quad, sphere, sphereLight, triangle } from "../../../src/scene/builders";
import { parseScene } from "../../../src/scene/parseScene";
import type { Light, Material, SceneObject, Vec3 } from "../../../src/scene/schema";
import { sceneOf } from "../../support/compiled";

const MATERIALS: Record<string, Material> = { glow: { emission: [1, 1, 1] }, bright: { emission: [2, 4, 3] } };
const UNIT_QUAD = quad({ corner: [0, 0, 0], edge1: [1, 0, 0], edge2: [0, 1, 0], material: "glow" });

function emit(objects: readonly SceneObject[], lights: readonly Light[] = []): SampledLight[] {
  const scene = parseScene(sceneOf(objects, lights, MATERIALS));
  return lightsOfScene(scene, primitivesOf(scene));
}

function sphereOfLight(power: number, radius = 1): Light {
  return sphereLight({ position: [0, 5, 0], radius, power: [power, power, power] });
}

function pointOfLight(power: number): Light {
  return pointLight({ position: [0, 5, 0], power: [power, power, power] });
}

/** Watts, summed over the channels, by the emitter's own geometry. */
function powerOf({ kind, radiance, size }: SampledLight): number {
  const sum = radiance[0] + radiance[1] + radiance[2];
  if (kind === "point") return 4 * Math.PI * sum;
  return Math.PI * sum * (kind === "sphere" ? 4 * Math.PI * size ** 2 : size);
}

describe("strength and bound", () => {
  const triangleVertices: [Vec3, Vec3, Vec3] = [
    [0, 0, 0],
    [3, 0, 0],
    [0, 2, 0],
  ];
  const objects = [
    UNIT_QUAD,
    triangle({ vertices: triangleVertices, material: "bright" }),
    sphere({ center: [0, 2, 0], radius: 0.5, material: "bright" }),
    box({ center: [4, 0, 0], size: [1, 2, 3], rotationY: 20, material: "glow" }),
  ];
  const lights = [sphereOfLight(7), pointOfLight(11)];

  test("strengths are intensities, in proportion to the strongest's", () => {
    const emitters = emit(objects, lights);
    expect(emitters).toHaveLength(1 + 1 + 1 + 6 + 1 + 1);
    const intensities = emitters.map((emitter) => {
      const isFlat = emitter.kind === "quad" || emitter.kind === "triangle";
      return powerOf(emitter) / (isFlat ? Math.PI : 4 * Math.PI);
    });
    const strongest = Math.max(...intensities);
    expect(emitters.map(({ strength }) => strength)).toEqual(intensities.map((i) => expect.closeTo(i / strongest, 12)));
  });

  test("strengths stay finite where radiance times area would not be, in f32", () => {
    const huge = quad({ corner: [0, 0, 0], edge1: [1e18, 0, 0], edge2: [0, 1e18, 0], material: "blinding" });
    const scene = parseScene(sceneOf([huge], [pointOfLight(1)], { blinding: { emission: [1e18, 1e18, 1e18] } }));
    const emitters = lightsOfScene(scene, primitivesOf(scene));
    expect(emitters.every(({ strength }) => strength >= 0 && strength <= 1)).toBe(true);
  });

  test("only quads and triangles have a front", () => {
    expect(emit(objects, lights).map(({ front }) => front !== undefined)).toEqual([
      true,
      true,
      false,
      ...Array(6).fill(false),
      false,
      false,
    ]);
  });

  test("every emitter lies in its bound, and a box's faces share one", () => {
    const emitters = emit(objects, lights);
    for (const { kind, position, edge1, edge2, size, bound } of emitters) {
      const far = kind === "sphere" ? size : 0;
      const corners = [position, add(position, edge1), add(position, edge2)];
      if (kind === "quad") corners.push(add(add(position, edge1), edge2));
      for (const corner of corners) {
        expect(length(subtract(corner, bound.center)) + far).toBeLessThanOrEqual(bound.radius * (1 + 1e-12));
      }
    }
    const faces = emitters.filter(({ primitive }) => primitive === 3);
    expect(new Set(faces.map(({ bound }) => bound)).size).toBe(1);
  });

  test("a light turned down to 0 stays an emitter, without strength", () => {
    const emitters = emit([], [sphereOfLight(0), pointOfLight(0), pointOfLight(5)]);
    expect(emitters.map(({ kind }) => kind)).toEqual(["sphere", "point", "point"]);
    expect(emitters.map(({ strength }) => strength > 0)).toEqual([false, false, true]);
  });

  test("a scene without emitters has none", () => {
    expect(emit([sphere({ center: [0, 0, 0], radius: 1, material: "lambert" })])).toEqual([]);
  });
});

describe("power", () => {
  test.each([1e-3, 0.1, 2, 1e4])("a sphere light of radius %d gives its power", (radius) => {
    const [emitter] = emit([], [sphereOfLight(60, radius)]);
    expect(powerOf(emitter!)).toBeCloseTo(3 * 60, 9);
  });

  test("a sphere light's radius changes no strength", () => {
    const strength = (radius: number) => emit([], [sphereOfLight(60, radius), pointOfLight(90)])[0]!.strength;
    expect(strength(0.01)).toBeCloseTo(60 / 90, 12);
    expect(strength(1)).toBeCloseTo(60 / 90, 12);
  });

  test("a point light's intensity is power / 4π", () => {
    const [emitter] = emit([], [pointOfLight(60)]);
    expect(emitter).toMatchObject({ kind: "point", size: 0, primitive: undefined });
    expect(emitter!.radiance[1]).toBeCloseTo(60 / (4 * Math.PI), 12);
  });
});

describe("surfaces", () => {
  test("an emitter names the primitive that carries it", () => {
    const dark = sphere({ center: [0, 0, 0], radius: 1, material: "lambert" });
    const emitters = emit([dark, UNIT_QUAD], [pointOfLight(1), sphereOfLight(1)]);
    expect(emitters.map(({ kind, primitive }) => [kind, primitive])).toEqual([
      ["quad", 1],
      ["sphere", 2],
      ["point", undefined],
    ]);
  });

  test("a triangle has half the area of its parallelogram", () => {
    const vertices = [
      [1, 1, 1],
      [4, 1, 1],
      [1, 3, 1],
    ] as const;
    const [emitter] = emit([triangle({ vertices, material: "glow" })]);
    expect(emitter).toMatchObject({ kind: "triangle", position: [1, 1, 1], edge1: [3, 0, 0], edge2: [0, 2, 0] });
    expect(emitter!.size).toBe(3);
  });

  test("a triangle without area is never an emitter", () => {
    const vertices = [
      [0, 0, 0],
      [1, 1, 1],
      [2, 2, 2],
    ] as const;
    expect(emit([triangle({ vertices, material: "glow" })])).toEqual([]);
  });

  test("under a coat and behind holes nothing is sampled: what leaves there is less than the emission", () => {
    const rare = [{ clearcoat: 0.5 }, { alpha: 0.5, alphaMode: "blend" }, { transmission: 1, roughness: 0 }] as const;
    for (const material of rare) {
      const glow = { ...MATERIALS.glow, ...material };
      const scene = parseScene(sceneOf([UNIT_QUAD], [], { glow }));
      expect(lightsOfScene(scene, primitivesOf(scene))).toEqual([]);
    }
    expect(emit([UNIT_QUAD])).toHaveLength(1);
  });

  test("an infinite plane emits but cannot be sampled", () => {
    expect(emit([plane({ point: [0, 0, 0], normal: [0, 1, 0], material: "glow" })])).toEqual([]);
  });

  test.each([0, 30, 90, 200, -45])(
    "a box turned by %d degrees is six quads that face out, with its areas",
    (rotationY) => {
      const center: Vec3 = [5, -2, 7];
      const size: Vec3 = [1, 2, 3];
      const faces = emit([box({ center, size, rotationY, material: "glow" })]);
      expect(faces).toHaveLength(6);
      expect(faces.map((face) => face.size).sort((a, b) => a - b)).toEqual(
        [2, 2, 3, 3, 6, 6].map((a) => expect.closeTo(a, 12)),
      );

      const [c, s] = [Math.cos((rotationY * Math.PI) / 180), Math.sin((rotationY * Math.PI) / 180)];
      for (const { position, edge1, edge2, size: area, primitive } of faces) {
        expect(primitive).toBe(0);
        expect(length(cross(edge1, edge2))).toBeCloseTo(area, 12);
        const faceCenter = [0, 1, 2].map((i) => position[i]! + (edge1[i]! + edge2[i]!) / 2) as [number, number, number];
        const outward = subtract(faceCenter, center);
        const normal = normalize(cross(edge1, edge2));
        const misalignment = length(subtract(normal, normalize(outward)));
        expect(misalignment).toBeLessThan(1e-12);

        // Its corners are the box's, in the box's own frame: undone, the turn counter-clockwise from above.
        const corners = [position, ...[edge1, edge2].map((edge) => subtract(position, scale(edge, -1)))];
        for (const corner of corners) {
          const [x, y, z] = subtract(corner, center);
          const local = [c * x - s * z, y, s * x + c * z];
          expect(local.map(Math.abs)).toEqual(scale(size, 0.5).map((half) => expect.closeTo(half, 12)));
        }
      }
    },
  );
});
