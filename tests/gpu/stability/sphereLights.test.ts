import { readFileSync } from "node:fs";
import { afterAll, describe, expect, test } from "vitest";
import { compileScene } from "../../../src/compile/compileScene";
import { parseScene } from "../../../src/scene/parseScene";
import type { Vec3 } from "../../../src/scene/schema";
import { renderScene } from "../../support/device";
import { scale } from "../../support/oracle";
import { runProbe } from "../../support/probe";
import { small } from "../../support/stability";
import { recordStability, type StabilityRow } from "../../support/stabilityRows";

const CONE = readFileSync(new URL("../../support/textbook/cone.wgsl", import.meta.url), "utf8");
// Points per light: a grid of 256², whose midpoint rule is exact for E, linear in 1 − cos, but for rounding.
const GRID = 256;
const DIRECTION: Vec3 = [2 / 7, 6 / 7, 3 / 7];

const CASES = [
  { name: "Tiny: radius 10⁻⁶ at 1", radius: 1e-6, distance: 1 },
  { name: "Tiny and far: radius 10⁻³ at 10⁴", radius: 1e-3, distance: 1e4 },
  { name: "Radius 1 at 10⁵", radius: 1, distance: 1e5 },
  { name: "Radius 10³ at 10⁵", radius: 1e3, distance: 1e5 },
  { name: "Radius 1 at 2", radius: 1, distance: 2 },
  { name: "Close: 10⁻³ above the surface", radius: 1, distance: 1.001 },
  { name: "Touching: 10⁻⁶ above the surface", radius: 1, distance: 1 + 1e-6 },
];
// Some ten operations of an ULP each, twice that where they may round either way. Where the cone opens to a hemisphere,
// 1 − sin² is known to an ULP of 1 only and the cosine of the rim to its root, which E, of order sin², feels by its square.
const ULP = 2 ** -23;
const BOUND = 16 * ULP;
const rows: StabilityRow[] = [];

describe.each(CASES)("$name", ({ name, radius, distance }) => {
  test("light sampling gives E = π·L·(r/d)² head on, finite everywhere", async () => {
    const { sums, worstPlace, textbook } = await sampleGrid(radius, distance);
    const expected = Math.PI * (radius / distance) ** 2;
    const error = Math.abs(sums / expected - 1);
    rows.push({
      case: `A sphere light. ${name}`,
      asserted: `irradiance to ${small(BOUND)}; sampled points as close to the sphere, against their distance`,
      inputs: GRID ** 2,
      worst: small(error),
      textbook: `${small(Math.abs(textbook / expected - 1))}: 1 − cos by subtraction`,
    });
    expect(error).toBeLessThan(BOUND);
    expect(worstPlace).toBeLessThan(BOUND);
  });
});

test("a point inside a sphere light gets nothing from it and nothing bad", async () => {
  const { sums } = await sampleGrid(1, 0.5);
  expect(sums).toBe(0);
  const { image, stats } = await renderScene(
    {
      camera: { position: [0, 0.5, 0.5], target: [0, 0, 0] },
      materials: { m: { ior: 1 } },
      objects: [{ type: "plane", point: [0, 0, 0], normal: [0, 1, 0], material: "m" }],
      lights: [{ type: "sphere", position: [0, 0, 0], radius: 2, power: [100, 100, 100] }],
    },
    { size: [32, 32], samples: 16, seed: 1 },
  );
  expect(stats.badSamples).toBe(0);
  // It emits outwards only.
  expect(Math.max(...image.filter((_, i) => i % 4 < 3))).toBe(0);
  rows.push({
    case: "A sphere light around the shaded point and the camera",
    asserted: "dark, 0 bad samples",
    inputs: 32 * 32 * 16,
    worst: "dark, 0",
  });
});

test("a sphere light that touches a plane lights it, and no sample is bad, seed 1", async () => {
  const { stats, image } = await renderScene(
    {
      camera: { position: [0, 1, 3], target: [0, 0, 0] },
      materials: { m: { ior: 1 } },
      objects: [{ type: "plane", point: [0, 0, 0], normal: [0, 1, 0], material: "m" }],
      lights: [{ type: "sphere", position: [0, 0.5, 0], radius: 0.5, power: [100, 100, 100] }],
    },
    { size: [64, 64], samples: 64, seed: 1 },
  );
  expect(stats.badSamples).toBe(0);
  expect(image.every((value) => value >= 0 && Number.isFinite(value))).toBe(true);
});

afterAll(() => recordStability("sphere-lights", rows));

/** Sums of light samples at the origin, in doubles, of a light of radiance 1. */
async function sampleGrid(radius: number, distance: number) {
  const center = scale(DIRECTION, distance);
  const power = 4 * Math.PI ** 2 * radius ** 2;
  const scene = parseScene({
    camera: { position: [0, 0, 1], target: [0, 0, 0] },
    lights: [{ type: "sphere", position: center, radius, power: [power, power, power] }],
    materials: {},
    objects: [],
  });
  const { sceneModule, features, uniform } = compileScene(scene, {
    estimator: "path",
    sampler: "sobol",
    lightSamples: 1,
  });
  const count = GRID ** 2;
  const words = await runProbe({
    wgsl: `
      import package::cone::coneSolidAngle;
      import package::lights::light::sampleLight;
      import package::surface::Surface;
      fn probe(i: u32) {
        let u = (vec2f(f32(i % ${GRID}u), f32(i / ${GRID}u)) + 0.5) / ${GRID}.0;
        var atOrigin: Surface;
        let light = sampleLight(atOrigin, u, vec2f(0.0));
        let center = bitcast<vec4f>(inputs[0]);
        outputs[2u * i] = bitcast<vec4u>(vec4f(light.wi, light.distance));
        outputs[2u * i + 1u] = bitcast<vec4u>(vec4f(light.estimate.r, light.pdf, coneSolidAngle(vec3f(0.0), center.xyz, center.w), 0.0));
      }`,
    conditions: features,
    modules: { scene: sceneModule, cone: CONE },
    scene: uniform,
    count,
    inputs: new Float32Array([...center, radius]),
    outputRows: 2 * count,
  });
  const values = new Float32Array(words.buffer);
  let [bad, sums, textbook, worstPlace] = [0, 0, 0, 0];
  for (let i = 0; i < count; i++) {
    const [x, y, z, t, estimate, , solidAngle] = values.subarray(8 * i, 8 * i + 8) as unknown as number[];
    if (!Number.isFinite(estimate)) bad++;
    const cosine = x! * DIRECTION[0] + y! * DIRECTION[1] + z! * DIRECTION[2];
    sums += (estimate! * cosine) / count;
    textbook += (solidAngle! * cosine) / count;
    const place = Math.hypot(x! * t! - center[0], y! * t! - center[1], z! * t! - center[2]) - radius;
    if (estimate! > 0) worstPlace = Math.max(worstPlace, Math.abs(place) / distance);
  }
  expect(bad).toBe(0);
  return { sums, textbook, worstPlace };
}
