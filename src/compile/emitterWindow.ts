import { dot, length, scale, subtract } from "../math/vec3";
import type { Vec3 } from "../scene/schema";
import { cornersBetween } from "../shapes/cornersBetween";
import type { Hull } from "../shapes/shape";
import { hullOf, reachAlong, type Shape } from "../shapes/shapes";
import { blurOf, type Frustum } from "./frustum";

/** A rectangle of the image plane: [left, bottom, right, top], each in [-1, 1]. */
export type Window = readonly [left: number, bottom: number, right: number, top: number];

const NOTHING: Window = [1, 1, -1, -1];
const EVERYTHING: Window = [-1, -1, 1, 1];

// A window around each of more emitters than these, for every movement of the camera, would take more time than it saves.
const MOST_EMITTERS = 64;

/** What holds a visible emitter; undefined for an infinite one. */
export type Emitter = Hull | undefined;

/** What holds the shapes that the camera may see emit, each for itself or, of many, together. */
export function emittersOf(shapes: readonly Shape[]): readonly Emitter[] {
  const hulls = shapes.map(hullOf);
  if (hulls.includes(undefined)) return [undefined];
  return hulls.length <= MOST_EMITTERS ? hulls : [boxAround(shapes)];
}

function boxAround(shapes: readonly Shape[]): Hull {
  const reach = (x: number, y: number, z: number) =>
    shapes.reduce((most, shape) => Math.max(most, reachAlong(shape, [x, y, z], [0, 0, 0])), Number.NEGATIVE_INFINITY);
  const lower: Vec3 = [-reach(-1, 0, 0), -reach(0, -1, 0), -reach(0, 0, -1)];
  return { points: cornersBetween(lower, [reach(1, 0, 0), reach(0, 1, 0), reach(0, 0, 1)]) };
}

/** A part of the image outside of which the camera sees none of the shapes. */
export function emitterWindow(emitters: readonly Emitter[], view: Frustum): Window {
  return emitters.map((emitter) => windowOf(emitter, view)).reduce(union, NOTHING);
}

/** Whether a view may show some of what a hull holds. */
export function isInView(hull: Hull, view: Frustum): boolean {
  if (length(view.right) === 0 || length(view.up) === 0) return true; // a single ray: it has no image plane
  return windowOf(hull, view) !== NOTHING;
}

/** Share of the image that a window takes. */
export function shareOf([left, bottom, right, top]: Window): number {
  return (Math.max(right - left, 0) * Math.max(top - bottom, 0)) / 4;
}

function windowOf(emitter: Emitter, view: Frustum): Window {
  if (emitter === undefined) return EVERYTHING;
  const { origin, forward, right, up, isOrthographic } = view;
  const [nearest, farthest] = rangeAlong(emitter, origin, forward);
  if (farthest < 0 && (isOrthographic || view.lens)) return NOTHING;
  const blur = blurOf(view, nearest, farthest);
  if (!Number.isFinite(blur)) return EVERYTHING;
  const sharp = isOrthographic ? rangesOf(emitter, view) : seenRanges(emitter, view);
  if (sharp === undefined) return EVERYTHING;
  const [x, y] = sharp;
  const [wider, higher] = blur === 0 ? [0, 0] : [blur / length(right), blur / length(up)];
  return clip([x[0] - wider, y[0] - higher, x[1] + wider, y[1] + higher]);
}

type Ranges = readonly [x: readonly [number, number], y: readonly [number, number]];

/** Where a hull lies in the image plane; undefined for anywhere. */
function seenRanges(hull: Hull, view: Frustum): Ranges | undefined {
  if ("ball" in hull) {
    const { center, radius } = hull.ball;
    return [ballRange(center, radius, view, view.right), ballRange(center, radius, view, view.up)];
  }
  const points = hull.points.map((point) => subtract(point, view.origin));
  // What reaches behind the camera may be anywhere in its image.
  if (points.some((point) => dot(point, view.forward) <= 0)) return undefined;
  const [xs, ys] = [view.right, view.up].map((axis) => points.map((point) => tangent(point, view, axis)));
  return [rangeOf(xs!), rangeOf(ys!)];
}

/** The same by parallel rays. */
function rangesOf(hull: Hull, { origin, right, up }: Frustum): Ranges {
  const [x, y] = [right, up].map((axis) => rangeAlong(hull, origin, scale(axis, 1 / dot(axis, axis))));
  return [x!, y!];
}

/** Least and most of what points of a hull have along an axis. */
function rangeAlong(hull: Hull, origin: Vec3, axis: Vec3): [number, number] {
  if ("ball" in hull) {
    const [middle, reach] = [dot(subtract(hull.ball.center, origin), axis), hull.ball.radius * length(axis)];
    return [middle - reach, middle + reach];
  }
  return rangeOf(hull.points.map((point) => dot(subtract(point, origin), axis)));
}

function rangeOf(places: readonly number[]): [number, number] {
  return [Math.min(...places), Math.max(...places)];
}

/** Where a ball lies along an axis of the image plane, by the two tangents from the camera. */
function ballRange(center: Vec3, radius: number, view: Frustum, axis: Vec3): [number, number] {
  const toCenter = subtract(center, view.origin);
  const across = dot(toCenter, scale(axis, 1 / length(axis)));
  const depth = dot(toCenter, view.forward);
  const distance = Math.hypot(across, depth);
  if (distance <= radius) return [Number.NEGATIVE_INFINITY, Number.POSITIVE_INFINITY];
  const angle = Math.atan2(across, depth);
  const half = Math.asin(radius / distance);
  const at = (direction: number) => {
    if (Math.abs(direction) >= Math.PI / 2) return Math.sign(direction) * Number.POSITIVE_INFINITY;
    return Math.tan(direction) / length(axis);
  };
  return [at(angle - half), at(angle + half)];
}

function tangent(point: Vec3, view: Frustum, axis: Vec3): number {
  return dot(point, axis) / (dot(point, view.forward) * dot(axis, axis));
}

function clip([left, bottom, right, top]: Window): Window {
  const inside = left <= 1 && right >= -1 && bottom <= 1 && top >= -1;
  return inside ? [Math.max(left, -1), Math.max(bottom, -1), Math.min(right, 1), Math.min(top, 1)] : NOTHING;
}

function union(a: Window, b: Window): Window {
  return [Math.min(a[0], b[0]), Math.min(a[1], b[1]), Math.max(a[2], b[2]), Math.max(a[3], b[3])];
}
