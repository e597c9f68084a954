import { ballAround, flatLight } from "../lights/light";
import { add, cross, dot, length, normalize, scale, subtract } from "../math/vec3";
import type { ResolvedObject, Vec3 } from "../scene/schema";
import { along } from "./along";
import { type Axis, axisOf } from "./axis";
import { halfEdgeDuals } from "./duals";
import { dualWithRim, towardsMiddle, withRim } from "./rims";
import type { ShapeKind } from "./shape";

export type Quad = {
  readonly kind: "quad";
  readonly corner: Vec3;
  readonly edge1: Vec3;
  readonly edge2: Vec3;
  /** Unit. */
  readonly normal: Vec3;
  /** Of a rectangle whose edges are parallel to axes: the one across it. */
  readonly axis: Axis | undefined;
};

/** Its middle, and the dual vectors of its half edges with the rim that makes it tight against its neighbours. */
function dualsOf({ corner, edge1, edge2, normal }: Quad): { middle: Vec3; duals: [Vec3, Vec3] } {
  const middle = add(corner, scale(add(edge1, edge2), 0.5));
  const [dual1, dual2] = halfEdgeDuals(edge1, edge2, normal);
  return { middle, duals: [dualWithRim(dual1, middle), dualWithRim(dual2, middle)] };
}

const cornersOf = ({ corner, edge1, edge2 }: Quad): Vec3[] => [
  corner,
  add(corner, edge1),
  add(corner, edge2),
  add(add(corner, edge1), edge2),
];

export const quad: ShapeKind<ResolvedObject & { type: "quad" }, Quad> = {
  measure: (object, { point }) => {
    const { corner, edge1, edge2 } = object;
    return { ...object, corner: point(corner), edge1: point(edge1), edge2: point(edge2) };
  },
  place: ({ corner, edge1, edge2 }, { origin }) => {
    const normal = normalize(cross(edge1, edge2));
    const axis = axisOf(edge1) && axisOf(edge2) && axisOf(normal);
    return { kind: "quad", corner: subtract(corner, origin), edge1, edge2, normal, axis };
  },
  reachAlong: ({ corner, edge1, edge2 }, direction, from) =>
    along(corner, direction, from) + Math.max(dot(edge1, direction), 0) + Math.max(dot(edge2, direction), 0),
  hull: (shape) => ({ points: cornersOf(shape) }),
  plane: ({ corner, normal }) => ({ point: corner, normal }),
  meeting: () => "bounded",
  row: ({ normal }) => [...normal, 0],
  anchor: ({ corner, edge1, edge2 }) => {
    const middle = add(corner, scale(add(edge1, edge2), 0.5));
    const sides = [length(edge1), length(edge2)];
    const toEdge = length(cross(edge1, edge2)) / (2 * Math.max(...sides));
    return [...middle, towardsMiddle(middle, toEdge, (sides[0]! + sides[1]!) / 2)];
  },
  lights: (shape, radiance, primitive) => {
    const { corner, edge1, edge2, normal } = shape;
    const bound = ballAround(cornersOf(shape));
    return [flatLight("quad", [corner, edge1, edge2], radiance, primitive, bound, normal)];
  },
  emit: (shape, _, values) => {
    const { edge1, edge2, normal, axis } = shape;
    const { middle, duals } = dualsOf(shape);
    const center = values.vec3(middle);
    if (axis) {
      const halfSize = withRim(scale(add(edge1, edge2), 0.5), middle);
      return { distance: `package::shapes::quad::quadIntersect${axis}(ray, ${center}, ${values.vec3(halfSize)})` };
    }
    const frame = [normal, ...duals].map((vector) => values.vec3(vector)).join(", ");
    const reach = values.scalar(Math.max(...duals.map(length)));
    return { distance: `package::shapes::quad::quadIntersect(ray, ${center}, ${frame}, ${reach})` };
  },
  item: {
    row: (shape) => {
      const { middle, duals } = dualsOf(shape);
      return { vectors: [middle, ...duals], w: Math.max(...duals.map(length)) };
    },
    distance: "package::shapes::quad::quadIntersect(ray, item.a, cross(item.b, item.c), item.b, item.c, item.w)",
  },
};
