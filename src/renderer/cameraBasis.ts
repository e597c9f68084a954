import { clearDepth } from "../compile/clearDepth";
import type { Emitter } from "../compile/emitterWindow";
import { emitterWindow, shareOf } from "../compile/emitterWindow";
import { add, cross, normalize, scale, subtract } from "../math/vec3";
import type { ResolvedCamera, Vec3 } from "../scene/schema";
import type { Shape } from "../shapes/shapes";

/** A pinhole camera as the shader wants it: the ray through image plane coordinates (x, y) runs along forward + x·right + y·up. */
export type CameraBasis = {
  /** Position relative to the compiled scene's origin, in its units. */
  readonly origin: Vec3;
  /** Unit. */
  readonly forward: Vec3;
  /** From the centre of the image plane, at distance 1, to its right edge. */
  readonly right: Vec3;
  /** To its upper edge. */
  readonly up: Vec3;
};

/** Computed in doubles; `origin` and `unit` are the compiled scene's, `aspect` width over height. */
export function cameraBasis(camera: ResolvedCamera, origin: Vec3, aspect: number, unit = 1): CameraBasis {
  const { position, target, up, verticalFov } = camera;
  const forward = normalize(subtract(target, position));
  const right = normalize(cross(forward, up));
  const halfHeight = Math.tan((verticalFov * Math.PI) / 360);
  return {
    origin: scale(subtract(position, origin), 1 / unit),
    forward,
    right: scale(right, halfHeight * aspect),
    up: scale(cross(right, forward), halfHeight),
  };
}

/** Where camera rays start: on the plane at distance `near`, whose centre is `origin`, clear of all shapes. */
export function rayStart(basis: CameraBasis, shapes: readonly Shape[]): CameraBasis & { readonly near: number } {
  const near = clearDepth(shapes, basis);
  return { ...basis, origin: add(basis.origin, scale(basis.forward, near)), near };
}

// An emitter that fills more of the picture than this has too few edges in it to pay for looking at all of it more often.
const MAX_EMITTER_SHARE = 0.25;

/** The pixels, from the first to before the second, in which emitters are looked for by rays of their own. */
export function emitterPixels(emitters: readonly Emitter[], basis: CameraBasis, width: number, height: number) {
  const window = emitterWindow(emitters, basis);
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
