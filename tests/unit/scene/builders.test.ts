import { expect, expectTypeOf, test } from "vitest";
import * as build from "../../../src/scene/builders";
import { metals } from "../../../src/scene/metals";
import { parseScene } from "../../../src/scene/parseScene";
import type { Camera, Light, Material, Scene, SceneObject } from "../../../src/scene/schema";

test("a scene made of every builder is valid", () => {
  const material = "gold";
  const scene = build.scene({
    camera: build.camera({ position: [0, 1, 5] }),
    materials: {
      gold: build.material({ baseColor: metals.gold, metallic: 1, roughness: 0.2 }),
      white: build.material(),
    },
    objects: [
      build.sphere({ center: [0, 1, 0], radius: 1, material }),
      build.plane({ point: [0, 0, 0], normal: [0, 1, 0], material: "white" }),
      build.quad({ corner: [0, 0, 0], edge1: [1, 0, 0], edge2: [0, 1, 0], material }),
      build.triangle({
        vertices: [
          [0, 0, 0],
          [1, 0, 0],
          [0, 1, 0],
        ],
        material,
      }),
      build.box({ center: [0, 0, 0], size: [1, 1, 1], material }),
      build.mesh({ positions: [0, 0, 0, 1, 0, 0, 0, 1, 0], indices: [0, 1, 2], material }),
    ],
    lights: [
      build.pointLight({ position: [0, 4, 0], power: [60, 60, 60] }),
      build.sphereLight({ position: [0, 4, 0], radius: 0.1, power: [60, 60, 60] }),
      build.spotLight({ position: [0, 4, 0], direction: [0, -1, 0], power: [60, 60, 60], outerAngle: 30 }),
      build.directionalLight({ direction: [0, -1, 0], irradiance: [3, 3, 3], angularDiameter: 0.53 }),
    ],
  });
  const parsed = parseScene(scene);
  expect(parsed.objects.map(({ type }) => type)).toEqual(["sphere", "plane", "quad", "triangle", "box", "mesh"]);
  expect(parsed.lights.map(({ type }) => type)).toEqual(["point", "sphere", "spot", "directional"]);
});

test("a builder adds the type and nothing else", () => {
  expect(build.sphere({ center: [0, 1, 0], radius: 1, material: "red" })).toStrictEqual({
    type: "sphere",
    center: [0, 1, 0],
    radius: 1,
    material: "red",
  });
  expect(build.material()).toStrictEqual({});
});

test("builders take the fields of the format, without the type", () => {
  expectTypeOf(build.sphere).returns.toExtend<SceneObject>();
  expectTypeOf(build.sphere).returns.toHaveProperty("type").toEqualTypeOf<"sphere">();
  expectTypeOf(build.sphere).parameter(0).not.toHaveProperty("type");
  expectTypeOf(build.box).parameter(0).toHaveProperty("rotationY").toEqualTypeOf<number | undefined>();
  expectTypeOf(build.pointLight).returns.toExtend<Light>();
  expectTypeOf(build.pointLight).parameter(0).not.toHaveProperty("radius");
  expectTypeOf(build.camera).parameters.toEqualTypeOf<[Camera]>();
  expectTypeOf(build.material).returns.toEqualTypeOf<Material>();
  expectTypeOf(build.scene).returns.toEqualTypeOf<Scene>();

  // @ts-expect-error: a sphere needs a radius
  build.sphere({ center: [0, 0, 0], material: "red" });
  // @ts-expect-error: a misspelt field
  build.material({ rougness: 0.5 });
  // @ts-expect-error: two numbers are no point
  build.camera({ position: [0, 1] });
});
