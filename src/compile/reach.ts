import { dot } from "../math/vec3";
import type { Vec3 } from "../scene/schema";
import type { Shape } from "./primitives";

/**
 * How far a shape reaches along a direction: the greatest dot(p − from, direction) over its points p, infinite for a plane. Of
 * a mesh, for the box around it. It allocates nothing, because it runs for every shape of a scene whenever the camera moves.
 *
 * @param direction - unit.
 */
export function reachAlong(shape: Shape, direction: Vec3, from: Vec3): number {
  switch (shape.kind) {
    case "sphere":
      return along(shape.center, direction, from) + shape.radius;
    case "plane":
      return Number.POSITIVE_INFINITY;
    case "quad": {
      const { corner, edge1, edge2 } = shape;
      return along(corner, direction, from) + Math.max(dot(edge1, direction), 0) + Math.max(dot(edge2, direction), 0);
    }
    case "triangle": {
      const [a, b, c] = shape.vertices;
      return Math.max(along(a, direction, from), along(b, direction, from), along(c, direction, from));
    }
    case "box": {
      const { center, halfSize, turn = 0 } = shape;
      const [c, s] = [Math.cos(turn), Math.sin(turn)];
      const [x, y, z] = direction;
      const [dx, dz] = [c * x - s * z, s * x + c * z]; // in the box's own frame
      const half = halfSize[0] * Math.abs(dx) + halfSize[1] * Math.abs(y) + halfSize[2] * Math.abs(dz);
      return along(center, direction, from) + half;
    }
    case "mesh": {
      const { lower, upper } = shape;
      let most = 0;
      for (const axis of [0, 1, 2] as const) {
        const step = direction[axis];
        most += ((step > 0 ? upper : lower)[axis] - from[axis]) * step;
      }
      return most;
    }
  }
}

function along(p: Vec3, direction: Vec3, from: Vec3): number {
  return (p[0] - from[0]) * direction[0] + (p[1] - from[1]) * direction[1] + (p[2] - from[2]) * direction[2];
}
