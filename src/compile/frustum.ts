import { add, scale } from "../math/vec3";
import type { Vec3 } from "../scene/schema";

/** What a camera sees, by image plane coordinates (x, y) in [-1, 1]. */
export type Frustum = {
  readonly origin: Vec3;
  /** Unit. */
  readonly forward: Vec3;
  /** The ray through (x, y) runs from the origin along forward + x·right + y·up. */
  readonly right: Vec3;
  readonly up: Vec3;
  /** The ray through (x, y) runs along forward instead, from origin + x·right + y·up. */
  readonly isOrthographic?: boolean;
};

/** A ray that gets to depth z, along the view's `forward`, at from + z·along. */
export type EdgeRay = { readonly from: Vec3; readonly along: Vec3 };

/** The rays through the corners of the image: at every depth, all others are between them. */
export function edgeRays({ origin, forward, right, up, isOrthographic = false }: Frustum): EdgeRay[] {
  return [-1, 1].flatMap((x) =>
    [-1, 1].map((y) => {
      const offset = add(scale(right, x), scale(up, y));
      return isOrthographic
        ? { from: add(origin, offset), along: forward }
        : { from: origin, along: add(forward, offset) };
    }),
  );
}
