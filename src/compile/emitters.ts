import { add, cross, length, normalize, scale, subtract } from "../math/vec3";
import type { ResolvedLight, ResolvedScene, Rgb, Vec3 } from "../scene/schema";
import type { Primitive, Shape } from "./primitives";

/** Kinds of emitter, by their number in `wgsl/lights.wgsl`. */
export const LIGHT_KINDS = { sphere: 0, quad: 1, triangle: 2, point: 3, mesh: 4 } as const;
export type LightKind = keyof typeof LIGHT_KINDS;

/** An emitter that next-event estimation samples. */
export type Emitter = {
  readonly kind: LightKind;
  /**
   * Centre of a sphere, corner of a quad or triangle, position of a point; of a mesh, first and number of its triangles in the
   * geometry's table of those that shine.
   */
  readonly position: Vec3;
  /** Radius of a sphere, area of a quad, triangle or mesh; 0 for a point. */
  readonly size: number;
  readonly edge1: Vec3;
  readonly edge2: Vec3;
  /** Of the side that a quad or triangle shines to, unit; zero of other kinds. */
  readonly normal: Vec3;
  /** Radiance; intensity of a point. */
  readonly radiance: Rgb;
  /** Index of the primitive that carries the emission; undefined for a point. */
  readonly primitive: number | undefined;
  /** Intensity along the normal, or in all directions, in proportion to the strongest's. What the choice of a light goes by. */
  readonly strength: number;
  /** The side that a flat primitive shines to; undefined where light leaves in all directions, as from a box's faces together. */
  readonly front: Vec3 | undefined;
  /** A ball around all of the primitive's emitters. */
  readonly bound: { readonly center: Vec3; readonly radius: number };
};

/**
 * Everything that emits and can be sampled. A box is six quads. Infinite planes emit too, but have no area to sample: their
 * light is found by scattered rays.
 */
export function emittersOf(scene: ResolvedScene, primitives: readonly Primitive[], origin: Vec3): Emitter[] {
  const emitters: Weighed[] = [];
  for (const [index, primitive] of primitives.entries()) {
    if (!isEmissive(primitive)) continue;
    for (const emitter of surfaceEmitters(primitive.shape, primitive.emission, index)) emitters.push(emitter);
  }
  for (const light of scene.lights) if (light.type === "point") emitters.push(pointEmitter(light, origin));
  let strongest = 0;
  for (const { strength } of emitters) strongest = Math.max(strongest, strength);
  if (strongest > 0) for (const emitter of emitters) emitter.strength /= strongest;
  return emitters;
}

/** An emitter whose strength is still to be put in proportion. */
type Weighed = Omit<Emitter, "strength"> & { strength: number };

function pointEmitter(light: ResolvedLight & { type: "point" }, origin: Vec3): Weighed {
  const position = subtract(light.position, origin);
  const radiance = scale(light.power, 1 / (4 * Math.PI));
  return {
    kind: "point",
    position,
    size: 0,
    edge1: NO_VECTOR,
    edge2: NO_VECTOR,
    normal: NO_VECTOR,
    radiance,
    primitive: undefined,
    strength: sum(radiance),
    front: undefined,
    bound: { center: position, radius: 0 },
  };
}

/** Lights are emitters even at power 0, so that turning one down does not change the program. */
export function isEmissive(primitive: Primitive): boolean {
  return primitive.material === "black" || sum(primitive.emission) > 0;
}

const NO_VECTOR: Vec3 = [0, 0, 0];

function surfaceEmitters(shape: Shape, radiance: Rgb, primitive: number): Weighed[] {
  switch (shape.kind) {
    case "sphere": {
      const { center: position, radius: size } = shape;
      const strength = sum(radiance) * Math.PI * size ** 2;
      const bound = { center: position, radius: size };
      return [curved("sphere", position, size, radiance, primitive, strength, bound)];
    }
    case "quad": {
      const { corner, edge1, edge2 } = shape;
      const bound = ballAround([corner, add(corner, edge1), add(corner, edge2), add(add(corner, edge1), edge2)]);
      return [flat("quad", corner, edge1, edge2, radiance, primitive, bound, shape.normal)];
    }
    case "triangle": {
      const [a, b, c] = shape.vertices;
      const bound = ballAround(shape.vertices);
      const emitter = flat("triangle", a, subtract(b, a), subtract(c, a), radiance, primitive, bound, shape.normal);
      return emitter.size > 0 ? [emitter] : [];
    }
    case "box": {
      const bound = { center: shape.center, radius: length(shape.halfSize) };
      return boxFaces(shape).map((face) => flat("quad", ...face, radiance, primitive, bound));
    }
    case "mesh": {
      const { lower, upper, lamp } = shape;
      if (!lamp) return [];
      const bound = { center: scale(add(lower, upper), 0.5), radius: length(subtract(upper, lower)) / 2 };
      // Of a closed surface, or of any seen from any side, a quarter of the area shows on average.
      const strength = (sum(radiance) * lamp.area) / 4;
      const position: Vec3 = [lamp.first, lamp.count, 0];
      return [curved("mesh", position, lamp.area, radiance, primitive, strength, bound)];
    }
    case "plane":
      return [];
  }
}

function curved(
  kind: "sphere" | "mesh",
  position: Vec3,
  size: number,
  radiance: Rgb,
  primitive: number,
  strength: number,
  bound: Emitter["bound"],
): Weighed {
  const [edge1, edge2, normal] = [NO_VECTOR, NO_VECTOR, NO_VECTOR];
  return { kind, position, size, edge1, edge2, normal, radiance, primitive, strength, front: undefined, bound };
}

function flat(
  kind: "quad" | "triangle",
  position: Vec3,
  edge1: Vec3,
  edge2: Vec3,
  radiance: Rgb,
  primitive: number,
  bound: Emitter["bound"],
  front?: Vec3,
): Weighed {
  const area = cross(edge1, edge2);
  const size = length(area) * (kind === "quad" ? 1 : 0.5);
  const normal = size > 0 ? normalize(area) : area;
  const strength = sum(radiance) * size;
  return { kind, position, size, edge1, edge2, normal, radiance, primitive, strength, front, bound };
}

/** Corner and edges of each face, with edge1 × edge2 pointing out. */
function boxFaces({ center, halfSize, turn = 0 }: Shape & { kind: "box" }): [Vec3, Vec3, Vec3][] {
  const [c, s] = [Math.cos(turn), Math.sin(turn)];
  const axes: Vec3[] = [scale([c, 0, -s], halfSize[0]), [0, halfSize[1], 0], scale([s, 0, c], halfSize[2])];
  return [0, 1, 2].flatMap((i) => {
    const [n, u, v] = [axes[i]!, axes[(i + 1) % 3]!, axes[(i + 2) % 3]!];
    const corner = (side: 1 | -1): Vec3 => subtract(subtract(subtract(center, scale(n, -side)), u), v);
    const [e1, e2] = [scale(u, 2), scale(v, 2)];
    return [[corner(1), e1, e2] as [Vec3, Vec3, Vec3], [corner(-1), e2, e1] as [Vec3, Vec3, Vec3]];
  });
}

/** The ball around the mean of some points that holds them all. */
function ballAround(points: readonly Vec3[]): Emitter["bound"] {
  const center = scale(
    points.reduce((total, point) => add(total, point)),
    1 / points.length,
  );
  return { center, radius: Math.max(...points.map((point) => length(subtract(point, center)))) };
}

function sum(rgb: Rgb): number {
  return rgb[0] + rgb[1] + rgb[2];
}
