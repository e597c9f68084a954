import { add, dot, length, scale, subtract } from "../math/vec3";
import type { Vec3 } from "../scene/schema";
import { extent } from "./blockers";
import type { View } from "./clearDepth";
import type { Shape } from "./primitives";
import { reachAlong } from "./reach";

/** A rectangle of the image plane: [left, bottom, right, top], each in [-1, 1]. */
export type Window = readonly [left: number, bottom: number, right: number, top: number];

const NOTHING: Window = [1, 1, -1, -1];
const EVERYTHING: Window = [-1, -1, 1, 1];

// A window around each of more lamps than these, for every movement of the camera, would take more time than it saves.
const MOST_LAMPS = 64;

/** Shapes whose window is quick to find: those given or, of many, the box around them. */
export function lampsOf(shapes: readonly Shape[]): readonly Shape[] {
  if (shapes.length <= MOST_LAMPS) return shapes;
  const plane = shapes.find(({ kind }) => kind === "plane");
  return [plane ?? boxAround(shapes)];
}

function boxAround(shapes: readonly Shape[]): Shape {
  const reach = (x: number, y: number, z: number) =>
    shapes.reduce((most, shape) => Math.max(most, reachAlong(shape, [x, y, z], [0, 0, 0])), Number.NEGATIVE_INFINITY);
  const lower: Vec3 = [-reach(-1, 0, 0), -reach(0, -1, 0), -reach(0, 0, -1)];
  const upper: Vec3 = [reach(1, 0, 0), reach(0, 1, 0), reach(0, 0, 1)];
  const center = scale(add(lower, upper), 0.5);
  return { kind: "box", center, halfSize: subtract(upper, center), turn: undefined };
}

/** A part of the image outside of which the camera sees none of the shapes. */
export function lampWindow(lamps: readonly Shape[], view: View): Window {
  return lamps.map((lamp) => windowOf(lamp, view)).reduce(union, NOTHING);
}

/** Whether a view may show some of a shape. */
export function isInView(shape: Shape, view: View): boolean {
  if (length(view.right) === 0 || length(view.up) === 0) return true; // a single ray: it has no image plane
  return windowOf(shape, view) !== NOTHING;
}

/** Share of the image that a window takes. */
export function shareOf([left, bottom, right, top]: Window): number {
  return (Math.max(right - left, 0) * Math.max(top - bottom, 0)) / 4;
}

function windowOf(shape: Shape, view: View): Window {
  if (shape.kind === "plane") return EVERYTHING;
  if (shape.kind === "sphere") {
    const [left, right] = ballRange(shape.center, shape.radius, view, view.right);
    const [bottom, top] = ballRange(shape.center, shape.radius, view, view.up);
    return clip([left, bottom, right, top]);
  }
  const points = extent(shape, view.forward).map((point) => subtract(point, view.origin));
  // What reaches behind the camera may be anywhere in its image.
  if (points.some((point) => dot(point, view.forward) <= 0)) return EVERYTHING;
  const [xs, ys] = [view.right, view.up].map((axis) => points.map((point) => tangent(point, view, axis)));
  return clip([Math.min(...xs!), Math.min(...ys!), Math.max(...xs!), Math.max(...ys!)]);
}

/** Where a ball lies along an axis of the image plane, by the two tangents from the camera. */
function ballRange(center: Vec3, radius: number, view: View, axis: Vec3): [number, number] {
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

function tangent(point: Vec3, view: View, axis: Vec3): number {
  return dot(point, axis) / (dot(point, view.forward) * dot(axis, axis));
}

function clip([left, bottom, right, top]: Window): Window {
  const inside = left <= 1 && right >= -1 && bottom <= 1 && top >= -1;
  return inside ? [Math.max(left, -1), Math.max(bottom, -1), Math.min(right, 1), Math.min(top, 1)] : NOTHING;
}

function union(a: Window, b: Window): Window {
  return [Math.min(a[0], b[0]), Math.min(a[1], b[1]), Math.max(a[2], b[2]), Math.max(a[3], b[3])];
}
