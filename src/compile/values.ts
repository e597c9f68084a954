import type { Vec3 } from "../scene/schema";

/** How generated code names the numbers of a scene. */
export interface Values {
  /** A WGSL expression for a scalar. */
  scalar(value: number): string;
  /** A WGSL expression for a vec3f. */
  vec3(value: Vec3): string;
}

/** Values that live in `scene.slots`, an array of vec4f in the scene uniform: editable without a recompile. */
export class Slots implements Values {
  readonly #numbers: number[] = [];
  /** Slots whose w is still free. */
  readonly #spare: number[] = [];

  vec3(value: Vec3): string {
    const slot = this.#numbers.length / 4;
    this.#numbers.push(...value, 0);
    this.#spare.push(slot);
    return `scene.slots[${slot}].xyz`;
  }

  scalar(value: number): string {
    const spare = this.#spare.shift();
    if (spare !== undefined) {
      this.#numbers[4 * spare + 3] = value;
      return `scene.slots[${spare}].w`;
    }
    const slot = this.#numbers.length / 4;
    this.#numbers.push(value, 0, 0, 0);
    return `scene.slots[${slot}].x`;
  }

  /** All values handed out so far; length a multiple of 4. */
  get numbers(): readonly number[] {
    return this.#numbers;
  }
}
