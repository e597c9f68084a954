// f32 arithmetic as WGSL allows it: + − × may round either way, and a product may be fused into a sum, so that it is not rounded
// before.

/** What a device makes of the freedom it has. Asked anew for every operation. */
export interface Choices {
  /** Which of the one or two products in a sum to fuse into it: the first, the last, or 0 for none. */
  fuse(products: 1 | 2): 0 | 1 | 2;
  /** -1: down, 0: to the nearest, 1: up. */
  round(): -1 | 0 | 1;
}

/** A product that is not rounded yet. In f64 it is exact. */
export class Product {
  readonly exact: number;
  #rounded: number | undefined;

  constructor(exact: number) {
    this.exact = exact;
  }

  /** As one instruction computes it, for all that use it. */
  rounded(choices: Choices): number {
    this.#rounded ??= round(this.exact, 0, choices.round());
    return this.#rounded;
  }
}

export type Scalar = number | Product;

export function value(x: Scalar, choices: Choices): number {
  return typeof x === "number" ? x : x.rounded(choices);
}

export function negated(x: Scalar): Scalar {
  return typeof x === "number" ? -x : new Product(-x.exact);
}

/** x + y. */
export function sum(x: Scalar, y: Scalar, choices: Choices): number {
  const isFirst = typeof x !== "number";
  const isSecond = typeof y !== "number";
  const fused = isFirst || isSecond ? choices.fuse(isFirst && isSecond ? 2 : 1) : 0;
  const a = isFirst && (fused === 1 || (fused === 2 && !isSecond)) ? x.exact : value(x, choices);
  const b = isSecond && (fused === 2 || (fused === 1 && !isFirst)) ? y.exact : value(y, choices);
  const total = a + b;
  // What f64 leaves out of the sum, exactly (Knuth's two-sum).
  const part = total - a;
  const error = Number.isFinite(total) ? a - (total - part) + (b - part) : 0;
  return round(total, error, choices.round());
}

/** The f32 next to `x` + `error`, where the f64 `x` is that sum rounded. */
export function round(x: number, error: number, direction: -1 | 0 | 1): number {
  const nearest = Math.fround(x);
  if (!Number.isFinite(nearest)) return nearest;
  const off = nearest - x - error;
  if (direction === 0) {
    // Half way between two f32, and not quite: f64 rounded to the middle, and the middle to even.
    if (error !== 0 && nearest !== x) {
      const other = off > 0 ? nextBelow(nearest) : nextAbove(nearest);
      if (Math.abs(x - other) === Math.abs(nearest - x) && Math.sign(off) === Math.sign(-error)) return other;
    }
    return nearest;
  }
  if (off === 0) return nearest;
  if (direction > 0) return off < 0 ? nextAbove(nearest) : nearest;
  return off > 0 ? nextBelow(nearest) : nearest;
}

const float = new Float32Array(1);
const bits = new Int32Array(float.buffer);

export function nextAbove(x: number): number {
  if (x === 0) return 2 ** -149;
  float[0] = x;
  bits[0] = bits[0]! + (x > 0 ? 1 : -1);
  return float[0]!;
}

export function nextBelow(x: number): number {
  return -nextAbove(-x);
}

const DIRECTIONS = [0, -1, 1] as const;
const FUSIONS = [0, 1, 2] as const;

/** Devices that choose alike wherever they may choose: nine, a software adapter first. */
export const CONSISTENT: readonly { readonly name: string; readonly choices: Choices }[] = DIRECTIONS.flatMap(
  (direction) =>
    FUSIONS.map((fusion) => ({
      name: `fuses ${["nothing", "the first product", "the last"][fusion]}, rounds ${["down", "to the nearest", "up"][direction + 1]}`,
      choices: { fuse: () => fusion, round: () => direction },
    })),
);

/** A device that chooses at random. */
export function randomChoices(random: () => number): Choices {
  return {
    fuse: (products) => Math.floor((products + 1) * random()) as 0 | 1 | 2,
    round: () => DIRECTIONS[Math.floor(3 * random())]!,
  };
}

/** Calls `body` once for each way to fuse the products of what it runs, with all rounded to the nearest. */
export function everyFusion<Run>(functions: (choices: Choices) => Run, body: (run: Run) => void): void {
  const answers: { given: number; readonly most: number }[] = [];
  let at = 0;
  const run = functions({
    fuse: (products) => {
      answers[at] ??= { given: 0, most: products };
      return answers[at++]!.given as 0 | 1 | 2;
    },
    round: () => 0,
  });
  for (;;) {
    at = 0;
    body(run);
    answers.length = at;
    while (answers.length > 0 && answers.at(-1)!.given === answers.at(-1)!.most) answers.pop();
    if (answers.length === 0) return;
    answers.at(-1)!.given++;
  }
}
