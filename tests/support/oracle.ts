// Ray–primitive intersection by the textbook, in doubles, over all primitives of a scene: what the shaders must find.
import type { ResolvedObject, Vec3 } from "../../src/scene/schema";

export type Meeting = {
  readonly id: number;
  /** Distance in units of the direction's length. */
  readonly t: number;
  /** |cos| between ray and surface: how much an error of the surface's place costs in t. */
  readonly cosine: number;
  /** How close to the primitive's edge, in units of its size; 0 on it. Infinite for planes. */
  readonly margin: number;
};

/** The primitive that a ray starts on, which it can meet again only from inside. */
export type Source = { readonly id: number; readonly inside: boolean };

/** All that a ray meets in front of its origin, the nearest first. */
export function meetings(objects: readonly ResolvedObject[], o: Vec3, d: Vec3, source?: Source): Meeting[] {
  const found = objects.flatMap((object, id) => {
    if (source?.id === id && !source.inside) return [];
    // A ray from the inner side has its origin on the surface, whatever rounding did to it, and the last meeting before it.
    if (source?.id === id) return farSide(object, o, d).map((meeting) => ({ ...meeting, id }));
    return intersect(object, o, d)
      .filter(({ t }) => t > 0)
      .map((meeting) => ({ ...meeting, id }));
  });
  return found.sort((a, b) => a.t - b.t);
}

function farSide(object: ResolvedObject, o: Vec3, d: Vec3): Omit<Meeting, "id">[] {
  if (object.type !== "sphere") return intersect(object, o, d).slice(-1);
  const along = -dot(subtract(o, object.center), d) / dot(d, d);
  const cosine = Math.min((Math.abs(along) * Math.hypot(...d)) / object.radius, 1);
  return [{ t: 2 * along, cosine, margin: cosine ** 2 }];
}

/** Every intersection of the line, in order of t. */
function intersect(object: ResolvedObject, o: Vec3, d: Vec3): Omit<Meeting, "id">[] {
  switch (object.type) {
    case "sphere": {
      const f = subtract(o, object.center);
      const a = dot(d, d);
      const b = dot(f, d);
      const chord = subtract(f, scale(d, b / a));
      const inside = object.radius ** 2 - dot(chord, chord);
      if (inside < 0) return [];
      const half = Math.sqrt(inside / a);
      const cosine = Math.sqrt(inside) / object.radius;
      return [-half, half].map((offset) => ({ t: -b / a + offset, cosine, margin: cosine ** 2 }));
    }
    case "plane":
      return meetPlane(object.point, object.normal, o, d).map((meeting) => ({ ...meeting, margin: Infinity }));
    case "quad": {
      const { corner, edge1, edge2 } = object;
      return meetPlane(corner, cross(edge1, edge2), o, d).flatMap((meeting) => {
        const [u, v] = coordinates(subtract(add(o, scale(d, meeting.t)), corner), edge1, edge2);
        return within({ ...meeting, margin: Math.min(u, 1 - u, v, 1 - v) });
      });
    }
    case "triangle": {
      const [a, b, c] = object.vertices;
      const [edge1, edge2] = [subtract(b, a), subtract(c, a)];
      return meetPlane(a, cross(edge1, edge2), o, d).flatMap((meeting) => {
        const [u, v] = coordinates(subtract(add(o, scale(d, meeting.t)), a), edge1, edge2);
        return within({ ...meeting, margin: Math.min(u, v, 1 - u - v) });
      });
    }
    case "box": {
      const angle = (object.rotationY * Math.PI) / 180;
      const [lo, ld] = [turnBack(subtract(o, object.center), angle), turnBack(d, angle)];
      return [0, 1, 2]
        .flatMap((axis) =>
          [-0.5, 0.5].flatMap((side) => {
            const t = (side * object.size[axis]! - lo[axis]!) / ld[axis]!;
            const margins = [0, 1, 2].map((other) =>
              other === axis ? Infinity : 0.5 - Math.abs((lo[other]! + t * ld[other]!) / object.size[other]!),
            );
            const cosine = Math.abs(ld[axis]!) / Math.hypot(...d);
            return Number.isFinite(t) ? within({ t, cosine, margin: Math.min(...margins) }) : [];
          }),
        )
        .sort((a, b) => a.t - b.t);
    }
    case "mesh":
      throw new Error("the oracle has no meshes");
  }
}

function meetPlane(point: Vec3, normal: Vec3, o: Vec3, d: Vec3): { t: number; cosine: number }[] {
  const along = dot(normal, d);
  if (along === 0) return [];
  const cosine = Math.abs(along) / (Math.hypot(...normal) * Math.hypot(...d));
  return [{ t: dot(normal, subtract(point, o)) / along, cosine }];
}

/** u and v with q = u·edge1 + v·edge2, q in their plane. */
function coordinates(q: Vec3, edge1: Vec3, edge2: Vec3): [number, number] {
  const n = cross(edge1, edge2);
  const n2 = dot(n, n);
  return [dot(cross(q, edge2), n) / n2, dot(cross(edge1, q), n) / n2];
}

function within<T extends { margin: number }>(meeting: T): T[] {
  return meeting.margin >= 0 ? [meeting] : [];
}

/** World to box: a turn by −angle about +y. */
function turnBack([x, y, z]: Vec3, angle: number): Vec3 {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return [c * x - s * z, y, s * x + c * z];
}

export const add = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (a: Vec3, k: number): Vec3 => [k * a[0], k * a[1], k * a[2]];
export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
