import type { Ball, Light } from "../lights/light";
import { isDistant } from "../lights/lights";
import { scattersBelow } from "../lobes/lobes";
import { dot, scale, subtract } from "../math/vec3";
import type { Vec3 } from "../scene/schema";
import { along } from "../shapes/along";
import { hullOf, kindOf, reachAlong, type Shape } from "../shapes/shapes";
import type { Primitive } from "./primitives";

/**
 * Tells which primitives can come between a shaded point and a light. A flat one cannot if everything that light sampling
 * connects lies on one side of it: the walls of a room, a ground plane. Towards a light that is infinitely far, it must not be looked
 * through from that side either.
 *
 * Only infinite ones depend on where the camera is. What else it takes is found out once per primitive, so that a moving camera
 * costs a comparison per plane.
 */
export class Blockers {
  readonly #primitives: readonly Primitive[];
  /** Where light comes from: the shapes that are sampled, and what holds lights without one. */
  readonly #lights: readonly Body[];
  readonly #balls: readonly Ball[];
  /** What holds the directions to lights that are infinitely far, on the unit sphere. */
  readonly #sky: readonly Ball[];
  readonly #isBounded: boolean;
  /** By primitive: whether a bounded one can block, or the range of the lights' distances in front of an infinite one. */
  readonly #bounded = new Map<number, boolean>();
  readonly #ranges = new Map<number, Range>();

  constructor(primitives: readonly Primitive[], lights: readonly Light[]) {
    this.#primitives = primitives;
    this.#isBounded = primitives.every(({ shape }) => hullOf(shape) !== undefined);
    const sampled = new Set<number>();
    const balls: Ball[] = [];
    const sky: Ball[] = [];
    for (const light of lights) {
      const { primitive, bound } = light;
      if (isDistant(light)) sky.push(bound);
      else if (primitive === undefined) balls.push(bound);
      else sampled.add(primitive);
    }
    this.#balls = balls;
    this.#sky = sky;
    this.#lights = [...balls, ...Array.from(sampled, (id) => primitives[id]!.shape)];
  }

  /**
   * Whether primitive `id` can block.
   *
   * @param camera - relative to the compiled scene's origin. Nothing crosses an infinite plane that lets no light through, so
   * behind one that has the camera and all lights in front, nothing is ever shaded.
   * @param reach - how far from there camera rays may start.
   */
  canBlock(id: number, camera: Vec3, reach = 0): boolean {
    const { shape, material } = this.#primitives[id]!;
    const flat = kindOf(shape).plane(shape);
    if (!flat) return true;
    const { point, normal } = flat;
    if (hullOf(shape) === undefined) {
      if (!Number.isFinite(reach) || (material !== "black" && scattersBelow(material))) return true;
      const range = remembered(this.#ranges, id, () => rangeOf(this.#lights, point, normal));
      const side = dot(subtract(camera, point), normal);
      const bodies = { least: Math.min(range.least, side - reach), most: Math.max(range.most, side + reach) };
      return !isOnOneSide(bodies, rangeOf(this.#sky, ORIGIN, normal));
    }
    return remembered(this.#bounded, id, () => {
      if (!this.#isBounded) return true;
      return !isOnOneSide(rangeOf(this.#others(id), point, normal), rangeOf(this.#sky, ORIGIN, normal));
    });
  }

  *#others(id: number): Generator<Body> {
    for (const [other, { shape }] of this.#primitives.entries()) if (other !== id) yield shape;
    yield* this.#balls;
  }
}

type Body = Shape | Ball;

/** Least and most distance in front of a plane; infinite for nothing. */
type Range = { readonly least: number; readonly most: number };

function rangeOf(bodies: Iterable<Body>, point: Vec3, normal: Vec3): Range {
  const opposite = scale(normal, -1);
  let [least, most] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (const body of bodies) {
    least = Math.min(least, -reachOf(body, opposite, point));
    most = Math.max(most, reachOf(body, normal, point));
  }
  return { least, most };
}

function reachOf(body: Body, direction: Vec3, from: Vec3): number {
  if ("kind" in body) return reachAlong(body, direction, from);
  return along(body.center, direction, from) + body.radius;
}

/** Rounding of the positions a user writes may put a touching shape this far, in proportion, beyond a plane. */
const TOUCHING = 1e-12;

/** Directions less steep than this, a few ULP, may be rounded to the other side of a plane. */
const SLANT = 1e-6;

const ORIGIN: Vec3 = [0, 0, 0];

/** @param sky - the range of directions to lights that are infinitely far. */
function isOnOneSide({ least, most }: Range, sky: Range): boolean {
  if (least > most) return true; // of nothing
  const tolerance = TOUCHING * Math.max(Math.abs(least), Math.abs(most));
  return (least >= -tolerance && sky.least > SLANT) || (most <= tolerance && sky.most < -SLANT);
}

function remembered<V>(known: Map<number, V>, id: number, find: () => V): V {
  const value = known.get(id) ?? find();
  known.set(id, value);
  return value;
}
