import type { Vec3 } from "../scene/schema";
import type { Emitter } from "./emitters";
import type { Primitive, Shape } from "./primitives";
import { add, dot, scale, subtract } from "./vec3";

/**
 * Whether a primitive can come between a shaded point and a light. A flat one cannot if everything that light sampling
 * connects lies on one side of it: the walls of a room, a ground plane.
 *
 * @param camera - relative to the compiled scene's origin. Nothing crosses an infinite plane, so behind one that has the
 * camera and all lights in front, nothing is ever shaded.
 */
export function canBlock(
  id: number,
  primitives: readonly Primitive[],
  emitters: readonly Emitter[],
  camera: Vec3,
): boolean {
  const { shape } = primitives[id]!;
  if (shape.kind === "sphere" || shape.kind === "box" || shape.kind === "mesh") return true;
  const point = pointOn(shape);
  const side = (p: Vec3) => dot(subtract(p, point), shape.normal);

  if (shape.kind === "plane")
    return !areOnOneSide([camera, ...emitters.flatMap(extentOfEmitter(shape.normal))].map(side));
  const others = primitives.filter((_, other) => other !== id).map((primitive) => primitive.shape);
  if (others.some((other) => other.kind === "plane")) return true;
  const points = emitters.filter((emitter) => emitter.kind === "point").map((emitter) => emitter.position);
  return !areOnOneSide([...others.flatMap((other) => extent(other, shape.normal)), ...points].map(side));
}

/** Rounding of the positions a user writes may put a touching shape this far, in proportion, beyond a plane. */
const TOUCHING = 1e-12;

function areOnOneSide(distances: readonly number[]): boolean {
  const tolerance = TOUCHING * Math.max(...distances.map(Math.abs));
  return distances.every((d) => d >= -tolerance) || distances.every((d) => d <= tolerance);
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

function extentOfEmitter(normal: Vec3): (emitter: Emitter) => Vec3[] {
  return ({ kind, position, size, edge1, edge2, bound }) => {
    if (kind === "point") return [position];
    if (kind === "mesh") return extent({ kind: "sphere", ...bound }, normal);
    if (kind === "sphere") return extent({ kind, center: position, radius: size }, normal);
    return [position, add(position, edge1), add(position, edge2), add(add(position, edge1), edge2)];
  };
}

function corners({ center, halfSize, turn = 0 }: Shape & { kind: "box" }): Vec3[] {
  const [c, s] = [Math.cos(turn), Math.sin(turn)];
  return CORNERS.map(([x, y, z]): Vec3 => {
    const [dx, dy, dz] = [x * halfSize[0], y * halfSize[1], z * halfSize[2]];
    return add(center, [c * dx + s * dz, dy, c * dz - s * dx]);
  });
}

const CORNERS = [-1, 1].flatMap((x) => [-1, 1].flatMap((y) => [-1, 1].map((z): Vec3 => [x, y, z])));

function pointOn(shape: Shape & { kind: "plane" | "quad" | "triangle" }): Vec3 {
  if (shape.kind === "plane") return shape.point;
  return shape.kind === "quad" ? shape.corner : shape.vertices[0];
}
