import { afterAll, describe, expect, test } from "vitest";
import { cameraBasis } from "../../../src/renderer/cameraBasis";
import { parseScene } from "../../../src/scene/parseScene";
import type { Scene, SceneObject, Vec3 } from "../../../src/scene/schema";
import { renderScene } from "../../support/device";
import { add, dot, meetings, scale, subtract } from "../../support/oracle";
import { createRandom } from "../../support/random";
import { unit } from "../../support/solids";
import { small } from "../../support/stability";
import { recordStability, type StabilityRow } from "../../support/stabilityRows";

// Three balls on a floor under a white sky: all light on their lower halves comes off the floor.
const ALBEDO = 0.7;
const SIZE = 64;
const BOUNCES = 6;
const balls: SceneObject[] = [
  [-1.3, 0.6, 0],
  [0, 0.6, -0.4],
  [1.3, 0.6, 0.2],
].map((center) => ({ type: "sphere", center: center as unknown as Vec3, radius: 0.6, material: "m" }));

function sceneWith(floor: SceneObject): Scene {
  return {
    camera: { position: [0, 1.6, 5], target: [0, 0.6, 0], verticalFov: 40 },
    materials: { m: { baseColor: [ALBEDO, ALBEDO, ALBEDO], ior: 1 } },
    objects: [floor, ...balls],
    environment: { radiance: [1, 1, 1] },
    maxBounces: BOUNCES,
  };
}

const plane: SceneObject = { type: "plane", point: [0, 0, 0], normal: [0, 1, 0], material: "m" };
const sphereFloor = (radius: number): SceneObject => ({
  type: "sphere",
  center: [0, -radius, 0],
  radius,
  material: "m",
});
const rows: StabilityRow[] = [];

describe.each([1e5, 6.4e6])("a floor that is a sphere of radius %d", (radius) => {
  test("shows what a plane shows, seed 1", async () => {
    const options = { size: [SIZE, SIZE] as const, samples: 64, seed: 1 };
    const { image, stats } = await renderScene(sceneWith(sphereFloor(radius)), options);
    const { image: flat } = await renderScene(sceneWith(plane), options);
    // Not at the horizon: from 1.6 above it a sphere's lies √(2·1.6/r) lower, half a row of pixels at r = 10⁵.
    const horizon = SIZE / 2 - (SIZE / 2) * (Math.tan(Math.atan2(1, 5)) / Math.tan((20 * Math.PI) / 180));
    const isLevel = (row: number) => Math.abs(row + 0.5 - horizon) < 2;
    let [sum, expected] = [0, 0];
    for (let i = 0; i < image.length; i += 4) {
      if (isLevel(Math.floor(i / 4 / SIZE))) continue;
      sum += image[i]!;
      expected += flat[i]!;
    }
    const bias = sum / expected - 1;
    rows.push({
      case: `Image: balls on a sphere of radius ${radius === 1e5 ? "10⁵" : "6.4·10⁶"} against balls on a plane`,
      asserted: "mean off by at most 10⁻³, horizon left out",
      inputs: SIZE * SIZE * 64,
      worst: small(bias),
      ...(radius === 1e5 && { textbook: "Mitsuba 3, single precision: −6.8·10⁻² (light off the floor is lost)" }),
    });
    expect(Math.abs(bias)).toBeLessThan(1e-3);
    expect(stats.badSamples).toBe(0);
  });
});

test("through a telephoto lens, from 10⁴ away, a planet of radius 6.4·10⁶ shows what a plane shows, seed 1", async () => {
  // The field of view spans 4 around the balls, all of it floor or balls.
  const position: Vec3 = [0, 3000, 9539];
  const camera = { position, target: [0, 0.6, 0] as const, verticalFov: (2 * Math.atan(2e-4) * 180) / Math.PI };
  const options = { size: [SIZE, SIZE] as const, samples: 64, seed: 1 };
  const { image, stats } = await renderScene({ ...sceneWith(sphereFloor(6.4e6)), camera }, options);
  const { image: flat } = await renderScene({ ...sceneWith(plane), camera }, options);
  let [sum, expected, differing] = [0, 0, 0];
  for (let i = 0; i < image.length; i += 4) {
    sum += image[i]!;
    expected += flat[i]!;
    // The same paths: a value differs by more where one of 64 takes another turn.
    if (Math.abs(image[i]! - flat[i]!) > 1e-3) differing++;
  }
  const bias = sum / expected - 1;
  rows.push({
    case: "Image: balls on a planet of radius 6.4·10⁶ against balls on a plane, through a lens of 0.02° from 10⁴ away",
    asserted: "mean off by at most 10⁻³, 95 % of the pixels alike",
    inputs: SIZE * SIZE * 64,
    worst: `${small(bias)}; ${differing} of ${SIZE * SIZE} pixels differ`,
  });
  expect(Math.abs(bias)).toBeLessThan(1e-3);
  expect(differing).toBeLessThan(0.05 * SIZE * SIZE);
  expect(stats.badSamples).toBe(0);
});

test("its image's mean is that of a path tracer in doubles, seeds 1 and 6", async () => {
  const scene = sceneWith(sphereFloor(1e5));
  const { image } = await renderScene(scene, { size: [SIZE, SIZE], samples: 256, seed: 1 });
  let ours = 0;
  for (let i = 0; i < image.length; i += 4) ours += image[i]! / (SIZE * SIZE);
  const { mean, standardError } = meanInDoubles(scene, 150_000, 6);
  rows.push({
    case: "Image: the mean with a floor of radius 10⁵ against a path tracer in doubles",
    asserted: `within 4 σ, σ = ${small(standardError / mean)}`,
    inputs: SIZE * SIZE * 256,
    worst: small(ours / mean - 1),
  });
  expect(Math.abs(ours - mean)).toBeLessThan(4 * standardError);
});

afterAll(() => recordStability("floor", rows));

/** Mean of the image in doubles. Every surface is Lambert of one albedo and the sky is 1: a path is worth ALBEDO^scatters. */
function meanInDoubles(scene: Scene, paths: number, seed: number) {
  const { objects, camera } = parseScene(scene);
  const { origin, forward, right, up } = cameraBasis(camera, [0, 0, 0], 1);
  const random = createRandom(seed);
  let [sum, squares] = [0, 0];
  for (let i = 0; i < paths; i++) {
    let o: Vec3 = origin;
    let d = unit(add(forward, add(scale(right, 2 * random() - 1), scale(up, 2 * random() - 1))));
    let value = 0;
    for (let scatters = 0; scatters <= BOUNCES; scatters++) {
      const hit = meetings(objects, o, d)[0];
      if (!hit) {
        value = ALBEDO ** scatters;
        break;
      }
      const object = objects[hit.id]!;
      if (object.type !== "sphere") throw new RangeError("spheres only");
      const p = add(o, scale(d, hit.t));
      const n = unit(subtract(p, object.center));
      // Off the surface by far more than rounding in doubles, 10⁵·2⁻⁵³, and far less than anything in the picture.
      o = add(p, scale(n, 1e-8));
      d = cosineDirection(n, random);
    }
    sum += value;
    squares += value ** 2;
  }
  const mean = sum / paths;
  return { mean, standardError: Math.sqrt((squares / paths - mean ** 2) / paths) };
}

/** A uniform point on the unit sphere around the tip of n, seen from its foot. */
function cosineDirection(n: Vec3, random: () => number): Vec3 {
  const z = 2 * random() - 1;
  const phi = 2 * Math.PI * random();
  const r = Math.sqrt(1 - z * z);
  const d = add(n, [r * Math.cos(phi), r * Math.sin(phi), z]);
  return dot(d, d) > 1e-20 ? unit(d) : n;
}
