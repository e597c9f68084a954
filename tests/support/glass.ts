// Pictures of what light goes through, and what they should be in doubles: smooth solids before whatever emits, each ray followed
// into every reflection and refraction.

import { expect } from "vitest";
import type { Settings } from "../../src/renderer/settings";
import type { Camera, Rgb, Scene, SceneObject, Vec3 } from "../../src/scene/schema";
import { renderSeeds, seedsFrom } from "./device";
import { createRandom } from "./random";
import { constantImage, type ExpectedImage, judge, type MeasuredImage, measure } from "./statistics";

export type Look = {
  /** Width and height in pixels. */
  readonly size?: number;
  /** Per pixel and seed, of seeds 1 to 4. */
  readonly samples?: number;
  readonly settings?: Partial<Settings>;
};

/** What a scene's picture is, by seeds 1–4. No sample of it may be bad. */
export async function look(scene: Scene, { size = 16, samples = 64, settings = {} }: Look = {}) {
  const renders = await renderSeeds(scene, { size: [size, size], samples, seeds: seedsFrom(1, 4), settings });
  for (const { stats } of renders) expect(stats.badSamples).toBe(0);
  return measure(
    renders.map(({ image }) => image),
    size,
    size,
    samples,
  );
}

/** Four standard errors of the whole, and pixel by pixel as Mitsuba's tests; but a pixel of any picture may be off, for few seeds. */
export function expectImage(measured: MeasuredImage, expected: ExpectedImage, pixelShare = 0.9975): void {
  const verdict = judge(measured, expected);
  for (const sigmas of verdict.meanSigmas) expect(Math.abs(sigmas)).toBeLessThan(4);
  expect(verdict.blockShare).toBe(1);
  expect(verdict.pixelShare).toBeGreaterThanOrEqual(Math.min(pixelShare, 1 - 1 / (measured.width * measured.height)));
}

/**
 * That a picture shows one colour everywhere.
 *
 * @param rounding - relative, of the f32 operations of a path, beside that of the film.
 */
export function expectColor(measured: MeasuredImage, color: Rgb, rounding = 1e-5): void {
  const { width, height } = measured;
  const expected = constantImage(width, height, color);
  expectImage(measured, { ...expected, bias: new Float64Array(expected.image.length).fill(rounding) });
}

/** One picture as what another should be. */
export function asExpected({ mean, variance, samples }: MeasuredImage): ExpectedImage {
  return { image: mean, standardError: variance.map(Math.sqrt), samples, bias: new Float64Array(mean.length) };
}

/** Means of the channels, and their standard errors. */
export function meanColor({ mean, variance }: MeasuredImage): { color: Rgb; error: Rgb } {
  const [color, squares] = [
    [0, 0, 0],
    [0, 0, 0],
  ];
  for (let i = 0; i < mean.length; i++) {
    color[i % 3]! += (3 * mean[i]!) / mean.length;
    squares[i % 3]! += (9 * variance[i]!) / mean.length ** 2;
  }
  return { color: color as unknown as Rgb, error: squares.map(Math.sqrt) as unknown as Rgb };
}

const add = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const scale = (a: Vec3, s: number): Vec3 => [a[0] * s, a[1] * s, a[2] * s];
const subtract = (a: Vec3, b: Vec3): Vec3 => add(a, scale(b, -1));
const dot = (a: Vec3, b: Vec3) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const unit = (a: Vec3): Vec3 => scale(a, 1 / Math.hypot(...a));
const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** Reflectance of a smooth dielectric for unpolarised light; `eta` is the index beyond relative to the one before. */
export function fresnel(cosine: number, eta: number): number {
  const cos2 = 1 - (1 - cosine ** 2) / eta ** 2;
  if (cos2 <= 0) return 1;
  const cosT = Math.sqrt(cos2);
  const parallel = (eta * cosine - cosT) / (eta * cosine + cosT);
  const across = (cosine - eta * cosT) / (cosine + eta * cosT);
  return (parallel ** 2 + across ** 2) / 2;
}

/** Schlick's, of a thin wall. */
export function schlick(cosine: number, ior = 1.5): number {
  const f0 = ((ior - 1) / (ior + 1)) ** 2;
  return f0 + (1 - f0) * (1 - cosine) ** 5;
}

/** A smooth solid: a sphere, or a box with axes of its own. */
export type Solid = {
  readonly object: Extract<SceneObject, { type: "sphere" } | { type: "box" }>;
  readonly ior: number;
  /** Per metre. */
  readonly sigma?: Rgb;
  /** Of what is around it: it is the hollow in another one. */
  readonly isHollow?: boolean;
};

type Meeting = { readonly t: number; readonly n: Vec3; readonly solid: Solid };

const LEAST = 1e-9;

function meetings(o: Vec3, d: Vec3, solid: Solid): Meeting[] {
  const { object } = solid;
  if (object.type === "sphere") {
    const f = subtract(o, object.center);
    const b = -dot(f, d);
    const discriminant = object.radius ** 2 - Math.hypot(...add(f, scale(d, b))) ** 2;
    if (discriminant <= 0) return [];
    const root = Math.sqrt(discriminant);
    return [b - root, b + root].map((t) => ({ t, n: unit(add(f, scale(d, t))), solid }));
  }
  const angle = ((object.rotationY ?? 0) * Math.PI) / 180;
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const axes: readonly [Vec3, Vec3, Vec3] = [
    [c, 0, -s],
    [0, 1, 0],
    [s, 0, c],
  ];
  const f = subtract(o, object.center);
  let [near, far] = [
    { t: Number.NEGATIVE_INFINITY, n: axes[0] },
    { t: Number.POSITIVE_INFINITY, n: axes[0] },
  ];
  for (const [i, axis] of axes.entries()) {
    const [along, at, half] = [dot(d, axis), dot(f, axis), object.size[i]! / 2];
    if (along === 0 && Math.abs(at) > half) return [];
    if (along === 0) continue;
    const side = Math.sign(along);
    const [enter, leave] = [(-side * half - at) / along, (side * half - at) / along];
    if (enter > near.t) near = { t: enter, n: scale(axis, -side) };
    if (leave < far.t) far = { t: leave, n: scale(axis, side) };
  }
  return near.t < far.t ? [near, far].map((each): Meeting => ({ ...each, solid })) : [];
}

/** What arrives along a ray that meets no more solids. */
export type Backdrop = (o: Vec3, d: Vec3) => Rgb;

/**
 * Radiance along a ray by at most `bounces` reflections and refractions; what counts for less than `least` is left out.
 * Solids neither touch nor overlap, but one may hold another.
 */
export function radiance(
  o: Vec3,
  d: Vec3,
  solids: readonly Solid[],
  backdrop: Backdrop,
  bounces = 40,
  least = 1e-7,
): Rgb {
  return follow(o, d, 1, bounces);

  function follow(o: Vec3, d: Vec3, weight: number, left: number): Rgb {
    let first: Meeting | undefined;
    for (const solid of solids)
      for (const meeting of meetings(o, d, solid))
        if (meeting.t > LEAST && meeting.t < (first?.t ?? Number.POSITIVE_INFINITY)) first = meeting;
    const medium = mediumAt(add(o, scale(d, first ? first.t / 2 : 1)));
    const isInAir = medium === undefined || medium.isHollow === true;
    const sigma = isInAir ? [0, 0, 0] : (medium.sigma ?? [0, 0, 0]);
    const absorb = (L: Rgb, t: number) => L.map((value, i) => value * Math.exp(-sigma[i]! * t)) as unknown as Rgb;
    if (!first) return isInAir ? backdrop(o, d) : [0, 0, 0];
    if (left === 0 || weight < least) return [0, 0, 0];
    const p = add(o, scale(d, first.t));
    const isOutside = dot(d, first.n) < 0;
    const entering = isOutside !== (first.solid.isHollow ?? false);
    const n = isOutside ? first.n : scale(first.n, -1);
    // As the design has it, of a solid relative to nothing, whatever it lies in.
    const eta = entering ? first.solid.ior : 1 / first.solid.ior;
    const cosine = -dot(d, n);
    const F = fresnel(cosine, eta);
    let L: Rgb = [0, 0, 0];
    if (F > 0) L = scale(follow(p, unit(add(d, scale(n, 2 * cosine))), weight * F, left - 1), F) as unknown as Rgb;
    if (F < 1) {
      const cosT = Math.sqrt(1 - (1 - cosine ** 2) / eta ** 2);
      const through = unit(add(scale(d, 1 / eta), scale(n, cosine / eta - cosT)));
      L = add(L as Vec3, scale(follow(p, through, weight * (1 - F), left - 1) as Vec3, 1 - F)) as unknown as Rgb;
    }
    return absorb(L, first.t);
  }

  function mediumAt(p: Vec3): Solid | undefined {
    return solids.filter((solid) => isIn(p, solid)).sort((a, b) => sizeOf(a) - sizeOf(b))[0];
  }
}

function isIn(p: Vec3, solid: Solid): boolean {
  const [near, far] = meetings(p, [0.6, 0.48, 0.64], solid);
  return near !== undefined && near.t < 0 && far!.t > 0;
}

function sizeOf({ object }: Solid): number {
  return object.type === "sphere" ? object.radius : Math.max(...object.size) / 2;
}

/** A ray through a point of a square picture, each coordinate from 0, left and top, to 1. */
export function cameraRay(camera: Camera, x: number, y: number): { o: Vec3; d: Vec3 } {
  const forward = unit(subtract(camera.target ?? [0, 0, 0], camera.position));
  const half = Math.tan(((camera.verticalFov ?? 45) * Math.PI) / 360);
  const right = unit(cross(forward, camera.up ?? [0, 1, 0]));
  const up = cross(right, forward);
  const at = add(scale(right, half * (2 * x - 1)), scale(up, half * (1 - 2 * y)));
  return { o: camera.position, d: unit(add(forward, at)) };
}

/** A square picture of what `of` tells of rays, by `perPixel`² of them in each pixel, one in each cell of a grid; of seed 7. */
export function picture(camera: Camera, size: number, perPixel: number, of: (o: Vec3, d: Vec3) => Rgb): ExpectedImage {
  const random = createRandom(7);
  const image = new Float64Array(3 * size * size);
  const standardError = new Float64Array(image.length);
  const count = perPixel ** 2;
  for (let pixel = 0; pixel < size * size; pixel++) {
    const [sum, squares] = [
      [0, 0, 0],
      [0, 0, 0],
    ];
    for (let i = 0; i < count; i++) {
      const x = (pixel % size) + ((i % perPixel) + random()) / perPixel;
      const y = Math.floor(pixel / size) + (Math.floor(i / perPixel) + random()) / perPixel;
      const { o, d } = cameraRay(camera, x / size, y / size);
      const L = of(o, d);
      for (let c = 0; c < 3; c++) {
        sum[c]! += L[c]!;
        squares[c]! += L[c]! ** 2;
      }
    }
    for (let c = 0; c < 3; c++) {
      image[3 * pixel + c] = sum[c]! / count;
      // Of points anywhere in the pixel: more than those of a grid have.
      standardError[3 * pixel + c] = Math.sqrt(Math.max(squares[c]! / count - (sum[c]! / count) ** 2, 0) / (count - 1));
    }
  }
  // Of f32 along a path: 40 segments of a dozen roundings.
  return { image, standardError, samples: count, bias: new Float64Array(image.length).fill(3e-5) };
}
