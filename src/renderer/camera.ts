import { vec3d } from "wgpu-matrix";
import { clearDepth } from "../compile/clearDepth";
import type { Shape } from "../compile/primitives";
import type { ResolvedCamera, Vec3 } from "../scene/schema";

/** A pinhole camera as the shader wants it: the ray through image plane coordinates (x, y) runs along forward + x·right + y·up. */
export type CameraBasis = {
  /** Position relative to the compiled scene's origin. */
  readonly origin: Vec3;
  /** Unit. */
  readonly forward: Vec3;
  /** From the centre of the image plane, at distance 1, to its right edge. */
  readonly right: Vec3;
  /** To its upper edge. */
  readonly up: Vec3;
};

/** Computed in doubles; `origin` is the compiled scene's, `aspect` width over height. */
export function cameraBasis(camera: ResolvedCamera, origin: Vec3, aspect: number): CameraBasis {
  const { position, target, up, verticalFov } = camera;
  const forward = vec3d.normalize(vec3d.subtract(target, position));
  const right = vec3d.normalize(vec3d.cross(forward, up));
  const halfHeight = Math.tan((verticalFov * Math.PI) / 360);
  return {
    origin: triple(vec3d.subtract(position, origin)),
    forward: triple(forward),
    right: triple(vec3d.scale(right, halfHeight * aspect)),
    up: triple(vec3d.scale(vec3d.cross(right, forward), halfHeight)),
  };
}

/** Where camera rays start: on the plane at distance `near`, whose centre is `origin`, clear of all shapes. */
export function rayStart(basis: CameraBasis, shapes: readonly Shape[]): CameraBasis & { readonly near: number } {
  const near = clearDepth(shapes, basis);
  return { ...basis, origin: triple(vec3d.addScaled(basis.origin, basis.forward, near)), near };
}

function triple(v: ArrayLike<number>): Vec3 {
  return [v[0]!, v[1]!, v[2]!];
}
