import { normalize, subtract } from "../math/vec3";
import type { ResolvedObject, Vec3 } from "../scene/schema";
import { type Axis, axisOf } from "./axis";
import type { ShapeKind } from "./shape";

export type Plane = {
  readonly kind: "plane";
  readonly point: Vec3;
  /** Unit. */
  readonly normal: Vec3;
  readonly axis: Axis | undefined;
};

/** Infinite. It emits too, but has no area to sample: its light is found by scattered rays. */
export const plane: ShapeKind<ResolvedObject & { type: "plane" }, Plane> = {
  measure: (object, { point }) => ({ ...object, point: point(object.point) }),
  place: (object, { origin }) => {
    const normal = normalize(object.normal);
    return { kind: "plane", point: subtract(object.point, origin), normal, axis: axisOf(normal) };
  },
  reachAlong: () => Number.POSITIVE_INFINITY,
  hull: () => undefined,
  plane: (shape) => shape,
  meeting: () => "loop",
  row: ({ normal }) => [...normal, 0],
  anchor: ({ point }) => [...point, 1],
  lights: () => [],
  emit: ({ point, normal, axis }, _, values) => {
    if (axis)
      return {
        distance: `package::shapes::plane::planeIntersect${axis}(ray, ${values.scalar(point["XYZ".indexOf(axis)]!)})`,
      };
    return { distance: `package::shapes::plane::planeIntersect(ray, ${values.vec3(point)}, ${values.vec3(normal)})` };
  },
  loop: {
    table: "planes",
    row: ({ point, normal }) => ({ point, direction: normal }),
    distance: "package::shapes::plane::planeIntersect(ray, row.point, row.direction)",
  },
};
