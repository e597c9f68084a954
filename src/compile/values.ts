import type { Vec3 } from "../scene/schema";

/** WGSL types that tables are made of. */
export type RowType = "f32" | "u32" | "vec3u" | "vec3f" | "vec4f";
/** A row of one: a scalar, or a vector's components. */
export type Row = number | ArrayLike<number>;

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
   * @param count - of the rows; the text does not grow with it.
   * @param rowAt - the same values.
   */
  lookup(uniform: string, type: RowType, count: number, rowAt: (i: number) => Row): string;
}

/** Values that live in `scene.slots`, an array of vec4f in the scene uniform: editable without a recompile. */
export class Slots implements Values {
  readonly #numbers: number[] = [];
  /** Slots whose w was free, and how many of them have been filled. */
  readonly #spare: number[] = [];
  #filled = 0;

  vec3(value: Vec3): string {
    const slot = this.#numbers.length / 4;
    this.#numbers.push(...value, 0);
    this.#spare.push(slot);
    return `scene.slots[${slot}].xyz`;
  }

  scalar(value: number): string {
    const spare = this.#spare[this.#filled];
    if (spare !== undefined) {
      this.#filled++;
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

// Past this many different rows, reading the uniform is quicker.
const MAX_SELECTS = 12;
// Past this many comparisons too; and WGSL's compilers refuse an expression that is 512 operators deep.
const MAX_COMPARISONS = 48;

/** Values written into the program's text, where its compiler can fold them. Editing one needs another program. */
export class Literals implements Values {
  vec3(value: Vec3): string {
    return constant("vec3f", value);
  }

  scalar(value: number): string {
    return literal(value);
  }

  /** A chain of selects: the commonest row, unless `i` is one of those that have another. Of too many, the uniform's row. */
  lookup(uniform: string, type: RowType, count: number, rowAt: (i: number) => Row): string {
    const inUniform = `  return ${uniform};\n`;
    const idsByRow = new Map<string, number[]>();
    let before: { readonly row: Row; readonly ids: number[] } | undefined;
    let commonestCount = 0;
    for (let id = 0; id < count; id++) {
      const row = rowAt(id);
      // Neighbours are often alike, and quicker to compare than to write.
      const ids = before && areEqual(row, before.row) ? before.ids : idsOf(constant(type, row), idsByRow);
      before = { row, ids };
      commonestCount = Math.max(commonestCount, ids.push(id));
      if (id + 1 - commonestCount > MAX_COMPARISONS) return inUniform;
    }
    const [commonest, ...others] = [...idsByRow].sort(([, a], [, b]) => b.length - a.length);
    if (!commonest || others.length > MAX_SELECTS) return inUniform;
    const steps = others.map(([row, ids]) => {
      const isOneOf = ids.map((id) => `(i == ${id}u)`).join(" | ");
      return `  value = select(value, ${row}, ${isOneOf});\n`;
    });
    return `  var value = ${commonest[0]};\n${steps.join("")}  return value;\n`;
  }
}

function idsOf(row: string, idsByRow: Map<string, number[]>): number[] {
  const ids = idsByRow.get(row) ?? [];
  if (ids.length === 0) idsByRow.set(row, ids);
  return ids;
}

function areEqual(a: Row, b: Row): boolean {
  if (typeof a === "number" || typeof b === "number") return a === b;
  for (let i = 0; i < a.length; i++) if (a[i] !== b[i]) return false;
  return true;
}

function constant(type: RowType, row: Row): string {
  const components = typeof row === "number" ? [row] : Array.from(row);
  return `${type}(${components.map(type === "u32" ? String : literal).join(", ")})`;
}

/** The f32 nearest to a finite number, as WGSL text. */
function literal(value: number): string {
  const text = String(Math.fround(value));
  return /[.e]/.test(text) ? text : `${text}.0`;
}
