// How a camera moves around its target. Every function takes a camera and gives a new one; a gesture that cannot be
// carried out (a step that is not finite, a camera that sits on its target) gives back the camera as it was.

import { quatn, vec3n } from "wgpu-matrix";
import type { ResolvedCamera } from "../scene/schema";
import { scaledFocus } from "./scaledFocus";

/** How near to straight up or down a view may tilt: there the horizon flips. */
const POLE_MARGIN_RADIANS = 0.01;

/** What zooming changes, in metres: the distance between camera and target or, of an orthographic camera, its height. */
export type ZoomLimits = { readonly min: number; readonly max: number };

/** Keeps it positive and far from where f32 ends. */
export const DEFAULT_ZOOM_LIMITS: ZoomLimits = { min: 1e-4, max: 1e6 };

/**
 * Limits that make sense for a scene seen from where its author put the camera.
 *
 * @param camera - the one that zooms. Of another kind than `home`, it may show as much at the target as `home` may.
 */
export function zoomLimitsFor(home: ResolvedCamera, camera = home): ZoomLimits {
  const size = zoomedBy(camera, home);
  return {
    min: Math.max(DEFAULT_ZOOM_LIMITS.min, size / 100),
    max: Math.min(DEFAULT_ZOOM_LIMITS.max, size * 100),
  };
}

/** What `camera` would zoom from, if it showed as much at the target as `home` does. */
function zoomedBy(camera: ResolvedCamera, home: ResolvedCamera): number {
  const distance = vec3n.distance(home.position, home.target);
  if (camera.orthographicHeight !== undefined) return home.orthographicHeight ?? distance * heightPerMetre(home);
  return home.orthographicHeight === undefined ? distance : home.orthographicHeight / heightPerMetre(camera);
}

/**
 * Turns the camera around its target.
 *
 * @param azimuthRadians - around `up`, counter-clockwise seen from above.
 * @param elevationRadians - towards `up`; stops short of the pole.
 */
export function orbitBy(camera: ResolvedCamera, azimuthRadians: number, elevationRadians: number): ResolvedCamera {
  const frame = frameOf(camera);
  if (frame === undefined || !Number.isFinite(azimuthRadians) || !Number.isFinite(elevationRadians)) return camera;
  const { up, back, right, distance } = frame;

  const limit = Math.PI / 2 - POLE_MARGIN_RADIANS;
  const elevation = Math.asin(clamp(vec3n.dot(back, up), -1, 1));
  const newElevation = clamp(elevation + elevationRadians, -limit, limit);

  // Built from the horizontal direction and the angle, so that thousands of small steps do not drift.
  const level = vec3n.cross(right, up);
  const turned = vec3n.transformQuat(level, quatn.fromAxisAngle(up, azimuthRadians));
  const horizontal = vec3n.scale(turned, distance * Math.cos(newElevation));
  const offset = vec3n.addScaled(horizontal, up, distance * Math.sin(newElevation));
  return { ...camera, position: toTuple(vec3n.add(camera.target, offset)) };
}

/**
 * Moves the camera to `factor` times its distance from the target: below 1 is nearer. A focus moves with it. An orthographic one stays,
 * and shows `factor` times the height.
 */
export function zoomBy(
  camera: ResolvedCamera,
  factor: number,
  limits: ZoomLimits = DEFAULT_ZOOM_LIMITS,
): ResolvedCamera {
  const frame = frameOf(camera);
  if (frame === undefined || !Number.isFinite(factor) || factor <= 0) return camera;
  const { orthographicHeight: height } = camera;
  if (height !== undefined) return { ...camera, orthographicHeight: clamp(height * factor, limits.min, limits.max) };
  const distance = clamp(frame.distance * factor, limits.min, limits.max);
  const position = toTuple(vec3n.addScaled(camera.target, frame.back, distance));
  return { ...camera, position, ...scaledFocus(camera, distance / frame.distance) };
}

/**
 * Moves camera and target together, in the plane of the picture. What is at the target's distance follows the pointer.
 *
 * @param rightShare - of the picture's height, to the right: the picture's content moves by this much.
 * @param upShare - of the picture's height, upwards.
 */
export function panBy(camera: ResolvedCamera, rightShare: number, upShare: number): ResolvedCamera {
  const frame = frameOf(camera);
  if (frame === undefined || !Number.isFinite(rightShare) || !Number.isFinite(upShare)) return camera;
  const { back, right, distance } = frame;
  const metresPerHeight = camera.orthographicHeight ?? distance * heightPerMetre(camera);
  const pictureUp = vec3n.cross(back, right);
  const step = vec3n.addScaled(
    vec3n.scale(right, -rightShare * metresPerHeight),
    pictureUp,
    -upShare * metresPerHeight,
  );
  return {
    ...camera,
    position: toTuple(vec3n.add(camera.position, step)),
    target: toTuple(vec3n.add(camera.target, step)),
  };
}

/** Metres from the lower to the upper edge of a perspective picture, a metre away. */
function heightPerMetre({ verticalFov }: ResolvedCamera): number {
  return 2 * Math.tan((verticalFov * Math.PI) / 360);
}

type Frame = { up: number[]; back: number[]; right: number[]; distance: number };

/** Unit vectors of the view; `back` points from the target to the camera. */
function frameOf(camera: ResolvedCamera): Frame | undefined {
  const offset = vec3n.subtract(camera.position, camera.target);
  const distance = vec3n.length(offset);
  if (!(distance > 0) || !Number.isFinite(distance)) return undefined;
  const up = vec3n.normalize(camera.up);
  const back = vec3n.scale(offset, 1 / distance);
  const side = vec3n.cross(up, back);
  // Looking along `up` no side is given: take the one of the axis that is least like it.
  const right = vec3n.length(side) > 1e-9 ? side : vec3n.cross(up, leastAlignedAxis(up));
  return { up, back, right: vec3n.normalize(right), distance };
}

function leastAlignedAxis(direction: readonly number[]): number[] {
  const sizes = direction.map(Math.abs);
  const least = sizes.indexOf(Math.min(...sizes));
  return [0, 1, 2].map((axis) => (axis === least ? 1 : 0));
}

function toTuple(vector: ArrayLike<number>): [number, number, number] {
  return [vector[0]!, vector[1]!, vector[2]!];
}

function clamp(value: number, low: number, high: number): number {
  return Math.min(high, Math.max(low, value));
}
