import { vec3d } from "wgpu-matrix";
import type { ResolvedCamera, Vec3 } from "../scene/schema";

/** A pinhole camera as the shader wants it: the ray through image plane coordinates (x, y) runs along forward + x·right + y·up. */
export type CameraBasis = {
  /** Position relative to the compiled scene's origin. */
  readonly origin: ArrayLike<number>;
  /** Unit. */
  readonly forward: ArrayLike<number>;
  /** From the centre of the image plane, at distance 1, to its right edge. */
  readonly right: ArrayLike<number>;
  /** To its upper edge. */
  readonly up: ArrayLike<number>;
};

/** Computed in doubles; `origin` is the compiled scene's, `aspect` width over height. */
export function cameraBasis(camera: ResolvedCamera, origin: Vec3, aspect: number): CameraBasis {
  const { position, target, up, verticalFov } = camera;
  const forward = vec3d.normalize(vec3d.subtract(target, position));
  const right = vec3d.normalize(vec3d.cross(forward, up));
  const halfHeight = Math.tan((verticalFov * Math.PI) / 360);
  return {
    origin: vec3d.subtract(position, origin),
    forward,
    right: vec3d.scale(right, halfHeight * aspect),
    up: vec3d.scale(vec3d.cross(right, forward), halfHeight),
  };
}
