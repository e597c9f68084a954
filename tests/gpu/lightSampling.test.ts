import { describe, expect, test } from "vitest";
import { compileScene } from "../../src/compile/compileScene";
import { parseScene } from "../../src/scene/parseScene";
import type { Light, SceneObject, Vec3 } from "../../src/scene/schema";
import { prepareGeometry } from "../../src/tree/geometry";
import { icosphere, meshObject, placed } from "../support/meshes";
import { runProbe } from "../support/probe";
import { createRandom, randomDirection } from "../support/random";

const POINTS = 200;
const SAMPLES = 256;
const NONE = 0xffffffff;

/** One sample of the lights, and what a ray in its direction finds. */
type Sampled = {
  readonly distance: number;
  readonly pdf: number;
  /** Radiance over density, red. */
  readonly estimate: number;
  readonly id: number;
  readonly hitId: number;
  readonly hitT: number;
  /** Density that MIS ascribes to light sampling where the ray hits, the choice of light included. */
  readonly hitPdf: number;
  readonly Le: number;
};

type Emitting = { readonly objects?: SceneObject[]; readonly lights?: Light[] };

const glow = { material: "glow" } as const;
const SPHERE: Light = { type: "sphere", position: [0, 0, 0], radius: 1, power: [40, 40, 40] };
const QUAD: SceneObject = { type: "quad", corner: [-1, -1, 0], edge1: [2, 0, 0], edge2: [0.5, 2, 0], ...glow };
const TRIANGLE: SceneObject = {
  type: "triangle",
  vertices: [
    [-1, -1, 0],
    [1, -1, 0],
    [0.3, 1, 0.5],
  ],
  ...glow,
};
const BOX: SceneObject = { type: "box", center: [0, 0, 0], size: [1, 2, 0.5], rotationY: 25, ...glow };
const BALL: SceneObject = { type: "sphere", center: [0, 0, 0], radius: 0.7, ...glow };

// Small and convex: at the least distance a third of it is seen, and none of it hides another part.
const MESH = meshObject(placed(icosphere(1), 0.35, [0, 0, 0]), "glow");

const SCENES: Readonly<Record<string, Emitting>> = {
  "a sphere light": { lights: [SPHERE] },
  "a quad": { objects: [QUAD] },
  "a triangle": { objects: [TRIANGLE] },
  "a box": { objects: [BOX] },
  "a glowing sphere": { objects: [BALL] },
  "a mesh": { objects: [MESH] },
  "a mesh, a quad and a sphere light": {
    objects: [MESH, { ...QUAD, corner: [2, 0, 0] } as SceneObject],
    lights: [{ ...SPHERE, position: [0, -3, 0] } as Light],
  },
  "a box, a quad, a sphere and a sphere light": {
    objects: [
      { ...BOX, center: [-3, 0, 0] } as SceneObject,
      { ...QUAD, corner: [2, 0, 0] } as SceneObject,
      { ...BALL, center: [0, 3, 0] } as SceneObject,
    ],
    lights: [{ ...SPHERE, position: [0, -3, 0] } as Light],
  },
  "a triangle and two sphere lights, for a glossy surface": {
    objects: [TRIANGLE, { type: "sphere", center: [0, 1e4, 0], radius: 1, material: "glossy" }],
    lights: [{ ...SPHERE, position: [0, -3, 0] } as Light, { ...SPHERE, position: [0, 4, 0], radius: 0.2 } as Light],
  },
};

// Distances from the light's centre, in all directions: from just off the largest light's surface to far away.
const DISTANCES = [1.3, 2, 10, 1000];

describe.each(Object.keys(SCENES))("light sampling of %s, seed 11", (name) => {
  test.each(DISTANCES)("at a distance of %d agrees with the rays that hit it", async (distance) => {
    const random = createRandom(11);
    const points = Array.from({ length: POINTS }, () => {
      const [x, y, z] = randomDirection(random);
      return [distance * x, distance * y, distance * z] as Vec3;
    });
    const sampled = (await sampleLights(SCENES[name]!, points)).flat();
    const reaching = sampled.filter(({ estimate }) => estimate > 0);
    const hits = reaching.filter(({ id, hitId }) => id === hitId);
    // A flat light shines to one side only, and lights can hide one another; a sphere's tangent can miss it, and a ray at the
    // edge of a mesh's triangle pass to the next.
    expect(hits.length).toBeGreaterThan(0.3 * sampled.length);
    const share = name.includes(",") ? 0.8 : name.includes("mesh") ? 0.99 : 0.999;
    expect(hits.length).toBeGreaterThan(share * reaching.length);

    // The densities are functions of the direction whose slope is largest at a light's rim, as 1/cos there. f32 knows a
    // direction to 2⁻²³ and the angle under which a light of size 1 is hit to d·2⁻²³: with d = 1000 that is 1e-4.
    const tolerance = 1e-4 + distance * 1e-5;
    const off = hits.filter((hit) => Math.abs(hit.hitPdf / hit.pdf - 1) > tolerance);
    // The rim itself, a few samples in a thousand, may be further off; there the light is black anyway.
    expect(off.length / hits.length).toBeLessThan(5e-3);
    // A sample's distance is that of the ray's hit, and its value is the hit's radiance over the density.
    const elsewhere = hits.filter((hit) => Math.abs(hit.hitT / hit.distance - 1) > 10 * tolerance);
    expect(elsewhere.length / hits.length).toBeLessThan(5e-3);
    expect(hits.filter(({ estimate, pdf, Le }) => Le > 0 && !(Math.abs(estimate * pdf - Le) < 5e-4))).toEqual([]);
    expect(reaching.filter(({ pdf }) => !(Number.isFinite(pdf) && pdf > 0))).toEqual([]);
  });
});

test.each([
  { distance: 1.0001, tolerance: 1e-2 },
  { distance: 1.01, tolerance: 1e-4 },
  { distance: 2, tolerance: 1e-5 },
  { distance: 1e3, tolerance: 1e-5 },
  { distance: 1e6, tolerance: 1e-5 },
])("a sphere light fills its cone's solid angle, $distance radii away, seed 12", async ({ distance, tolerance }) => {
  const random = createRandom(12);
  const points = Array.from({ length: POINTS }, () => {
    const d = randomDirection(random);
    return [Math.fround(distance * d[0]), Math.fround(distance * d[1]), Math.fround(distance * d[2])] as Vec3;
  });
  const sampled = await sampleLights({ lights: [SPHERE] }, points);
  const errors = sampled.flatMap((samples, i) => {
    const sin2 = 1 / Math.hypot(...points[i]!) ** 2;
    const solidAngle = (2 * Math.PI * sin2) / (1 + Math.sqrt(Math.max(1 - sin2, 0)));
    return samples.map(({ pdf }) => Math.abs(pdf * solidAngle - 1));
  });
  // sin² is known to 2⁻²² and 1 − cos by 1/cos times that, which at 1.0001 radii is 70 times as much: 2e-5, and twice
  // near the tangent plane for the rounding of the distance.
  expect(errors.filter((error) => !(error < tolerance))).toEqual([]);
});

test("a point inside or on a sphere light gets no light sample and nothing that is not finite, seed 13", async () => {
  const random = createRandom(13);
  const points = Array.from({ length: POINTS }, (_, i) => {
    const d = randomDirection(random);
    const r = i === 0 ? 0 : i % 2 === 0 ? 1 : random();
    return [r * d[0], r * d[1], r * d[2]] as Vec3;
  });
  const sampled = (await sampleLights({ lights: [SPHERE] }, points)).flat();
  const isBad = ({ pdf, estimate, distance }: Sampled) => ![pdf, estimate, distance].every(Number.isFinite);
  expect(sampled.filter(isBad)).toEqual([]);
});

/** `SAMPLES` light samples at every point, for a surface there that faces the origin and is seen at 45°. */
async function sampleLights({ objects = [], lights = [] }: Emitting, points: readonly Vec3[]): Promise<Sampled[][]> {
  const scene = parseScene({
    camera: { position: [0, 0, 9] },
    materials: { glow: { baseColor: [0, 0, 0], ior: 1, emission: [2, 2, 2] }, glossy: { roughness: 0.4 } },
    objects,
    lights,
  });
  const settings = { estimator: "path", sampler: "sobol", lightSamples: 1 } as const;
  const geometry = await prepareGeometry(scene);
  const { sceneModule, features, uniform } = compileScene(scene, settings, undefined, geometry);
  const count = points.length * SAMPLES;
  const words = await runProbe({
    wgsl: `
      import package::constants::NONE;
      import package::basis::frameAround;
      import package::lights::light::{lightShareOf, sampleLight, lightPick};
      import package::ray::makeRay;
      import package::sampler::{makeSampler, point};
      import package::scene::{Bsdf, closestHit, seenFrom};
      import package::surface::{Surface, surfaceAt};
      import package::surfacePoint::primitiveOf;
      fn probe(i: u32) {
        let p = bitcast<vec4f>(inputs[i / ${SAMPLES}u]).xyz;
        let samples = makeSampler(vec2u(i / ${SAMPLES}u, 0u), 0u, 11u, i % ${SAMPLES}u);
        var seen: Surface;
        seen.p = p;
        seen.frame = frameAround(normalize(select(-p, vec3f(0.0, 0.0, 1.0), all(p == vec3f(0.0)))));
        seen.wo = vec3f(sqrt(0.5), 0.0, sqrt(0.5));
        var grey: Bsdf;
        @if(DIFFUSE) grey.diffuse = vec3f(0.5);
        @if(SPECULAR) {
          grey.F0 = vec3f(0.04);
          grey.f0 = 0.04;
          grey.f90 = 1.0;
          grey.alpha = 0.16;
        }
        seen.bsdf = seenFrom(grey, seen.wo);
        let light = sampleLight(seen, point(samples, 1u), lightPick(samples, 0u));
        let row = bitcast<vec4u>(vec4f(light.distance, light.pdf, light.estimate.r, 0.0));
        outputs[2u * i] = vec4u(row.xyz, light.id);
        let ray = makeRay(p, light.wi, NONE);
        let hit = closestHit(ray);
        outputs[2u * i + 1u] = vec4u(hit.id, bitcast<u32>(hit.t), 0u, 0u);
        if (hit.id == NONE) { return; }
        let surface = surfaceAt(ray, hit);
        var pdf = surface.lightPdf;
        @if(MANY_LIGHTS) pdf *= lightShareOf(primitiveOf(hit.id), seen) / light.totalWeight;
        outputs[2u * i + 1u].z = bitcast<u32>(pdf);
        outputs[2u * i + 1u].w = bitcast<u32>(surface.Le.r);
      }`,
    conditions: features,
    modules: { scene: sceneModule },
    scene: uniform,
    geometry,
    count,
    inputs: new Float32Array(points.flatMap((p) => [...p, 0])),
    outputRows: 2 * count,
  });
  const floats = new Float32Array(words.buffer);
  return points.map((_, p) =>
    Array.from({ length: SAMPLES }, (_, s) => {
      const at = 8 * (p * SAMPLES + s);
      return {
        distance: floats[at]!,
        pdf: floats[at + 1]!,
        estimate: floats[at + 2]!,
        id: words[at + 3]!,
        hitId: words[at + 4] ?? NONE,
        hitT: floats[at + 5]!,
        hitPdf: floats[at + 6]!,
        Le: floats[at + 7]!,
      };
    }),
  );
}
