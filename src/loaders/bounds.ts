import { add, length, scale, subtract } from "../math/vec3";
import type { Vec3 } from "../scene/schema";

/** Of a radius, in metres and relative to the distance from the origin: two points this far apart are still two in doubles. */
const MIN_RADIUS = 1e-9;

/** The smallest box around all that was added. */
export class Bounds {
  #min: Vec3 = [Infinity, Infinity, Infinity];
  #max: Vec3 = [-Infinity, -Infinity, -Infinity];

  /** @param positions - x, y, z per point, all finite. */
  add(positions: Float32Array | Float64Array): void {
    let [x0, y0, z0] = this.#min;
    let [x1, y1, z1] = this.#max;
    for (let i = 0; i < positions.length; i += 3) {
      const x = positions[i]!;
      const y = positions[i + 1]!;
      const z = positions[i + 2]!;
      if (x < x0) x0 = x;
      if (x > x1) x1 = x;
      if (y < y0) y0 = y;
      if (y > y1) y1 = y;
      if (z < z0) z0 = z;
      if (z > z1) z1 = z;
    }
    this.#min = [x0, y0, z0];
    this.#max = [x1, y1, z1];
  }

  get isEmpty(): boolean {
    return this.#min[0] > this.#max[0];
  }

  get min(): Vec3 {
    return this.#min;
  }

  get max(): Vec3 {
    return this.#max;
  }

  get center(): Vec3 {
    return scale(add(this.#min, this.#max), 1 / 2);
  }

  /** Half the diagonal: a ball of this radius around the center holds everything. Never 0. */
  get radius(): number {
    return Math.max(length(subtract(this.#max, this.#min)) / 2, MIN_RADIUS * Math.max(1, this.reach));
  }

  /** The largest coordinate, of either sign. */
  get reach(): number {
    return Math.max(...this.#min.map(Math.abs), ...this.#max.map(Math.abs));
  }
}
