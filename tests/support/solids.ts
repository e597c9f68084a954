// Closed boxes made of flat pieces, for rays to leak through.
import type { SceneObject, Vec3 } from "../../src/scene/schema";
import { add, cross, scale } from "./oracle";

/** A box in any orientation: its middle and half edges, which are right-handed and at right angles. */
export type Solid = { readonly middle: Vec3; readonly half: readonly [Vec3, Vec3, Vec3] };

/** Sides unequal and coordinates with long fractions: nothing about it is exact in f32. */
export function solid(middle: Vec3, isTurned: boolean, size = 1): Solid {
  const axes: [Vec3, Vec3, Vec3] = isTurned
    ? orthogonal([0.3, 0.8, -0.51], [0.7, -0.2, 0.4])
    : [
        [1, 0, 0],
        [0, 1, 0],
        [0, 0, 1],
      ];
  const [a, b, c] = axes;
  return { middle, half: [scale(a, 0.85 * size), scale(b, 0.55 * size), scale(c, 1.15 * size)] };
}

/** The corner at the given sides, each −1 or 1. */
export function corner({ middle, half }: Solid, sides: readonly number[]): Vec3 {
  return half.reduce<Vec3>((sum, edge, i) => add(sum, scale(edge, sides[i]!)), middle);
}

/** Twelve triangles, or six quads; outward fronts. */
export function pieces(box: Solid, kind: "triangles" | "quads"): SceneObject[] {
  const material = "lambert";
  return [0, 1, 2].flatMap((axis) =>
    [-1, 1].flatMap((side): SceneObject[] => {
      const at = (u: number, v: number) => {
        const sides = [0, 0, 0];
        sides[axis] = side;
        sides[(axis + 1) % 3] = u * side;
        sides[(axis + 2) % 3] = v;
        return corner(box, sides);
      };
      const [a, b, c, d] = [at(-1, -1), at(1, -1), at(1, 1), at(-1, 1)];
      if (kind === "quads") {
        return [{ type: "quad", corner: a, edge1: add(b, scale(a, -1)), edge2: add(d, scale(a, -1)), material }];
      }
      return [
        { type: "triangle", vertices: [a, b, c], material },
        { type: "triangle", vertices: [a, c, d], material },
      ];
    }),
  );
}

function orthogonal(x: Vec3, towards: Vec3): [Vec3, Vec3, Vec3] {
  const a = unit(x);
  const c = unit(cross(a, towards));
  return [a, cross(c, a), c];
}

export function unit(v: Vec3): Vec3 {
  return scale(v, 1 / Math.hypot(...v));
}
