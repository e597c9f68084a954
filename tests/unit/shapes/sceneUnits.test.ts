import { expect, test } from "vitest";
import { parseScene } from "../../../src/scene/parseScene";
import type { Vec3 } from "../../../src/scene/schema";
import { inSceneUnits } from "../../../src/shapes/sceneUnits";

const sceneOfSize = (size: number) =>
  parseScene({
    camera: { position: [0, 0, 3 * size], target: [0, 0, 0] },
    materials: { m: {} },
    objects: [
      { type: "sphere", center: [size, 0, 0], radius: size, material: "m" },
      { type: "mesh", positions: [0, 0, 0, size, 0, 0, 0, size, 0], indices: [0, 1, 2], material: "m" },
    ],
    lights: [{ type: "point", position: [0, size, 0], power: [1, 2, 3] }],
  });

test.each([1e-4, 1, 2e4])("a scene of %s m is measured in metres, and stays the same object", (size) => {
  const scene = sceneOfSize(size);
  const { unit, scene: measured } = inSceneUnits(scene);
  expect(unit).toBe(1);
  expect(measured).toBe(scene);
});

test.each([1e-17, 1e-11, 1e9, 1e17])(
  "a scene of %s m is measured in a power of two near the camera's distance",
  (size) => {
    const { unit, scene } = inSceneUnits(sceneOfSize(size));
    expect(Number.isInteger(Math.log2(unit))).toBe(true);
    const distance = Math.hypot(...scene.camera.position);
    expect(distance).toBeGreaterThan(0.7);
    expect(distance).toBeLessThan(1.5);
    // Irradiance, power / distance², and every ratio of lengths stay, to the digit.
    const [{ position, power }] = scene.lights as unknown as [{ position: Vec3; power: Vec3 }];
    expect(power[2] / position[1] ** 2).toBe(3 / size ** 2);
    const [ball, mesh] = scene.objects as unknown as [{ radius: number }, { positions: Float64Array }];
    expect(ball.radius / distance).toBeCloseTo(1 / 3, 14);
    expect(mesh.positions[3]).toBe(ball.radius);
  },
);

test("what lies farther than rays go is drawn nearer, and what is too small to be seen keeps a size", () => {
  const far = { type: "plane", point: [0, 1e18, 0], normal: [0, -1, 0], material: "m" } as const;
  const tiny = { type: "sphere", center: [0, 0, 0], radius: 1e-18, material: "m" } as const;
  const sized = (size: number, object: typeof far | typeof tiny) =>
    inSceneUnits(
      parseScene({ camera: { position: [0, 0, size], target: [0, 0, 0] }, materials: { m: {} }, objects: [object] }),
    ).scene.objects[0];
  expect(sized(1e-9, far)).toMatchObject({ point: [0, 1e18, 0] });
  expect(sized(1e9, tiny)).toMatchObject({ radius: 1e-18 });
});
