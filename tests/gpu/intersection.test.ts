import { beforeAll, describe, expect, test } from "vitest";
import { compileScene } from "../../src/compile/compileScene";
import { parseScene } from "../../src/scene/parseScene";
import type { ResolvedScene, SceneObject, Vec3 } from "../../src/scene/schema";
import { prepareGeometry } from "../../src/tree/geometry";
import { add, type Meeting, meetings, type Source, scale } from "../support/oracle";
import { runProbe } from "../support/probe";
import { createRandom, randomDirection } from "../support/random";

const RAYS = 20_000;
// The place of a hit is made of sums and products of coordinates, some dozen operations of 2⁻²³ each (design §5), as
// large as the way to it is long, and an error across a surface is 1/cos of it along the ray.
const PLACE_ERROR = 24 * 2 ** -23;

/** A ray's own hit on the device, the ray that leaves it, and what that one meets. */
type Traced = {
  readonly id: number;
  readonly t: number;
  readonly p: Vec3;
  readonly inside: boolean;
  readonly d: Vec3;
  readonly nextId: number;
  readonly nextT: number;
  readonly blocked: boolean;
};

type Ray = { readonly o: Vec3; readonly d: Vec3; readonly wi: Vec3; readonly reach: number };

const NONE = 0xffffffff;
const INSIDE = 0x80000000;

// Twenty primitives are unrolled into the program; of sixty, all but the planes and four large ones are in its tree. Of sixty more
// planes and twenty huge spheres, most are in a loop.
const CASES = [
  ...[1, 2, 3, 4].map((seed) => ({ seed, count: 20, copies: 1, walls: 0 })),
  ...[5, 6].map((seed) => ({ seed, count: 60, copies: 3, walls: 0 })),
  { seed: 7, count: 100, copies: 1, walls: 80 },
  { seed: 8, count: 140, copies: 3, walls: 80 },
];

describe.each(CASES)("$count primitives of all kinds and 20,000 rays, seed $seed", ({ seed, copies, walls }) => {
  const scene = randomScene(seed, copies, walls);
  const rays = randomRays(seed);
  /** Of each ray, in doubles. */
  const met = rays.map(({ o, d }) => meetings(scene.objects, o, d));
  let traced: readonly Traced[];
  let hits: readonly { readonly hit: Traced; readonly reach: number; readonly next: readonly Meeting[] }[];

  beforeAll(async () => {
    traced = await trace(scene, rays, copies > 1 ? 54 : 0);
    hits = traced.flatMap((hit, i) => {
      if (hit.id === NONE) return [];
      const source: Source = { id: hit.id, inside: hit.inside };
      return [{ hit, reach: rays[i]!.reach, next: meetings(scene.objects, hit.p, hit.d, source) }];
    });
  });

  test("the closest hit is that of a brute-force search in doubles", () => {
    const all = rays.map((ray, i) => ({ ray, hit: traced[i]!, found: met[i]! }));
    // Rays so close to an edge or to two surfaces at once that f32 can't tell are sorted out: none is left.
    expect(all.filter(({ ray, hit, found }) => !isRight(hit, found, ray.o))).toEqual([]);
    expect(hits.length).toBeGreaterThan(0.5 * RAYS);
  });

  test("less than one ray in ten thousand needs that excuse", () => {
    const different = traced.filter(({ id }, i) => (met[i]![0]?.id ?? NONE) !== id);
    expect(different.length / RAYS).toBeLessThanOrEqual(1e-4);
  });

  test("a ray that leaves a hit meets what it would in doubles, itself only from inside", () => {
    expect(hits.filter(({ hit, next }) => !isRight({ id: hit.nextId, t: hit.nextT }, next, hit.p))).toEqual([]);
    const again = hits.filter(({ hit }) => hit.nextId === hit.id);
    expect(again.filter(({ hit }) => !hit.inside)).toEqual([]);
    expect(again.length).toBeGreaterThan(100);
  });

  test("a shadow ray is blocked if and only if something lies before its end", () => {
    const certain = hits.filter(({ hit, reach, next }) =>
      next.every((meeting) => {
        return !isDoubtful(meeting, hit.p) && Math.abs(meeting.t - reach) >= allowance(meeting, hit.p);
      }),
    );
    expect(certain.filter(({ hit, reach, next }) => hit.blocked !== next.some(({ t }) => t < reach))).toEqual([]);
    const blocked = certain.filter(({ hit }) => hit.blocked).length;
    expect(Math.min(blocked, certain.length - blocked)).toBeGreaterThan(0.05 * RAYS);
  });
});

/** Whether the device's hit is the first meeting, or one that f32 can't tell from it. */
function isRight(hit: { readonly id: number; readonly t: number }, expected: readonly Meeting[], o: Vec3): boolean {
  for (const meeting of expected) {
    const tolerance = allowance(meeting, o);
    if (meeting.id === hit.id && Math.abs(meeting.t - hit.t) <= tolerance) return true;
    // A meeting that the device left out must be at an edge, at the origin, or level with the one it found.
    const level = hit.id !== NONE && Math.abs(meeting.t - hit.t) <= tolerance;
    if (!isDoubtful(meeting, o) && !level) return false;
  }
  return hit.id === NONE;
}

/** Whether f32 may see a meeting on the other side of the primitive's edge, or behind the ray's origin. */
function isDoubtful(meeting: Meeting, o: Vec3): boolean {
  const tolerance = allowance(meeting, o);
  // Margins are in units of the primitive's size, at least 1/4.
  return 0.25 * meeting.margin < tolerance || meeting.t < tolerance;
}

function allowance({ t, cosine }: Meeting, o: Vec3): number {
  return (PLACE_ERROR * (8 + Math.hypot(...o) + t)) / cosine;
}

async function trace(scene: ResolvedScene, rays: readonly Ray[], inTree: number): Promise<Traced[]> {
  const settings = { estimator: "path", sampler: "sobol", lightSamples: 1 } as const;
  const geometry = await prepareGeometry(scene);
  expect(geometry?.shapes.size ?? 0).toBe(inTree);
  const { sceneModule, features, uniform } = compileScene(scene, settings, undefined, geometry);
  const words = await runProbe({
    wgsl: `
      import package::constants::{INSIDE, NONE};
      import package::basis::{toLocal, toWorld};
      import package::ray::makeRay;
      import package::scene::{closestHit, occluded};
      import package::surface::surfaceAt;
      fn probe(i: u32) {
        let o = bitcast<vec4f>(inputs[3u * i]);
        let d = bitcast<vec4f>(inputs[3u * i + 1u]);
        let wi = bitcast<vec4f>(inputs[3u * i + 2u]).xyz;
        let ray = makeRay(o.xyz, d.xyz, NONE);
        let hit = closestHit(ray);
        outputs[4u * i] = vec4u(hit.id, bitcast<u32>(hit.t), 0u, 0u);
        if (hit.id == NONE) { return; }
        let surface = surfaceAt(ray, hit);
        // Leaves on the side it came from.
        let local = toLocal(surface.frame, wi);
        let next = makeRay(surface.p, normalize(toWorld(surface.frame, vec3f(local.xy, abs(local.z)))), surface.source);
        let nextHit = closestHit(next);
        outputs[4u * i].z = select(0u, 1u, occluded(next, o.w, NONE));
        outputs[4u * i + 1u] = bitcast<vec4u>(vec4f(surface.p, 0.0));
        outputs[4u * i + 1u].w = surface.source;
        outputs[4u * i + 2u] = bitcast<vec4u>(vec4f(next.d, 0.0));
        outputs[4u * i + 3u] = vec4u(nextHit.id, bitcast<u32>(nextHit.t), 0u, 0u);
      }`,
    conditions: features,
    modules: { scene: sceneModule },
    scene: uniform,
    geometry,
    count: rays.length,
    inputs: new Float32Array(rays.flatMap(({ o, d, wi, reach }) => [...o, reach, ...d, 0, ...wi, 0])),
    outputRows: 4 * rays.length,
  });
  const idBySlot = new Map(Array.from(geometry?.shapes ?? [], ([id, slot]) => [scene.objects.length + slot, id]));
  const idOf = (hitId: number) => idBySlot.get(hitId) ?? hitId;
  const floats = new Float32Array(words.buffer);
  const vector = (at: number): Vec3 => [floats[at]!, floats[at + 1]!, floats[at + 2]!];
  return rays.map((_, i) => {
    const at = 16 * i;
    return {
      id: idOf(words[at]!),
      t: floats[at + 1]!,
      blocked: words[at + 2] === 1,
      p: vector(at + 4),
      inside: words[at + 7]! >= INSIDE,
      d: vector(at + 8),
      nextId: idOf(words[at + 12]!),
      nextT: floats[at + 13]!,
    };
  });
}

function randomRays(seed: number): Ray[] {
  const random = createRandom(1000 + seed);
  return Array.from({ length: RAYS }, () => {
    const o = rounded([8 * random() - 4, 8 * random() - 4, 8 * random() - 4]);
    // The shader takes the direction in f32: so does the oracle.
    const [x, y, z] = randomDirection(random);
    const wi = randomDirection(random);
    return { o, d: [Math.fround(x), Math.fround(y), Math.fround(z)], wi, reach: Math.fround(0.1 + 6 * random()) };
  });
}

/** All coordinates are multiples of 1/256, exact in f32, so that shader and oracle mean the same scene. */
function randomScene(seed: number, copies: number, walls: number): ResolvedScene {
  const random = createRandom(seed);
  const at = (): Vec3 => rounded([6 * random() - 3, 6 * random() - 3, 6 * random() - 3]);
  const size = () => Math.round(256 * (0.25 + 1.25 * random())) / 256;
  const edge = () => rounded(scale(randomDirection(random), 2.5));
  const axes: readonly Vec3[] = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  const material = "m";
  const bounded = (): SceneObject[] => [
    ...Array.from({ length: 5 }, (): SceneObject => ({ type: "sphere", center: at(), radius: size(), material })),
    ...Array.from(
      { length: 3 },
      (): SceneObject => ({ type: "box", center: at(), size: [size(), size(), size()], material }),
    ),
    ...Array.from(
      { length: 2 },
      (): SceneObject => ({
        type: "box",
        center: at(),
        size: [size(), size(), size()],
        rotationY: 360 * random(),
        material,
      }),
    ),
    ...axes.map((_, i): SceneObject => {
      const [edge1, edge2] = [scale(axes[(i + 1) % 3]!, size()), scale(axes[(i + 2) % 3]!, -size())];
      return { type: "quad", corner: at(), edge1, edge2, material };
    }),
    ...Array.from(
      { length: 2 },
      (): SceneObject => ({ type: "quad", corner: at(), edge1: edge(), edge2: edge(), material }),
    ),
    ...Array.from({ length: 3 }, (): SceneObject => {
      const a = at();
      return { type: "triangle", vertices: [a, add(a, edge()), add(a, edge())], material };
    }),
  ];
  const large: SceneObject[] = [
    { type: "sphere", center: [3, 3, -3], radius: 2.5, material },
    { type: "box", center: [-3.5, 0, 0], size: [1, 7, 7], material },
    { type: "quad", corner: [-4, -4, 3.75], edge1: [8, 0, 0], edge2: [0, 8, 0], material },
    {
      type: "triangle",
      vertices: [
        [-4, -4, -4],
        [4, -4, -4],
        [0, 4, -4.5],
      ],
      material,
    },
  ];
  // Around everything, so that no ray starts on one; three planes to each huge sphere.
  const wall = (_: unknown, i: number): SceneObject => {
    const normal = rounded(randomDirection(random));
    const distance = 7 + random();
    if (i % 4 < 3) return { type: "plane", point: rounded(scale(normal, distance)), normal, material };
    return { type: "sphere", center: rounded(scale(normal, 1024 + distance)), radius: 1024, material };
  };
  const objects: SceneObject[] = [
    ...Array.from({ length: copies }, bounded).flat(),
    ...(copies > 1 ? large : []),
    { type: "plane", point: [0, -4.5, 0], normal: [0, 1, 0], material },
    // Its unit normal is rounded, so f32 cannot tell the sides of a ray that starts on it. None does, with z off the grid.
    { type: "plane", point: [0, 0, -5 - 2 ** -12], normal: [0.25, -0.125, 1], material },
    ...Array.from({ length: walls }, wall),
  ];
  const camera = { position: [0, 0, 9], target: [0, 0, 0] } as const;
  return parseScene({ camera, materials: { m: { ior: 1 } }, objects });
}

function rounded(v: Vec3): Vec3 {
  return [Math.round(256 * v[0]) / 256, Math.round(256 * v[1]) / 256, Math.round(256 * v[2]) / 256];
}
