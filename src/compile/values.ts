import type { Vec3 } from "../scene/schema";

/** WGSL types that tables are made of. */
export type RowType = "f32" | "u32" | "vec3u" | "vec3f" | "vec4f";

/** How generated code names the numbers of a scene. */
export interface Values {
  /** A WGSL expression for a scalar. */
  scalar(value: number): string;
  /** A WGSL expression for a vec3f. */
  vec3(value: Vec3): string;
  /**
   * WGSL statements that return row `i` of a table.
   *
   * @param uniform - the row in the scene uniform, as a WGSL expression.
   * @param type - of a row.
   * @param rows - the same values, each by its components.
   */
  lookup(uniform: string, type: RowType, rows: readonly (readonly number[])[]): string;
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

  lookup(uniform: string): string {
    return `  return ${uniform};\n`;
  }

  /** All values handed out so far; length a multiple of 4. */
  get numbers(): readonly number[] {
    return this.#numbers;
  }
}

// Past this many, reading the uniform is quicker.
const MAX_SELECTS = 12;

/** Values written into the program's text, where its compiler can fold them. Editing one needs another program. */
export class Literals implements Values {
  vec3(value: Vec3): string {
    return constant("vec3f", value);
  }

  scalar(value: number): string {
    return literal(value);
  }

  /** A chain of selects: the commonest row, unless `i` is one of those that have another. */
  lookup(uniform: string, type: RowType, rows: readonly (readonly number[])[]): string {
    const idsByRow = new Map<string, number[]>();
    for (const [id, row] of rows.entries()) {
      const text = constant(type, row);
      idsByRow.set(text, [...(idsByRow.get(text) ?? []), id]);
    }
    const [commonest, ...others] = [...idsByRow].sort(([, a], [, b]) => b.length - a.length);
    if (!commonest || others.length > MAX_SELECTS) return `  return ${uniform};\n`;
    const steps = others.map(([row, ids]) => {
      const isOneOf = ids.map((id) => `(i == ${id}u)`).join(" | ");
      return `  value = select(value, ${row}, ${isOneOf});\n`;
    });
    return `  var value = ${commonest[0]};\n${steps.join("")}  return value;\n`;
  }
}

function constant(type: RowType, components: readonly number[]): string {
  return `${type}(${components.map(type === "u32" ? String : literal).join(", ")})`;
}

/** The f32 nearest to a finite number, as WGSL text. */
function literal(value: number): string {
  const text = String(Math.fround(value));
  return /[.e]/.test(text) ? text : `${text}.0`;
}
