import { clearDepth } from "../compile/clearDepth";
import type { Emitter } from "../compile/emitterWindow";
import { emitterWindow, shareOf } from "../compile/emitterWindow";
import type { Frustum, Lens } from "../compile/frustum";
import { add, cross, length, normalize, scale, subtract } from "../math/vec3";
import type { ResolvedCamera, Vec3 } from "../scene/schema";
import type { Shape } from "../shapes/shapes";

/**
 * Computed in doubles; `origin` and `unit` are the compiled scene's, `aspect` width over height.
 *
 * @returns the view relative to that origin, in units. `right` and `up` end at the edges of the picture: where it is 1 away, or
 * of an orthographic one, wherever it is.
 */
export function cameraBasis(camera: ResolvedCamera, origin: Vec3, aspect: number, unit = 1): Frustum {
  const { position, target, up, verticalFov, orthographicHeight, aperture } = camera;
  const view = subtract(target, position);
  const { focusDistance = length(view) } = camera;
  const forward = normalize(view);
  const right = normalize(cross(forward, up));
  const isOrthographic = orthographicHeight !== undefined;
  const halfHeight = isOrthographic ? orthographicHeight / 2 / unit : Math.tan((verticalFov * Math.PI) / 360);
  return {
    origin: scale(subtract(position, origin), 1 / unit),
    forward,
    right: scale(right, halfHeight * aspect),
    up: scale(cross(right, forward), halfHeight),
    isOrthographic,
    ...(aperture > 0 && { lens: lensOf(aperture / unit, focusDistance / unit) }),
  };
}

// A wider lens, and steeper rays from its edge, leave f32 no digits for what they see, and no exponents for squares.
const WIDEST = 1e12;
const STEEPEST = 1e9;

function lensOf(aperture: number, focusDistance: number): Lens {
  const radius = Math.min(aperture, WIDEST);
  return { radius, focus: Math.max(focusDistance, radius / STEEPEST) };
}

// To the shader an orthographic camera is a pinhole camera that is this far away. A power of two, so that no digit of where its rays
// start changes, and so large that f32 rounds away by how much they are not parallel.
const FAR_AWAY = 2 ** 64;

/**
 * Camera rays as the shader wants them: through image plane coordinates (x, y) from origin + near·offset along forward + offset,
 * with offset = x·right + y·up. They start on a plane clear of all shapes. `lens` is what a lens adds to this: see lens.wgsl.
 */
export function rayStart(view: Frustum, shapes: readonly Shape[]) {
  const { forward, right, up, isOrthographic, lens } = view;
  const depth = clearDepth(shapes, view);
  const away = isOrthographic ? FAR_AWAY : 1;
  const radius = lens ? (away * lens.radius) / length(up) : 0;
  return {
    origin: add(view.origin, scale(forward, depth)),
    forward,
    right: scale(right, 1 / away),
    up: scale(up, 1 / away),
    near: isOrthographic ? FAR_AWAY : depth,
    lens: lens ? [radius * (1 - depth / lens.focus), radius / lens.focus] : [0, 0],
  };
}

// An emitter that fills more of the picture than this has too few edges in it to pay for looking at all of it more often.
const MAX_EMITTER_SHARE = 0.25;

/** The pixels, from the first to before the second, in which emitters are looked for by rays of their own. */
export function emitterPixels(emitters: readonly Emitter[], view: Frustum, width: number, height: number) {
  const window = emitterWindow(emitters, view);
  const share = shareOf(window);
  if (share === 0 || share > MAX_EMITTER_SHARE) return { emittersFrom: [0, 0], emittersTo: [0, 0] };
  const [left, bottom, right, top] = window;
  const column = (x: number) => ((x + 1) / 2) * width;
  const row = (y: number) => ((1 - y) / 2) * height;
  return {
    emittersFrom: [Math.floor(column(left)), Math.floor(row(top))],
    emittersTo: [Math.ceil(column(right)), Math.ceil(row(bottom))],
  };
}
