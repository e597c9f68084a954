// What a kind of shape is: the contract between its file and the compiler.
//
// WGSL expressions call functions of the shader module beside a kind's file by their full names, package::shapes::box::boxIntersect.

import type { Ball, Light } from "../lights/light";
import type { Measure } from "../scene/measure";
import type { Rgb, Vec3 } from "../scene/schema";

/** Where a scene's objects are put. */
export type Place = {
  /** The point of the scene that is the shader's origin. */
  readonly origin: Vec3;
  /** Distance of the camera from there: the size of what is in view. */
  readonly reach: number;
  /** Of a kind that is triangles. */
  readonly triangles?: Triangles | undefined;
};

/** What holds an object's triangles, which are in the tree, and how light sampling chooses among them. */
export type Triangles = {
  readonly lower: Vec3;
  readonly upper: Vec3;
  /** Of what emits and has an area: entries `first` to `first + count` of the geometry's table. */
  readonly light: { readonly first: number; readonly count: number; readonly area: number } | undefined;
};

/** How generated code names numbers. */
export type Numbers = {
  scalar(value: number): string;
  vec3(value: Vec3): string;
};

export type Vec4 = readonly [number, number, number, number];
export type Flat = { readonly point: Vec3; readonly normal: Vec3 };

/** What holds a shape: a ball, or the hull of some points. */
export type Hull = { readonly ball: Ball } | { readonly points: readonly Vec3[] };

/** A shape unrolled into a program. */
export type EmittedShape = {
  /** A WGSL expression for the distance at which `ray`, or `shear`, meets the shape; not positive for a miss. */
  readonly distance: string;
  /** One for the outward unit normal at `p`, of a solid. */
  readonly normal?: string;
};

/** A row of a table that the program goes through in a loop. */
export type LoopRow = { readonly point: Vec3; readonly direction: Vec3 };
/** A shape in the tree: see `Item` in `tree.wgsl`. */
export type ItemRow = { readonly vectors: readonly [Vec3, Vec3, Vec3]; readonly w: number };

/**
 * A kind of shape.
 *
 * @typeParam O - the scene's object.
 * @typeParam S - the shape, relative to the shader's origin.
 */
export type ShapeKind<O, S> = {
  /** Of meshes, whose triangles go into the tree: a WGSL expression of `shear` and `item`. */
  readonly triangleDistance?: string;
  /** The same object in another unit of length. */
  readonly measure: (object: O, to: Measure) => O;
  readonly place: (object: O, place: Place) => S;
  /**
   * How far it reaches along a direction: the greatest dot(p − from, direction) over its points p; infinite without bounds. It
   * allocates nothing, because it runs for every shape of a scene whenever the camera moves.
   */
  readonly reachAlong: (shape: S, direction: Vec3, from: Vec3) => number;
  /** Reaches as far as the shape in every direction; undefined without bounds. */
  readonly hull: (shape: S) => Hull | undefined;
  /** A plane that holds all of it, if it is flat. */
  readonly plane: (shape: S) => Flat | undefined;
  /** How rays meet it: in code of its own or in the tree; in code of its own or in a loop; never, or by other means. */
  readonly meeting: (shape: S) => "bounded" | "loop" | "none";
  /**
   * Its row in `scene.shapes`. Unit normal and 0: flat. Centre and radius > 0: a ball. Last -1: a solid, whose normal depends on
   * the point, or a mesh. Points that rays find are put back onto what is flat and onto balls, not onto solids; and of a solid the ray
   * meets the outside where it comes against the normal.
   */
  readonly row: (shape: S) => Vec4;
  /**
   * Its row in `scene.anchors`: a point on a flat shape, its middle if it has one, and the factor by which points on it are drawn
   * there; the foot of a huge sphere and 1; else zeros.
   */
  readonly anchor: (shape: S) => Vec4;
  /** What next-event estimation samples where it emits `radiance` and is the primitive of that number. */
  readonly lights: (shape: S, radiance: Rgb, primitive: number) => Light[];
  /** Its test, with its values unrolled into the program; `id` is what a ray names that starts on it. Absent if never met so. */
  readonly emit?: (shape: S, id: number, values: Numbers) => EmittedShape;
  /** As one of many in a loop over `scene.<table>`. */
  readonly loop?: {
    readonly table: string;
    readonly row: (shape: S) => LoopRow;
    /** A WGSL expression of `ray` and `row`, which has an `id` too. */
    readonly distance: string;
  };
  /** As one of many in the tree. */
  readonly item?: {
    readonly row: (shape: S) => ItemRow;
    /** WGSL expressions of `ray`, `shear`, `item` and `id`, and for a solid of `p`. */
    readonly distance: string;
    readonly normal?: string;
  };
};
