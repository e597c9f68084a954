// Where light ends on a smooth surface of few triangles.

import { describe, expect, test } from "vitest";
import type { Scene, SceneObject } from "../../../src/scene/schema";
import { renderScene } from "../../support/device";

const SIZE = 64;
const BLOCK = 4;

/** A ball of radius 1 with normals, of this many rows and columns of quads. */
function coarseBall(columns: number, rows: number): SceneObject {
  const positions: number[] = [];
  const indices: number[] = [];
  for (let row = 0; row <= rows; row++) {
    for (let column = 0; column <= columns; column++) {
      const [theta, phi] = [(Math.PI * row) / rows, (2 * Math.PI * column) / columns];
      positions.push(Math.sin(theta) * Math.cos(phi), Math.cos(theta), Math.sin(theta) * Math.sin(phi));
      if (row === rows || column === columns) continue;
      const a = row * (columns + 1) + column;
      const b = a + columns + 1;
      indices.push(a, a + 1, b, b, a + 1, b + 1);
    }
  }
  return { type: "mesh", positions, indices, normals: positions, material: "m" };
}

function lit(ball: SceneObject, more: Partial<Scene> = {}): Scene {
  return {
    camera: { position: [0, 0, 8], target: [0, 0, 0], verticalFov: 15 },
    materials: { m: { ior: 1 } },
    objects: [ball],
    lights: [{ type: "point", position: [900, 300, 0], power: [1e7, 1e7, 1e7] }],
    maxBounces: 1,
    ...more,
  };
}

/** The means of the picture's blocks, as shares of the brightest. */
async function blocksOf(scene: Scene): Promise<number[]> {
  const { image, stats } = await renderScene(scene, { size: [SIZE, SIZE], samples: 64 });
  expect(stats.badSamples).toBe(0);
  const count = SIZE / BLOCK;
  const means = Array.from({ length: count ** 2 }, (_, block) => {
    const [x0, y0] = [BLOCK * (block % count), BLOCK * Math.floor(block / count)];
    let sum = 0;
    for (let i = 0; i < BLOCK ** 2; i++) sum += image[4 * ((y0 + Math.floor(i / BLOCK)) * SIZE + x0 + (i % BLOCK))]!;
    return sum / BLOCK ** 2;
  });
  const brightest = Math.max(...means);
  return means.map((mean) => mean / brightest);
}

describe("a smooth ball of few triangles", () => {
  test.each([
    [12, 8],
    [16, 16],
    [48, 24],
  ])("of %d × %d quads is lit as a ball is, where that is inside of both, seed 1", async (columns, rows) => {
    const ball = await blocksOf(lit({ type: "sphere", center: [0, 0, 0], radius: 1, material: "m" }));
    const coarse = await blocksOf(lit(coarseBall(columns, rows)));
    const count = SIZE / BLOCK;
    let worst = 0;
    for (const [block, expected] of ball.entries()) {
      const [x, y] = [(block % count) - (count - 1) / 2, Math.floor(block / count) - (count - 1) / 2];
      if (Math.hypot(x, y) > 0.3 * count) continue; // near the outline they differ in shape
      worst = Math.max(worst, Math.abs(coarse[block]! - expected));
    }
    expect(worst).toBeLessThan(0.012); // 0.13, 0.09 and 0.016 where triangles end the light
  });

  test("keeps its own shadow and that of others, seed 1", async () => {
    const scene = lit(coarseBall(12, 8));
    const behind = await blocksOf({ ...scene, camera: { ...scene.camera, position: [-7.59, -2.53, 0] } });
    expect(behind.every((share) => !(share > 0))).toBe(true); // nothing is lit there, and 0/0 is no light
    const screen: SceneObject = {
      type: "quad",
      corner: [30, 0, -30],
      edge1: [0, 60, 0],
      edge2: [0, 0, 60],
      material: "m",
    };
    const shaded = await blocksOf({
      ...scene,
      objects: [...scene.objects, screen],
      camera: { ...scene.camera, position: [0, 0, 8] },
    });
    expect(shaded.every((share) => !(share > 0))).toBe(true);
  });
});
