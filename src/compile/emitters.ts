import type { ResolvedScene, Rgb, Vec3 } from "../scene/schema";
import type { Primitive, Shape } from "./primitives";
import { cross, length, scale, subtract } from "./vec3";

/** Kinds of emitter, by their number in `wgsl/lights.wgsl`. */
export const LIGHT_KINDS = { sphere: 0, quad: 1, triangle: 2, point: 3 } as const;
export type LightKind = keyof typeof LIGHT_KINDS;

/** An emitter that next-event estimation samples. */
export type Emitter = {
  readonly kind: LightKind;
  /** Centre of a sphere, corner of a quad or triangle, position of a point. */
  readonly position: Vec3;
  /** Radius of a sphere, area of a quad or triangle; 0 for a point. */
  readonly size: number;
  readonly edge1: Vec3;
  readonly edge2: Vec3;
  /** Radiance; intensity of a point. */
  readonly radiance: Rgb;
  /** Index of the primitive that carries the emission; undefined for a point. */
  readonly primitive: number | undefined;
  /** Probability of being chosen; all emitters together sum to 1. */
  readonly probability: number;
};

type Candidate = Omit<Emitter, "probability"> & { readonly power: number };

/**
 * Everything that emits and can be sampled, chosen in proportion to its power, or evenly by the baseline estimator.
 * A box is six quads. Infinite planes emit too, but have no area to sample: their light is found by scattered rays.
 */
export function emittersOf(
  scene: ResolvedScene,
  primitives: readonly Primitive[],
  origin: Vec3,
  choice: "power" | "even",
): Emitter[] {
  const candidates = [
    ...primitives.flatMap((primitive, index) =>
      isEmissive(primitive) ? surfaceEmitters(primitive.shape, primitive.emission, index) : [],
    ),
    ...scene.lights.flatMap((light): Candidate[] =>
      light.type === "point"
        ? [
            {
              ...NO_EDGES,
              kind: "point",
              position: subtract(light.position, origin),
              size: 0,
              radiance: scale(light.power, 1 / (4 * Math.PI)),
              primitive: undefined,
              power: sum(light.power),
            },
          ]
        : [],
    ),
  ];
  const total = candidates.reduce((power, candidate) => power + candidate.power, 0);
  return candidates.map(({ power, ...emitter }) => ({
    ...emitter,
    probability: choice === "power" && total > 0 ? power / total : 1 / candidates.length,
  }));
}

/** Lights are emitters even at power 0, so that turning one down does not change the program. */
function isEmissive(primitive: Primitive): boolean {
  return primitive.material === "black" || sum(primitive.emission) > 0;
}

const NO_EDGES = { edge1: [0, 0, 0], edge2: [0, 0, 0] } as const;

function surfaceEmitters(shape: Shape, radiance: Rgb, primitive: number): Candidate[] {
  switch (shape.kind) {
    case "sphere": {
      const { center: position, radius: size } = shape;
      const power = sum(radiance) * 4 * Math.PI ** 2 * size ** 2;
      return [{ ...NO_EDGES, kind: "sphere", position, size, radiance, primitive, power }];
    }
    case "quad":
      return [flat("quad", shape.corner, shape.edge1, shape.edge2, radiance, primitive)];
    case "triangle": {
      const [a, b, c] = shape.vertices;
      const emitter = flat("triangle", a, subtract(b, a), subtract(c, a), radiance, primitive);
      return emitter.size > 0 ? [emitter] : [];
    }
    case "box":
      return boxFaces(shape).map(([corner, edge1, edge2]) => flat("quad", corner, edge1, edge2, radiance, primitive));
    case "plane":
      return [];
  }
}

function flat(
  kind: "quad" | "triangle",
  position: Vec3,
  edge1: Vec3,
  edge2: Vec3,
  radiance: Rgb,
  primitive: number,
): Candidate {
  const size = length(cross(edge1, edge2)) * (kind === "quad" ? 1 : 0.5);
  return { kind, position, size, edge1, edge2, radiance, primitive, power: sum(radiance) * Math.PI * size };
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

function sum(rgb: Rgb): number {
  return rgb[0] + rgb[1] + rgb[2];
}
