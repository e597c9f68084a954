import { add, dot, scale, subtract } from "../math/vec3";
import type { Vec3 } from "../scene/schema";
import type { Emitter } from "./emitters";
import type { Primitive, Shape } from "./primitives";
import { reachAlong } from "./reach";

/**
 * Tells which primitives can come between a shaded point and a light. A flat one cannot if everything that light sampling
 * connects lies on one side of it: the walls of a room, a ground plane.
 *
 * Only planes depend on where the camera is. What else it takes is found out once per primitive, so that a moving camera costs
 * a comparison per plane.
 */
export class Blockers {
  readonly #primitives: readonly Primitive[];
  /** What light comes from: the shapes that are sampled, and points as balls of radius 0. */
  readonly #lights: readonly Shape[];
  readonly #points: readonly Shape[];
  readonly #hasPlanes: boolean;
  /** By primitive: whether a bounded one can block, or the range of the lights' distances in front of a plane. */
  readonly #bounded = new Map<number, boolean>();
  readonly #ranges = new Map<number, Range>();

  constructor(primitives: readonly Primitive[], emitters: readonly Emitter[]) {
    this.#primitives = primitives;
    this.#hasPlanes = primitives.some(({ shape }) => shape.kind === "plane");
    const sampled = new Set<number>();
    const points: Shape[] = [];
    for (const { primitive, position } of emitters) {
      if (primitive === undefined) points.push({ kind: "sphere", center: position, radius: 0 });
      else sampled.add(primitive);
    }
    this.#points = points;
    this.#lights = [...points, ...Array.from(sampled, (id) => primitives[id]!.shape)];
  }

  /**
   * Whether primitive `id` can block.
   *
   * @param camera - relative to the compiled scene's origin. Nothing crosses an infinite plane, so behind one that has the
   * camera and all lights in front, nothing is ever shaded.
   */
  canBlock(id: number, camera: Vec3): boolean {
    const { shape } = this.#primitives[id]!;
    if (shape.kind === "plane") {
      const range = remembered(this.#ranges, id, () => rangeOf(this.#lights, shape.point, shape.normal));
      const side = dot(subtract(camera, shape.point), shape.normal);
      return !isOnOneSide({ least: Math.min(range.least, side), most: Math.max(range.most, side) });
    }
    if (shape.kind !== "quad" && shape.kind !== "triangle") return true;
    return remembered(this.#bounded, id, () => {
      if (this.#hasPlanes) return true;
      const point = shape.kind === "quad" ? shape.corner : shape.vertices[0];
      return !isOnOneSide(rangeOf(this.#others(id), point, shape.normal));
    });
  }

  *#others(id: number): Generator<Shape> {
    for (const [other, { shape }] of this.#primitives.entries()) if (other !== id) yield shape;
    yield* this.#points;
  }
}

/** Least and most distance in front of a plane; infinite for nothing. */
type Range = { readonly least: number; readonly most: number };

function rangeOf(shapes: Iterable<Shape>, point: Vec3, normal: Vec3): Range {
  const opposite = scale(normal, -1);
  let [least, most] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (const shape of shapes) {
    least = Math.min(least, -reachAlong(shape, opposite, point));
    most = Math.max(most, reachAlong(shape, normal, point));
  }
  return { least, most };
}

/** Rounding of the positions a user writes may put a touching shape this far, in proportion, beyond a plane. */
const TOUCHING = 1e-12;

function isOnOneSide({ least, most }: Range): boolean {
  if (least > most) return true; // of nothing
  const tolerance = TOUCHING * Math.max(Math.abs(least), Math.abs(most));
  return least >= -tolerance || most <= tolerance;
}

function remembered<V>(known: Map<number, V>, id: number, find: () => V): V {
  const value = known.get(id) ?? find();
  known.set(id, value);
  return value;
}

/** The points of a bounded shape that lie farthest along ±normal. */
export function extent(shape: Shape, normal: Vec3): Vec3[] {
  switch (shape.kind) {
    case "sphere":
      return [add(shape.center, scale(normal, shape.radius)), subtract(shape.center, scale(normal, shape.radius))];
    case "quad": {
      const { corner, edge1, edge2 } = shape;
      return [corner, add(corner, edge1), add(corner, edge2), add(add(corner, edge1), edge2)];
    }
    case "triangle":
      return [...shape.vertices];
    case "box":
      return corners(shape);
    case "mesh": {
      const bounds = [shape.lower, shape.upper];
      return bounds.flatMap(([x]) => bounds.flatMap(([, y]) => bounds.map(([, , z]): Vec3 => [x, y, z])));
    }
    case "plane":
      throw new RangeError("a plane has no extent");
  }
}

function corners({ center, halfSize, turn = 0 }: Shape & { kind: "box" }): Vec3[] {
  const [c, s] = [Math.cos(turn), Math.sin(turn)];
  return CORNERS.map(([x, y, z]): Vec3 => {
    const [dx, dy, dz] = [x * halfSize[0], y * halfSize[1], z * halfSize[2]];
    return add(center, [c * dx + s * dz, dy, c * dz - s * dx]);
  });
}

const CORNERS = [-1, 1].flatMap((x) => [-1, 1].flatMap((y) => [-1, 1].map((z): Vec3 => [x, y, z])));
