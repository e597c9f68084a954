import { flatLight } from "../lights/light";
import { add, length, scale, subtract } from "../math/vec3";
import type { ResolvedObject, Vec3 } from "../scene/schema";
import { along } from "./along";
import { cornersBetween } from "./cornersBetween";
import type { ShapeKind } from "./shape";

export type Box = {
  readonly kind: "box";
  readonly center: Vec3;
  readonly halfSize: Vec3;
  /** Angle about Y in radians; undefined when the box is axis-aligned. */
  readonly turn: number | undefined;
};

const CORNERS = cornersBetween([-1, -1, -1], [1, 1, 1]);

function cornersOf({ center, halfSize, turn = 0 }: Box): Vec3[] {
  const [c, s] = [Math.cos(turn), Math.sin(turn)];
  return CORNERS.map(([x, y, z]): Vec3 => {
    const [dx, dy, dz] = [x * halfSize[0], y * halfSize[1], z * halfSize[2]];
    return add(center, [c * dx + s * dz, dy, c * dz - s * dx]);
  });
}

/** Corner and edges of each face, with edge1 × edge2 pointing out. */
function facesOf({ center, halfSize, turn = 0 }: Box): [Vec3, Vec3, Vec3][] {
  const [c, s] = [Math.cos(turn), Math.sin(turn)];
  const axes: Vec3[] = [scale([c, 0, -s], halfSize[0]), [0, halfSize[1], 0], scale([s, 0, c], halfSize[2])];
  return [0, 1, 2].flatMap((i) => {
    const [n, u, v] = [axes[i]!, axes[(i + 1) % 3]!, axes[(i + 2) % 3]!];
    const corner = (side: 1 | -1): Vec3 => subtract(subtract(subtract(center, scale(n, -side)), u), v);
    const [e1, e2] = [scale(u, 2), scale(v, 2)];
    return [[corner(1), e1, e2] as [Vec3, Vec3, Vec3], [corner(-1), e2, e1] as [Vec3, Vec3, Vec3]];
  });
}

export const box: ShapeKind<ResolvedObject & { type: "box" }, Box> = {
  measure: (object, { point, size }) => {
    const [x, y, z] = object.size;
    return { ...object, center: point(object.center), size: [size(x), size(y), size(z)] };
  },
  place: ({ center, size, rotationY }, { origin }) => {
    const turn = rotationY % 180 === 0 ? undefined : (rotationY * Math.PI) / 180;
    return { kind: "box", center: subtract(center, origin), halfSize: scale(size, 0.5), turn };
  },
  reachAlong: ({ center, halfSize, turn = 0 }, direction, from) => {
    const [c, s] = [Math.cos(turn), Math.sin(turn)];
    const [x, y, z] = direction;
    const [dx, dz] = [c * x - s * z, s * x + c * z]; // in the box's own frame
    const half = halfSize[0] * Math.abs(dx) + halfSize[1] * Math.abs(y) + halfSize[2] * Math.abs(dz);
    return along(center, direction, from) + half;
  },
  hull: (shape) => ({ points: cornersOf(shape) }),
  plane: () => undefined,
  meeting: () => "bounded",
  row: () => [0, 0, 0, -1],
  anchor: () => [0, 0, 0, 0],
  lights: (shape, radiance, primitive) => {
    const bound = { center: shape.center, radius: length(shape.halfSize) };
    return facesOf(shape).map((face) => flatLight("quad", face, radiance, primitive, bound));
  },
  emit: ({ center, halfSize, turn }, id, values) => {
    const body = `${values.vec3(center)}, ${values.vec3(halfSize)}`;
    const [cosine, sine] = [Math.cos(turn ?? 0), Math.sin(turn ?? 0)];
    const rotation = `vec2f(${values.scalar(cosine)}, ${values.scalar(sine)})`;
    const normal = `package::shapes::box::boxNormal(ray, p, ${body}, ${rotation}, ${id}u)`;
    if (turn === undefined) return { distance: `package::shapes::box::boxIntersect(ray, ${body}, ${id}u)`, normal };
    return { distance: `package::shapes::box::turnedBoxIntersect(ray, ${body}, ${rotation}, ${id}u)`, normal };
  },
  item: {
    row: ({ center, halfSize, turn = 0 }) => ({
      vectors: [center, halfSize, [Math.cos(turn), Math.sin(turn), 0]],
      w: 0,
    }),
    distance: "package::shapes::box::turnedBoxIntersect(ray, item.a, item.b, item.c.xy, id)",
    normal: "package::shapes::box::boxNormal(ray, p, item.a, item.b, item.c.xy, id)",
  },
};
