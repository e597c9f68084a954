import { describe, expect, test } from "vitest";
import type { Material, SceneObject, Vec3 } from "../../../src/scene/schema";
import { compile, sceneOf } from "../../support/compiled";

const TINTED = {
  transmission: 1,
  thickness: 1,
  roughness: 0,
  attenuationColor: [1, 0.5, 0],
  attenuationDistance: 1,
} as const;
const CLEAR = { transmission: 1, thickness: 1, roughness: 0 } as const;
const MATERIALS: Readonly<Record<string, Material>> = { tinted: TINTED, clear: CLEAR };

const ball = (center: Vec3, material = "tinted"): SceneObject => ({ type: "sphere", center, radius: 1, material });

function seenFrom(position: Vec3, objects: readonly SceneObject[]) {
  return compile({ ...sceneOf(objects, [], MATERIALS), camera: { position, target: [0, 0, -20] } });
}

describe("a program finds out what the camera is in", () => {
  const objects = [ball([0, 0, 0]), ball([0, 0, -5], "clear")];

  test.each([
    ["in the box around a solid that absorbs", [0.9, 0.9, 0], true],
    ["outside of it", [0, 0, 1.1], false],
    ["in a clear solid", [0, 0, -5], false],
  ] as const)("only where it may be in a solid that absorbs: %s", (_name, position, expected) => {
    expect(seenFrom(position, objects).features.IMMERSED).toBe(expected);
  });

  test("and with an infinite one, or parallel rays, in any case", () => {
    const ocean: SceneObject = { type: "plane", point: [0, -9, 0], normal: [0, 1, 0], material: "tinted" };
    expect(seenFrom([0, 0, 9], [ocean]).features.IMMERSED).toBe(true);
    const camera = { position: [0, 0, 9], orthographicHeight: 1 } as const;
    expect(compile({ ...sceneOf(objects, [], MATERIALS), camera }).features.IMMERSED).toBe(true);
  });

  test("a camera that moves into a solid needs another program, and one that moves out does not", () => {
    const outside = seenFrom([0, 0, 9], objects);
    const inside = seenFrom([0, 0, 0.5], objects);
    const camera = { target: [0, 0, -20], up: [0, 1, 0], verticalFov: 45, aperture: 0 } as const;
    expect(outside.isFor({ ...camera, position: [0, 0, 0.5] })).toBe(false);
    expect(outside.isFor({ ...camera, position: [0, 0, 5] })).toBe(true);
    expect(inside.isFor({ ...camera, position: [0, 0, 9] })).toBe(true);
    expect(inside.isFor({ ...camera, position: [0, 0, 9], aperture: 0.1 })).toBe(false);
  });
});

describe("a program looks for what a path is in after a solid", () => {
  test.each([
    ["that holds another", [ball([0, 0, 0]), { ...ball([0.2, 0, 0], "clear"), radius: 0.5 } as SceneObject], true],
    ["that touches another", [ball([0, 0, 0]), ball([2, 0, 0])], true],
    ["that is apart", [ball([0, 0, 0]), ball([2.1, 0, 0])], false],
    ["that is clear as all others are", [ball([0, 0, 0], "clear"), ball([1, 0, 0], "clear")], false],
    ["of many", Array.from({ length: 65 }, (_, i) => ball([3 * i, 0, 0])), true],
  ] as const)("%s", (_name, objects, expected) => {
    expect(seenFrom([0, 0, 9], objects).features.NESTED).toBe(expected);
  });
});
