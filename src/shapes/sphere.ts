import { ALL_ROUND, sum } from "../lights/light";
import { length, scale, subtract } from "../math/vec3";
import type { ResolvedObject, Vec3 } from "../scene/schema";
import { along } from "./along";
import type { ShapeKind } from "./shape";

export type Sphere = {
  readonly kind: "sphere";
  readonly center: Vec3;
  readonly radius: number;
  /** Of a sphere that is huge against what is in view: its point nearest to the origin, exact where the centre is not. */
  readonly foot?: Vec3;
};

// Coordinates relative to a sphere's centre lose digits against those relative to what is in view as soon as that is smaller:
// at 64 a horizon seen through a lens of 0.04° was 0.07 of a pixel too high. Nearer to 1 the other way loses a bit.
const HUGE = 1.5;

export const sphere: ShapeKind<ResolvedObject & { type: "sphere" }, Sphere> = {
  measure: (object, { point, size }) => ({ ...object, center: point(object.center), radius: size(object.radius) }),
  place: ({ center: place, radius }, { origin, reach }) => {
    const center = subtract(place, origin);
    const distance = length(center);
    const isHuge = radius > HUGE * Math.max(Math.abs(distance - radius), reach);
    return { kind: "sphere", center, radius, ...(isHuge && { foot: scale(center, 1 - radius / distance) }) };
  },
  reachAlong: ({ center, radius }, direction, from) => along(center, direction, from) + radius,
  hull: (ball) => ({ ball }),
  plane: () => undefined,
  // The tree has no room for the point on a huge sphere that it is measured from.
  meeting: ({ foot }) => (foot ? "loop" : "bounded"),
  row: ({ center, radius }) => [...center, radius],
  anchor: ({ foot }) => (foot ? [...foot, 1] : [0, 0, 0, 0]),
  lights: ({ center: position, radius: size }, radiance, primitive) => {
    const strength = sum(radiance) * Math.PI * size ** 2;
    const bound = { center: position, radius: size };
    return [{ ...ALL_ROUND, kind: "sphere", position, size, radiance, primitive, strength, bound }];
  },
  emit: ({ center, radius, foot }, id, values) => {
    if (foot) {
      const [at, spoke] = [foot, subtract(foot, center)].map((vector) => values.vec3(vector));
      return { distance: `package::shapes::sphere::hugeSphereIntersect(ray, ${at}, ${spoke}, ${id}u)` };
    }
    return {
      distance: `package::shapes::sphere::sphereIntersect(ray, ${values.vec3(center)}, ${values.scalar(radius)}, ${id}u)`,
    };
  },
  loop: {
    table: "hugeSpheres",
    row: ({ center, foot = center }) => ({ point: foot, direction: subtract(foot, center) }),
    distance: "package::shapes::sphere::hugeSphereIntersect(ray, row.point, row.direction, row.id)",
  },
  item: {
    row: ({ center, radius }) => ({ vectors: [center, [0, 0, 0], [0, 0, 0]], w: radius }),
    distance: "package::shapes::sphere::sphereIntersect(ray, item.a, item.w, id)",
  },
};
