import { describe, expect, test } from "vitest";
import { Blockers } from "../../../src/compile/blockers";
import { lightsOfScene } from "../../../src/compile/lights";
import { primitivesOf } from "../../../src/compile/primitives";
import { subtract } from "../../../src/math/vec3";
import {
  box,
  directionalLight,
  plane,
  pointLight,
  quad,
  sphere,
  sphereLight,
  triangle,
} from "../../../src/scene/builders";
import { parseScene } from "../../../src/scene/parseScene";
import type { Light, SceneObject, Vec3 } from "../../../src/scene/schema";
import { sceneOf } from "../../support/compiled";
import { loadReference } from "../../support/reference";

const CAMERA: Vec3 = [0, 1, 5];
const material = "lambert";
const floor = quad({ corner: [-1, 0, 1], edge1: [2, 0, 0], edge2: [0, 0, -2], material });
const ground = plane({ point: [0, 0, 0], normal: [0, 1, 0], material });
const lamp = sphereLight({ position: [0, 3, 0], radius: 0.5, power: [1, 1, 1] });

/** Ids of the primitives that can block: the objects in order, then the sphere lights. */
function blockersOf(objects: readonly SceneObject[], lights: readonly Light[], camera = CAMERA, reach = 0): number[] {
  return blockersIn(parseScene(sceneOf(objects, lights)), camera, reach);
}

function blockersIn(scene: ReturnType<typeof parseScene>, camera: Vec3, reach = 0): number[] {
  const primitives = primitivesOf(scene);
  const emitters = lightsOfScene(scene, primitives);
  const blockers = new Blockers(primitives, emitters);
  return [...primitives.keys()].filter((id) => blockers.canBlock(id, subtract(camera, scene.camera.target), reach));
}

describe("a quad or triangle", () => {
  test("with everything on one side never blocks; bodies always may", () => {
    const ball = sphere({ center: [0, 0.5, 0], radius: 0.5, material }); // touches the floor
    const crate = box({ center: [0.5, 0.25, 0.5], size: [0.5, 0.5, 0.5], rotationY: 30, material });
    expect(blockersOf([floor, ball, crate], [lamp])).toEqual([1, 2, 3]);
  });

  test("blocks as soon as something reaches through it", () => {
    const sunk = sphere({ center: [0, 0.4, 0], radius: 0.5, material });
    expect(blockersOf([floor, sunk], [lamp])).toContain(0);
  });

  test("blocks between a light behind it and a surface in front", () => {
    const shelf = triangle({
      vertices: [
        [-1, 1, 0],
        [1, 1, 0],
        [0, 1, 1],
      ],
      material,
    });
    expect(blockersOf([floor, shelf], [lamp])).toContain(1);
    expect(blockersOf([floor, shelf], [pointLight({ position: [0, 0.5, 0], power: [1, 1, 1] })])).not.toContain(1);
  });

  test("may block where an infinite plane passes behind it", () => {
    expect(blockersOf([floor, plane({ point: [0, 0, -3], normal: [0, 0, 1], material })], [lamp])).toContain(0);
  });
});

describe("an infinite plane", () => {
  test("never blocks with the camera and every light in front, whatever reaches through it", () => {
    const sunk = sphere({ center: [0, 0.4, 0], radius: 0.5, material });
    expect(blockersOf([ground, sunk], [lamp])).not.toContain(0);
  });

  test("of water or paper may block, because light gets to what lies behind it", () => {
    const opaque = sceneOf([ground], [lamp]);
    for (const more of [{ transmission: 1, thickness: 1 }, { diffuseTransmission: 0.5 }]) {
      const materials = { ...opaque.materials, lambert: { ...opaque.materials!.lambert, ...more } };
      expect(blockersIn(parseScene({ ...opaque, materials }), CAMERA)).toContain(0);
    }
  });

  test("blocks for a camera on its other side", () => {
    expect(blockersOf([ground], [lamp], [0, -1, 5])).toContain(0);
  });

  test("blocks for a camera whose rays may start on its other side", () => {
    expect(blockersOf([ground], [lamp], CAMERA, 0.99)).not.toContain(0);
    for (const reach of [1.01, Number.POSITIVE_INFINITY]) {
      expect(blockersOf([ground], [lamp], CAMERA, reach)).toContain(0);
    }
  });

  test("blocks a light that reaches through it", () => {
    expect(blockersOf([ground], [sphereLight({ position: [0, 0.2, 0], radius: 0.5, power: [1, 1, 1] })])).toContain(0);
  });
});

describe("towards a sun, a flat shape with everything on one side", () => {
  const from = (x: number, y: number, z: number, angularDiameter = 0) =>
    directionalLight({ direction: [-x, -y, -z], irradiance: [1, 1, 1], angularDiameter });
  const ball = sphere({ center: [0, 0.5, 0], radius: 0.5, material });

  test.each([
    ["never blocks where the sun is on that side", from(1, 1, 0), false],
    ["blocks where it is on the other", from(1, -1, 0), true],
    ["may block where it is in its plane", from(1, 0, 0), true],
    ["may block where a part of the disk is on the other side", from(1, 0.1, 0, 15), true],
    ["never blocks where all of the disk is on that side", from(1, 0.1, 0, 10), false],
  ])("%s", (_, sun, blocks) => {
    expect(blockersOf([floor, ball], [sun]).includes(0)).toBe(blocks);
    expect(blockersOf([ground, ball], [sun]).includes(0)).toBe(blocks);
    // Whatever side its front is on, and with another sun on the right side.
    const turned = quad({ corner: [-1, 0, 1], edge1: [0, 0, -2], edge2: [2, 0, 0], material });
    expect(blockersOf([turned, ball], [from(0, 1, 0), sun]).includes(0)).toBe(blocks);
  });
});

test("in the Cornell box only the two boxes and what hides behind the lamp's plane can block", () => {
  const scene = parseScene(loadReference("cornell").scene);
  // Walls 0–4 have everything on one side. The lamp, 5, hangs below the ceiling and has both sides occupied.
  expect(blockersIn(scene, scene.camera.position)).toEqual([5, 6, 7]);
});
