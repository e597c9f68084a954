import { afterAll, describe, expect, test } from "vitest";
import { cameraBasis } from "../../../src/renderer/cameraBasis";
import { parseScene } from "../../../src/scene/parseScene";
import type { Scene, SceneObject, Vec3 } from "../../../src/scene/schema";
import { renderScene } from "../../support/device";
import { add, cross, meetings, scale } from "../../support/oracle";
import { unit } from "../../support/solids";
import { small } from "../../support/stability";
import { recordStability, type StabilityRow } from "../../support/stabilityRows";

// Black things before a white sky, from far away: a pixel is 10⁻⁵ rad wide, 170 ULP of a unit vector, and shows the share of
// the sky in it.
const SIZE = 64;
const SAMPLES = 256;
const FIELD = 0.04; // degrees
// Of 64 edge pixels with a share each that 256 points tell to 1/256 or so: 10⁻³ of a pixel is left. What is asked for is twice that.
const BOUND = 2e-3;
const material = "black";
const rows: StabilityRow[] = [];

/** A planet's horizon: `up` is the way out of it at the middle of the picture, `toCamera` level with it. */
function planet(radius: number, distance: number, height: number, up: Vec3, toCamera: Vec3): Scene {
  return sceneOf(
    [{ type: "sphere", center: scale(up, -radius), radius, material }],
    add(scale(toCamera, distance), scale(up, height)),
    [up[0], up[1], up[2]],
    up,
  );
}

function sceneOf(
  objects: readonly SceneObject[],
  position: Vec3,
  target: Vec3 = [0, 1, 0],
  up: Vec3 = [0, 1, 0],
): Scene {
  return {
    camera: { position, target, up, verticalFov: FIELD },
    materials: { black: { baseColor: [0, 0, 0], ior: 1 } },
    objects,
    environment: { radiance: [1, 1, 1] },
    maxBounces: 0,
  };
}

const tilted = unit([0.48, 0.6, -0.64]);
const along = unit(cross(tilted, [0.3, -0.2, 0.9]));
const far: Vec3 = [3000, 2000, 14500];
// Beside the camera, and not in view: rays need not start there.
const beside: SceneObject = { type: "sphere", center: add(far, [0, 30, 0]), radius: 5, material };
const solids: Readonly<Record<string, SceneObject>> = {
  "a ball": { type: "sphere", center: [0.3, 1.2, -0.2], radius: 3.1, material },
  "a box": { type: "box", center: [0.3, 1.2, -0.2], size: [5.3, 4.4, 3.7], material },
  "a turned box": { type: "box", center: [0.3, 1.2, -0.2], size: [5.3, 4.4, 3.7], rotationY: 33, material },
  "a quad": { type: "quad", corner: [-2.4, -1.1, 0.4], edge1: [5, 0.3, -0.4], edge2: [-0.5, 4.8, 0.2], material },
  "a level quad": { type: "quad", corner: [-2.4, -1.1, 0.4], edge1: [5, 0, 0], edge2: [0, 4.8, 0], material },
  "a triangle": {
    type: "triangle",
    vertices: [
      [-2.4, -1.3, 0.4],
      [3.1, -0.7, -0.5],
      [0.4, 4.2, 0.1],
    ],
    material,
  },
};
const scenes: Readonly<Record<string, Scene>> = {
  "a planet of radius 2·10⁵, 15 km away": planet(2e5, 15000, 3, [0, 1, 0], [0, 0, 1]),
  "the same, tilted": planet(2e5, 15000, 3, tilted, along),
  "a planet of radius 6.4·10⁶, 15 km away": planet(6.4e6, 15000, 18, [0, 1, 0], [0, 0, 1]),
  "the same planet, tilted": planet(6.4e6, 15000, 18, tilted, along),
  "a planet of radius 3·10⁴, 15 km away, tilted": planet(3e4, 15000, 3, tilted, along),
  ...Object.fromEntries(Object.entries(solids).map(([name, solid]) => [name, sceneOf([solid], far)])),
  ...Object.fromEntries(
    Object.entries(solids).map(([name, solid]) => [`${name}, a ball beside the camera`, sceneOf([solid, beside], far)]),
  ),
};

describe("through a lens of 0.04° the silhouette lies where doubles put it, to 0.002 of a pixel:", () => {
  test.each(Object.entries(scenes))("%s, seed 1", async (name, scene) => {
    const { image, stats } = await renderScene(scene, { size: [SIZE, SIZE], samples: SAMPLES, seed: 1 });
    const expected = skyShares(scene);
    const errors = HALVES.map((isIn) => {
      let [error, edge] = [0, 0];
      for (let i = 0; i < SIZE * SIZE; i++) {
        if (!isIn(i % SIZE, Math.floor(i / SIZE))) continue;
        error += image[4 * i]! - expected[i]!;
        if (expected[i]! > 0 && expected[i]! < 1) edge++;
      }
      return error / Math.max(edge, 1);
    });
    const worst = Math.max(...errors.map(Math.abs));
    rows.push({
      case: `Through a lens of 0.04°: ${name}`,
      asserted: `silhouette within ${BOUND} of a pixel, in each half of the picture`,
      inputs: SIZE * SIZE * SAMPLES,
      worst: small(worst),
    });
    expect(stats.badSamples).toBe(0);
    expect(worst).toBeLessThan(BOUND);
  });
});

afterAll(() => recordStability("telephoto", rows));

// Left, right, upper and lower: what moves an edge in one is not made up for in the other.
const HALVES = [
  (x: number) => x < SIZE / 2,
  (x: number) => x >= SIZE / 2,
  (_: number, y: number) => y < SIZE / 2,
  (_: number, y: number) => y >= SIZE / 2,
];

const POINTS = 987; // a Fibonacci number

/** Of each pixel, in doubles: to 10⁻³ where an edge runs through it. */
function skyShares(scene: Scene): Float64Array {
  const { camera, objects } = parseScene(scene);
  const { origin, forward, right, up } = cameraBasis(camera, [0, 0, 0], 1);
  const isSky = (x: number, y: number) => {
    const [u, v] = [(2 * x) / SIZE - 1, 1 - (2 * y) / SIZE];
    const d = unit(add(forward, add(scale(right, u), scale(up, v))));
    return meetings(objects, origin, d).length === 0;
  };
  const shares = new Float64Array(SIZE * SIZE);
  // A lattice of the golden ratio: as even along every edge, level ones too.
  const points = Array.from({ length: POINTS }, (_, k) => [(k + 0.5) / POINTS, (k * 0.6180339887498949) % 1] as const);
  const coarse = [0, 0.25, 0.5, 0.75, 1];
  for (let i = 0; i < shares.length; i++) {
    const [x, y] = [i % SIZE, Math.floor(i / SIZE)];
    const probes = coarse.flatMap((u) => coarse.map((v) => isSky(x + u, y + v)));
    if (probes.every((sky) => sky === probes[0])) shares[i] = probes[0] ? 1 : 0;
    else shares[i] = points.filter(([u, v]) => isSky(x + u, y + v)).length / POINTS;
  }
  return shares;
}
