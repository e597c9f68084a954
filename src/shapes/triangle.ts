import { ballAround, flatLight } from "../lights/light";
import { add, cross, dot, length, normalize, scale, subtract } from "../math/vec3";
import type { ResolvedObject, Vec3 } from "../scene/schema";
import { along } from "./along";
import { inCommonOrder, towardsMiddle } from "./rims";
import type { ShapeKind } from "./shape";

export type Triangle = {
  readonly kind: "triangle";
  readonly vertices: readonly [Vec3, Vec3, Vec3];
  /** Unit. */
  readonly normal: Vec3;
};

/** To an item of the tree that is a triangle. */
export const TRIANGLE_DISTANCE = "package::shapes::triangle::triangleIntersect(shear, item.a, item.b, item.c)";

// Twice the area, as a share of the longest edge squared, that the rounding of coordinates as written may make of a line.
const LEAST_AREA = 1e-12;

/** One without area, in f32, would be hit by rays at it, at distances that are noise. */
function hasArea({ vertices: [a, b, c] }: Triangle): boolean {
  const [edge1, edge2, edge3] = [subtract(b, a), subtract(c, a), subtract(c, b)];
  const longest = Math.max(...[edge1, edge2, edge3].map((edge) => dot(edge, edge)));
  return length(cross(edge1, edge2)) > LEAST_AREA * longest;
}

export const triangle: ShapeKind<ResolvedObject & { type: "triangle" }, Triangle> = {
  measure: (object, { point }) => {
    const [a, b, c] = object.vertices;
    return { ...object, vertices: [point(a), point(b), point(c)] };
  },
  place: ({ vertices: [a, b, c] }, { origin }) => {
    const normal = cross(subtract(b, a), subtract(c, a));
    const vertices = [subtract(a, origin), subtract(b, origin), subtract(c, origin)] as const;
    // A triangle without area is never hit, so any normal will do.
    return { kind: "triangle", vertices, normal: length(normal) > 0 ? normalize(normal) : [0, 1, 0] };
  },
  reachAlong: ({ vertices: [a, b, c] }, direction, from) =>
    Math.max(along(a, direction, from), along(b, direction, from), along(c, direction, from)),
  hull: ({ vertices }) => ({ points: vertices }),
  plane: ({ vertices, normal }) => ({ point: vertices[0], normal }),
  meeting: (shape) => (hasArea(shape) ? "bounded" : "none"),
  row: ({ normal }) => [...normal, 0],
  anchor: (shape) => {
    if (!hasArea(shape)) return [0, 0, 0, 0]; // nobody hits it
    const [a, b, c] = shape.vertices;
    const middle = scale(add(a, add(b, c)), 1 / 3);
    const sides = [subtract(b, a), subtract(c, b), subtract(a, c)];
    const longest = Math.max(...sides.map(length));
    const toEdge = length(cross(sides[0]!, sides[1]!)) / (3 * longest);
    return [...middle, towardsMiddle(middle, toEdge, longest)];
  },
  lights: ({ vertices, normal }, radiance, primitive) => {
    const [a, b, c] = vertices;
    const edges = [a, subtract(b, a), subtract(c, a)] as const;
    const light = flatLight("triangle", edges, radiance, primitive, ballAround(vertices), normal);
    return light.size > 0 ? [light] : [];
  },
  emit: ({ vertices }, _, values) => {
    const inOrder = inCommonOrder(vertices).map((vertex) => values.vec3(vertex));
    return { distance: `package::shapes::triangle::triangleIntersect(shear, ${inOrder.join(", ")})` };
  },
  item: {
    row: ({ vertices }) => ({ vectors: inCommonOrder(vertices) as [Vec3, Vec3, Vec3], w: 0 }),
    distance: TRIANGLE_DISTANCE,
  },
};
