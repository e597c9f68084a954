type Point = readonly [x: number, y: number];

/** A way round the axis, of which the profile's distance from the axis is the size. */
export type Outline = (turn: number) => Point;

const STEP = 1e-4; // of a turn: its square is lost in f32

/** x and z on the unit circle. */
export const circle: Outline = (turn) => [Math.cos(2 * Math.PI * turn), Math.sin(2 * Math.PI * turn)];

/** Between a circle and the square around it: 2 is the circle, 5 the foot of a bottle. */
export function squircle(exponent: number): Outline {
  return (turn) => {
    const [x, z] = circle(turn);
    const size = (Math.abs(x) ** exponent + Math.abs(z) ** exponent) ** (-1 / exponent);
    return [size * x, size * z];
  };
}

/**
 * A profile, turned around the Y axis: positions, normals, tangents around the axis, and triangles.
 *
 * @param curves - one after the other, each of points [distance from the axis, y]. A curve is smooth; where two meet is an edge. Its
 * front is on its right: the way up is the outside.
 */
export function revolve(curves: readonly (readonly Point[])[], { outline = circle, segments = 96 } = {}) {
  const positions: number[] = [];
  const normals: number[] = [];
  const tangents: number[] = [];
  const indices: number[] = [];
  for (const curve of curves) {
    curve.forEach(([radius, y], row) => {
      const [before, after] = [curve[Math.max(row - 1, 0)]!, curve[Math.min(row + 1, curve.length - 1)]!];
      const along = [after[0] - before[0], after[1] - before[1]] as const;
      for (let i = 0; i < segments; i++) {
        const vertex = positions.length / 3;
        const turn = i / segments;
        const [x, z] = outline(turn);
        const [ahead, behind] = [outline(turn + STEP), outline(turn - STEP)];
        const around = [ahead[0] - behind[0], ahead[1] - behind[1]] as const;
        const normal = [
          around[1] * along[1],
          (around[0] * z - around[1] * x) * along[0],
          -around[0] * along[1],
        ] as const;
        positions.push(radius * x, y, radius * z);
        normals.push(...unit(normal));
        tangents.push(...unit([around[0], 0, around[1]]), 1);
        if (row === 0) continue;
        const [right, below] = [i === segments - 1 ? vertex + 1 - segments : vertex + 1, vertex - segments];
        const belowRight = right - segments;
        // A ring without a size is a point: half of its triangles have no area.
        if (radius > 0) indices.push(below, vertex, right);
        if (curve[row - 1]![0] > 0) indices.push(below, right, belowRight);
      }
    });
  }
  return { positions, normals, tangents, indices };
}

/** A quarter or less of a circle, from one angle to another, in degrees; 0 points away from the axis, 90 up. */
export function arc([x, y]: Point, radius: number, from: number, to: number, steps = 8): Point[] {
  return Array.from({ length: steps + 1 }, (_, i) => {
    const angle = ((from + ((to - from) * i) / steps) * Math.PI) / 180;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
  });
}

function unit([x, y, z]: readonly [number, number, number]): [number, number, number] {
  const length = Math.hypot(x, y, z);
  return [x / length, y / length, z / length];
}
