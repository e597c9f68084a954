import { add, cross, dot, length, normalize, scale, subtract } from "../math/vec3";
import type { ResolvedCamera, Vec3 } from "../scene/schema";
import { scaledFocus } from "./scaledFocus";

/** Where a camera stands around its target; `undefined` leaves a part as the scene has it. */
export type CameraOrbit = {
  /** Around `up`, counter-clockwise seen from above; 0 is on the side of +Z, or of −Y where +Z is up. */
  readonly azimuthRadians: number | undefined;
  /** Above the plane across `up`, within ±90°. */
  readonly elevationRadians: number | undefined;
  /** From the target, in metres. */
  readonly distance: number | undefined;
};

const RADIANS: Readonly<Record<string, number>> = { deg: Math.PI / 180, rad: 1 };
const METRES: Readonly<Record<string, number>> = { m: 1, cm: 0.01, mm: 0.001 };

/** Straight up and down have no horizon, so a view tilts no further than this from the plane. */
const MAX_ELEVATION_RADIANS = Math.PI / 2 - 0.01;

/**
 * Reads `"30deg 15deg 5m"`: azimuth, elevation, distance. Angles are in `deg` or `rad`, distances in `m`, `cm` or `mm`;
 * `auto` is what the scene has.
 *
 * @returns `undefined` for anything else, which counts as if the attribute were absent.
 */
export function parseCameraOrbit(text: string | null): CameraOrbit | undefined {
  const parts = (text ?? "").trim().split(/\s+/);
  if (parts.length !== 3) return undefined;
  const [azimuthRadians, elevationRadians, distance] = [RADIANS, RADIANS, METRES].map((units, index) =>
    parseMeasure(parts[index]!, units),
  );
  if ([azimuthRadians, elevationRadians, distance].some(Number.isNaN)) return undefined;
  if (distance !== undefined && distance <= 0) return undefined;
  return { azimuthRadians, elevationRadians, distance };
}

/** Moves a camera around its target, and a focus with it. One that sits on its target, and so has no direction, stays where it is. */
export function placeOnOrbit(camera: ResolvedCamera, orbit: CameraOrbit): ResolvedCamera {
  const offset = subtract(camera.position, camera.target);
  const metres = length(offset);
  if (metres === 0) return camera;
  const up = normalize(camera.up);
  const { front, side } = levelAxes(up);
  const {
    azimuthRadians: azimuth = Math.atan2(dot(offset, side), dot(offset, front)),
    elevationRadians = Math.asin(clamp(dot(offset, up) / metres, -1, 1)),
    distance = metres,
  } = orbit;
  const elevation = clamp(elevationRadians, -MAX_ELEVATION_RADIANS, MAX_ELEVATION_RADIANS);
  const level = add(scale(front, Math.cos(azimuth)), scale(side, Math.sin(azimuth)));
  const direction = add(scale(level, Math.cos(elevation)), scale(up, Math.sin(elevation)));
  const position = add(camera.target, scale(direction, distance));
  return { ...camera, position, ...scaledFocus(camera, distance / metres) };
}

/** @returns `undefined` for `auto`, NaN for what is not a finite number with one of the units. */
function parseMeasure(text: string, units: Readonly<Record<string, number>>): number | undefined {
  if (text === "auto") return undefined;
  const [, number, unit] = /^(.+?)([a-z]+)$/.exec(text) ?? [];
  const value = Number(number ?? Number.NaN) * (units[unit ?? ""] ?? Number.NaN);
  return Number.isFinite(value) ? value : Number.NaN;
}

/** Unit vectors across `up`: where azimuth is 0, and where it is a quarter turn. */
function levelAxes(up: Vec3): { front: Vec3; side: Vec3 } {
  const isZUp = Math.abs(up[2]) > 0.99;
  const side = normalize(cross(up, isZUp ? [0, -1, 0] : [0, 0, 1]));
  return { front: cross(side, up), side };
}

function clamp(value: number, low: number, high: number): number {
  return Math.min(high, Math.max(low, value));
}
