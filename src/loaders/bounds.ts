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
    const size = twiceAreaAt(positions, indices, i);
    if (!(size > threshold)) continue;
    twiceArea += size;
    const a = 3 * indices[i]!;
    const b = 3 * indices[i + 1]!;
    const c = 3 * indices[i + 2]!;
    x0 = Math.min(x0, positions[a]!, positions[b]!, positions[c]!);
    y0 = Math.min(y0, positions[a + 1]!, positions[b + 1]!, positions[c + 1]!);
    z0 = Math.min(z0, positions[a + 2]!, positions[b + 2]!, positions[c + 2]!);
    x1 = Math.max(x1, positions[a]!, positions[b]!, positions[c]!);
    y1 = Math.max(y1, positions[a + 1]!, positions[b + 1]!, positions[c + 1]!);
    z1 = Math.max(z1, positions[a + 2]!, positions[b + 2]!, positions[c + 2]!);
  }
  return { area: twiceArea / 2, min: [x0, y0, z0], max: [x1, y1, z1] };
}

/** Twice the area of the triangle whose first index is at `i`. */
export function twiceAreaAt(positions: Float32Array | Float64Array, indices: Uint32Array, i: number): number {
  const a = 3 * indices[i]!;
  const b = 3 * indices[i + 1]!;
  const c = 3 * indices[i + 2]!;
  const ux = positions[b]! - positions[a]!;
  const uy = positions[b + 1]! - positions[a + 1]!;
  const uz = positions[b + 2]! - positions[a + 2]!;
  const vx = positions[c]! - positions[a]!;
  const vy = positions[c + 1]! - positions[a + 1]!;
  const vz = positions[c + 2]! - positions[a + 2]!;
  const x = uy * vz - uz * vy;
  const y = uz * vx - ux * vz;
  const z = ux * vy - uy * vx;
  return Math.sqrt(x * x + y * y + z * z);
}

/** Of the largest area: what has less is not a pixel where all of the largest is in view, wherever it is. */
const NEGLIGIBLE_AREA = 1e-12;

/** The smallest box around all that can be seen of what was added. It is measured when it is first asked for. */
export class Bounds {
  readonly #parts: Parameters<typeof extentOf>[] = [];
  #box: { readonly min: Vec3; readonly max: Vec3 } | undefined;

  /** As for `extentOf`. */
  add(...part: Parameters<typeof extentOf>): void {
    this.#parts.push(part);
    this.#box = undefined;
  }

  get isEmpty(): boolean {
    return this.#parts.length === 0;
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
    const extents = this.#parts.map((part) => extentOf(...part));
    const largest = extents.reduce((area, extent) => Math.max(area, extent.area), 0);
    const min: [number, number, number] = [Infinity, Infinity, Infinity];
    const max: [number, number, number] = [-Infinity, -Infinity, -Infinity];
    for (const extent of extents) {
      if (extent.area < NEGLIGIBLE_AREA * largest) continue;
      for (let axis = 0; axis < 3; axis++) {
        min[axis] = Math.min(min[axis]!, extent.min[axis]!);
        max[axis] = Math.max(max[axis]!, extent.max[axis]!);
      }
    }
    this.#box = { min, max };
    return this.#box;
  }
}
