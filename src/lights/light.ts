import { add, cross, length, normalize, scale, subtract } from "../math/vec3";
import type { Measure } from "../scene/measure";
import type { ResolvedObject, Rgb, Vec3 } from "../scene/schema";

/** What holds something. */
export type Ball = { readonly center: Vec3; readonly radius: number };

/** Something that emits and that next-event estimation samples; `Light` in `light.wgsl`. */
export type Light = {
  /** How it is sampled: a name in `lights.ts`. */
  readonly kind: string;
  /**
   * Centre of a sphere, corner of a quad or triangle, position of a point; of a mesh, first and number of its triangles in the
   * geometry's table of those that emit.
   */
  readonly position: Vec3;
  /** Radius of a sphere or spot, area of a quad, triangle or mesh; 0 for a point; 1 − cos of the angular radius of what is infinitely far. */
  readonly size: number;
  /** Of a quad or triangle; what another kind's shader module makes of them. */
  readonly edge1: Vec3;
  readonly edge2: Vec3;
  /** Of the side that a flat light shines to, unit; zero of other kinds, or what theirs make of it. */
  readonly normal: Vec3;
  /** Radiance; of what has no area intensity, or irradiance if it is infinitely far. */
  readonly radiance: Rgb;
  /** Index of the primitive that carries the emission; undefined where no ray can hit the light. */
  readonly primitive: number | undefined;
  /** Intensity along the normal, or in all directions, or irradiance: what the choice of a light goes by. */
  readonly strength: number;
  /** The side that it shines to, unit; undefined where light leaves in all directions, as from a box's faces together. */
  readonly front: Vec3 | undefined;
  /**
   * Around all lights of the primitive, which share this object; their strengths are in proportion to their sizes. Of a light that is
   * infinitely far: around the directions to it, on the unit sphere.
   */
  readonly bound: Ball;
};

const NO_VECTOR: Vec3 = [0, 0, 0];

/** What a light without edges that shines in all directions has for a side. */
export const ALL_ROUND = { edge1: NO_VECTOR, edge2: NO_VECTOR, normal: NO_VECTOR, front: undefined } as const;

/** One that shines to the side of edge1 × edge2. */
export function flatLight(
  kind: "quad" | "triangle",
  [position, edge1, edge2]: readonly [Vec3, Vec3, Vec3],
  radiance: Rgb,
  primitive: number,
  bound: Ball,
  front?: Vec3,
): Light {
  const area = cross(edge1, edge2);
  const size = length(area) * (kind === "quad" ? 1 : 0.5);
  const normal = size > 0 ? normalize(area) : area;
  const strength = sum(radiance) * size;
  return { kind, position, size, edge1, edge2, normal, radiance, primitive, strength, front, bound };
}

/** A flat light that shines to the other side. */
export function turned(light: Light): Light {
  return { ...light, edge1: light.edge2, edge2: light.edge1, normal: scale(light.normal, -1) };
}

/** The ball around the mean of some points that holds them all. */
export function ballAround(points: readonly Vec3[]): Ball {
  const center = scale(
    points.reduce((total, point) => add(total, point)),
    1 / points.length,
  );
  return { center, radius: Math.max(...points.map((point) => length(subtract(point, center)))) };
}

export function sum(rgb: Rgb): number {
  return rgb[0] + rgb[1] + rgb[2];
}

/** How a point on a light is drawn. */
export type LightSampler = {
  /**
   * A WGSL expression, of functions by their full names, for a `LightSample` of radiance 1, of the point `p` that is lit, the `light`, a random point `u` of the
   * unit square and, for a light of many parts, another one, `pick`.
   */
  readonly sample: string;
  /** The same for the baseline estimator, where that draws otherwise. */
  readonly baseline?: string;
  /**
   * How dense samples are: uniform on the area; uniform in the cone that a ball fills, where `sphereLightPdf` tells how dense; or
   * never where a ray could go.
   */
  readonly measure: "area" | "cone" | "none";
};

/** A kind of light that `sampler` samples: surfaces that emit, or lights of a scene's list. */
export type LightKind = {
  readonly sampler: LightSampler;
  /**
   * Whether it is infinitely far: it shines from all points of its `bound` on the unit sphere, and rays that escape find it if its size is
   * above 0.
   */
  readonly isDistant?: true;
  /** The same light shining from its other side, of a kind that shines from one. */
  readonly turn?: (light: Light) => Light;
};

/** A kind of light in a scene's list of them. */
export type SceneLight<L> = LightKind & {
  /** The same light in another unit of length. */
  readonly measure: (light: L, to: Measure) => L;
  /** The black object, of some material, that shines for it with a radiance: rays can hit it. */
  readonly body?: (light: L) => { readonly body: ResolvedObject; readonly radiance: Rgb };
  /** What next-event estimation samples of a light without a body, relative to the shader's origin. */
  readonly lights?: (light: L, origin: Vec3) => Light[];
};
