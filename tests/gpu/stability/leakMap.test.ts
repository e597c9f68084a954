import { writeFileSync } from "node:fs";
import { encode } from "fast-png";
import { expect, test } from "vitest";
import type { Scene, SceneObject } from "../../../src/scene/schema";
import { sceneOf } from "../../support/compiled";
import { add } from "../../support/oracle";
import { createRandom } from "../../support/random";
import { unit } from "../../support/solids";
import { type Method, NONE, Rays, traceRays } from "../../support/traceRays";

// The picture of the report: how often light off a floor is lost, per pixel, when the floor is a sphere of radius 10⁵. White
// where no ray that leaves the floor meets the floor again or starts below it, black where all do.
const SIZE = 192;
const RAYS_PER_PIXEL = 8;
const PICTURE = new URL("../../reports/floor-self-hits.png", import.meta.url);

const floor: SceneObject = { type: "sphere", center: [0, -1e5, 0], radius: 1e5, material: "lambert" };
const scene: Scene = { ...sceneOf([floor]), camera: { position: [0, 1.6, 5], target: [0, 0, 0] } };

test("no ray that leaves a floor of radius 10⁵ meets it again, in any pixel, seed 12", async () => {
  const ours = await lostShares("ours");
  const textbook = await lostShares("textbook");
  expect(Math.max(...ours)).toBe(0);
  expect(Math.max(...textbook)).toBeGreaterThan(0);
  if (!process.env.RT_VIEWER_REPORT) return;
  // Textbook left, ours right, a grey line between them.
  const width = 2 * SIZE + 4;
  const data = new Uint8Array(width * SIZE).fill(128);
  for (const [i, shares] of [textbook, ours].entries()) {
    for (const [at, share] of shares.entries()) {
      data[Math.floor(at / SIZE) * width + (at % SIZE) + i * (SIZE + 4)] = Math.round(255 * (1 - share));
    }
  }
  writeFileSync(PICTURE, encode({ width, height: SIZE, data, channels: 1 }));
});

/** Per pixel, the share of the rays off the floor that meet it again. */
async function lostShares(method: Method): Promise<Float64Array> {
  const random = createRandom(12);
  const rays = new Rays(SIZE * SIZE * RAYS_PER_PIXEL);
  for (let i = 0; i < rays.count; i++) {
    const pixel = Math.floor(i / RAYS_PER_PIXEL);
    const [x, y] = [((pixel % SIZE) + random()) / SIZE - 0.5, 0.5 - (Math.floor(pixel / SIZE) + random()) / SIZE];
    const z = Math.sqrt(random());
    const phi = 2 * Math.PI * random();
    const r = Math.sqrt(1 - z * z);
    rays.set(i, [0, 1.6, 5], unit(add([0, -0.35, -1], [x, 0.7 * y, 0])), [r * Math.cos(phi), r * Math.sin(phi), z]);
  }
  const { id, nextId } = await traceRays(scene, rays, method);
  const lost = new Float64Array(SIZE * SIZE);
  for (let i = 0; i < rays.count; i++) {
    if (id[i] !== NONE && nextId[i] !== NONE) lost[Math.floor(i / RAYS_PER_PIXEL)]! += 1 / RAYS_PER_PIXEL;
  }
  return lost;
}
