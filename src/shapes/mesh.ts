import { ALL_ROUND, sum } from "../lights/light";
import { add, length, scale, subtract } from "../math/vec3";
import type { ResolvedObject, Vec3 } from "../scene/schema";
import { cornersBetween } from "./cornersBetween";
import type { ShapeKind, Triangles } from "./shape";
import { TRIANGLE_DISTANCE } from "./triangle";

/** What holds its triangles; see `Triangles`. */
export type Mesh = Triangles & { readonly kind: "mesh" };

export const mesh: ShapeKind<ResolvedObject & { type: "mesh" }, Mesh> = {
  triangleDistance: TRIANGLE_DISTANCE,
  measure: (object, { coordinate }) => ({ ...object, positions: object.positions.map(coordinate) }),
  place: (_, { triangles }) => {
    if (!triangles) throw new TypeError("the geometry of a mesh has not been prepared");
    return { kind: "mesh", ...triangles };
  },
  reachAlong: ({ lower, upper }, direction, from) => {
    let most = 0;
    for (const axis of [0, 1, 2] as const) {
      const step = direction[axis];
      most += ((step > 0 ? upper : lower)[axis] - from[axis]) * step;
    }
    return most;
  },
  hull: ({ lower, upper }) => ({ points: cornersBetween(lower, upper) }),
  plane: () => undefined,
  meeting: () => "none",
  row: () => [0, 0, 0, -1],
  anchor: () => [0, 0, 0, 0],
  lights: ({ lower, upper, light }, radiance, primitive) => {
    if (!light) return [];
    const bound = { center: scale(add(lower, upper), 0.5), radius: length(subtract(upper, lower)) / 2 };
    // Of a closed surface, or of any seen from any side, a quarter of the area shows on average.
    const strength = (sum(radiance) * light.area) / 4;
    const position: Vec3 = [light.first, light.count, 0];
    return [{ ...ALL_ROUND, kind: "mesh", position, size: light.area, radiance, primitive, strength, bound }];
  },
};
