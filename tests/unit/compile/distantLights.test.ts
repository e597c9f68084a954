import { describe, expect, test } from "vitest";
import { lightsOfScene } from "../../../src/compile/lights";
import { primitivesOf } from "../../../src/compile/primitives";
import { directionalLight, pointLight, sphere, sphereLight, spotLight } from "../../../src/scene/builders";
import { parseScene } from "../../../src/scene/parseScene";
import type { Light } from "../../../src/scene/schema";
import { inSceneUnits } from "../../../src/shapes/sceneUnits";
import { compile, sceneOf } from "../../support/compiled";

const BALL = sphere({ center: [0, 1, 0], radius: 1, material: "lambert" });
const sun = (fields: object = {}) =>
  directionalLight({ direction: [0, -2, 0], irradiance: [1, 2, 3], angularDiameter: 0.53, ...fields });
const spot = (fields: object = {}) =>
  spotLight({ position: [0, 3, 0], direction: [0, -2, 0], power: [1, 2, 3], outerAngle: 30, ...fields });

const lightsIn = (lights: readonly Light[]) => {
  const scene = parseScene(sceneOf([BALL], lights));
  return lightsOfScene(scene, primitivesOf(scene));
};
const textOf = (lights: readonly Light[]) => compile(sceneOf([BALL], lights)).sceneModule;

test("lights that are infinitely far come last", () => {
  const lamp = sphereLight({ position: [0, 3, 0], radius: 0.5, power: [1, 1, 1] });
  const kinds = lightsIn([sun(), pointLight({ position: [0, 3, 0], power: [1, 1, 1] }), sun(), lamp, spot()]);
  expect(kinds.map(({ kind }) => kind)).toEqual(["sphere", "point", "spot", "directional", "directional"]);
});

describe("a sun", () => {
  test("has the radiance whose integral over the disk, times the cosine, is its irradiance", () => {
    for (const diameter of [0.002, 0.53, 30, 170]) {
      const [{ radiance, size }] = lightsIn([sun({ angularDiameter: diameter })]) as [
        ReturnType<typeof lightsIn>[number],
      ];
      // ∫ 2π·c dc from 1 − size to 1.
      expect((radiance[2] * Math.PI * (1 - (1 - size) ** 2)) / 3).toBeCloseTo(1, diameter < 0.1 ? 5 : 10);
    }
  });

  test("is a point, of its irradiance, if it is too small for a direction in f32", () => {
    expect(lightsIn([sun({ angularDiameter: 0.0009 })])[0]).toMatchObject({ size: 0, radiance: [1, 2, 3] });
  });

  test("is found by rays that escape only if it has a size", () => {
    expect(compile(sceneOf([BALL], [sun()])).features.SKY_DISKS).toBe(true);
    expect(compile(sceneOf([BALL], [sun({ irradiance: [0, 0, 0] })])).features.SKY_DISKS).toBe(true);
    expect(compile(sceneOf([BALL], [sun({ angularDiameter: 0 })])).features.SKY_DISKS).toBe(false);
  });

  test.each([
    ["direction", { direction: [1, -1, 0] }],
    ["irradiance", { irradiance: [0, 0, 0] }],
    ["diameter", { angularDiameter: 10 }],
  ])("of another %s needs no other program", (_, fields) => {
    expect(textOf([sun(fields)])).toBe(textOf([sun()]));
    expect(textOf([spot(), sun(fields)])).toBe(textOf([spot(), sun()]));
  });
});

describe("a spot", () => {
  test.each([
    ["direction", { direction: [1, -1, 0] }],
    ["power", { power: [0, 0, 0] }],
    ["inner angle", { innerAngle: 10 }],
    ["outer angle", { outerAngle: 50 }],
    ["radius", { radius: 1 }],
  ])("of another %s needs no other program", (_, fields) => {
    expect(textOf([spot(fields)])).toBe(textOf([spot()]));
  });

  test.each([
    [0, 90],
    [20, 40],
    [0, 0.01],
    [89, 90],
  ])("has the intensity whose integral over its cone is its power, %d° to %d°", (innerAngle, outerAngle) => {
    const [{ radiance }] = lightsIn([spot({ innerAngle, outerAngle })]) as [ReturnType<typeof lightsIn>[number]];
    const cosine = (degrees: number) => 2 * Math.sin((degrees * Math.PI) / 360) ** 2;
    const [inner, outer] = [cosine(innerAngle), cosine(outerAngle)];
    let integral = 2 * Math.PI * inner;
    const steps = 1000;
    for (let i = 0; i < steps; i++) integral += (2 * Math.PI * (outer - inner) * ((i + 0.5) / steps) ** 2) / steps;
    expect((radiance[2] * integral) / 3).toBeCloseTo(1, 6);
  });
});

test("in another unit a sun's irradiance stays, and of a spot power and intensity go as area", () => {
  const lights = [sun(), spot({ radius: 2 ** 20 }), spot({ power: undefined, intensity: [1, 1, 1] })];
  const { unit, scene } = inSceneUnits(
    parseScene({ ...sceneOf([BALL], lights), camera: { position: [0, 0, 2 ** 20] } }),
  );
  expect(unit).toBe(2 ** 20);
  expect(scene.lights[0]).toEqual(parseScene(sceneOf([BALL], lights)).lights[0]);
  expect(scene.lights[1]).toMatchObject({ power: [2 ** -40, 2 ** -39, 3 * 2 ** -40], radius: 1 });
  expect(scene.lights[2]).toMatchObject({ intensity: [2 ** -40, 2 ** -40, 2 ** -40], radius: 0 });
});
