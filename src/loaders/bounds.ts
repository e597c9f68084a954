import { add, length, scale, subtract } from "../math/vec3";
import type { Vec3 } from "../scene/schema";

/** Of a radius, in metres and relative to the distance from the origin: two points this far apart are still two in doubles. */
const MIN_RADIUS = 1e-9;

/** A box and what there is to see in it. */
export type Extent = {
  /** Of all triangles, in square metres. */
  readonly area: number;
  readonly min: Vec3;
  readonly max: Vec3;
};

/**
 * What triangles take up. The box is around those that have an area; if none has, around all.
 *
 * @param positions - x, y, z per vertex, all finite. Vertices of no triangle don't count.
 */
export function extentOf(positions: Float32Array | Float64Array, indices: Uint32Array): Extent {
  const seen = boxOf(positions, indices, 0);
  return seen.area > 0 ? seen : boxOf(positions, indices, -1);
}

/** @param threshold - triangles count whose area is larger. Written out, because a mesh can have millions of triangles. */
function boxOf(positions: Float32Array | Float64Array, indices: Uint32Array, threshold: number): Extent {
  let twiceArea = 0;
  let [x0, y0, z0] = [Infinity, Infinity, Infinity];
  let [x1, y1, z1] = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < indices.length; i += 3) {
    const a = 3 * indices[i]!;
    const b = 3 * indices[i + 1]!;
    const c = 3 * indices[i + 2]!;
    const ax = positions[a]!;
    const ay = positions[a + 1]!;
    const az = positions[a + 2]!;
    const bx = positions[b]!;
    const by = positions[b + 1]!;
    const bz = positions[b + 2]!;
    const cx = positions[c]!;
    const cy = positions[c + 1]!;
    const cz = positions[c + 2]!;
    const nx = (by - ay) * (cz - az) - (bz - az) * (cy - ay);
    const ny = (bz - az) * (cx - ax) - (bx - ax) * (cz - az);
    const nz = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
    const size = Math.sqrt(nx * nx + ny * ny + nz * nz);
    if (!(size > threshold)) continue;
    twiceArea += size;
    x0 = Math.min(x0, ax, bx, cx);
    y0 = Math.min(y0, ay, by, cy);
    z0 = Math.min(z0, az, bz, cz);
    x1 = Math.max(x1, ax, bx, cx);
    y1 = Math.max(y1, ay, by, cy);
    z1 = Math.max(z1, az, bz, cz);
  }
  return { area: twiceArea / 2, min: [x0, y0, z0], max: [x1, y1, z1] };
}

/** Of the largest area: what has less is not a pixel where all of the largest is in view, wherever it is. */
const NEGLIGIBLE_AREA = 1e-12;

/** The smallest box around all that can be seen of what was added. */
export class Bounds {
  readonly #extents: Extent[] = [];
  #largest = 0;
  /** Around what counts now: it is made anew when that changes. */
  #box: { min: Vec3; max: Vec3 } | undefined;

  add(extent: Extent): void {
    this.#extents.push(extent);
    this.#largest = Math.max(this.#largest, extent.area);
    this.#box = undefined;
  }

  get isEmpty(): boolean {
    return this.#extents.length === 0;
  }

  get min(): Vec3 {
    return this.#around().min;
  }

  get max(): Vec3 {
    return this.#around().max;
  }

  get center(): Vec3 {
    return scale(add(this.min, this.max), 1 / 2);
  }

  /** Half the diagonal: a ball of this radius around the center holds everything. Never 0. */
  get radius(): number {
    const reach = Math.max(...this.min.map(Math.abs), ...this.max.map(Math.abs));
    return Math.max(length(subtract(this.max, this.min)) / 2, MIN_RADIUS * Math.max(1, reach));
  }

  #around() {
    if (this.#box !== undefined) return this.#box;
    const min: [number, number, number] = [Infinity, Infinity, Infinity];
    const max: [number, number, number] = [-Infinity, -Infinity, -Infinity];
    for (const extent of this.#extents) {
      if (extent.area < NEGLIGIBLE_AREA * this.#largest) continue;
      for (let axis = 0; axis < 3; axis++) {
        min[axis] = Math.min(min[axis]!, extent.min[axis]!);
        max[axis] = Math.max(max[axis]!, extent.max[axis]!);
      }
    }
    this.#box = { min, max };
    return this.#box;
  }
}
