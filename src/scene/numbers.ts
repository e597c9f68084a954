import * as v from "valibot";
import { isHopeless, pathItem, triple } from "./containers";
import { show } from "./describe";

// The shader computes in f32, whose range is 1.2e-38 … 3.4e38, and it squares what the scene holds: distances, radii, and
// sums of three such squares. Between these two, every square is a normal f32 with two decades to spare.
const MAX_MAGNITUDE = 1e18;
const MIN_SIZE = 1e-18;

/** What a number must satisfy, beyond being finite and within ±1e18. `expected` completes "expected …, got -1". */
type Rule = { readonly expected: string; readonly accepts: (x: number) => boolean; readonly minimum?: number };

const ANY: Rule = { expected: "a finite number", accepts: () => true };
const POSITIVE: Rule = { expected: "a finite number > 0", accepts: (x) => x > 0, minimum: MIN_SIZE };
const NON_NEGATIVE: Rule = { expected: "a finite number ≥ 0", accepts: (x) => x >= 0 };
const FRACTION: Rule = { expected: "a number from 0 to 1", accepts: (x) => x >= 0 && x <= 1 };
const INDEX: Rule = {
  expected: "an integer from 0 to 4294967294",
  accepts: (x) => x >= 0 && x < 2 ** 32 - 1 && Number.isInteger(x),
};
const BYTE: Rule = { expected: "an integer from 0 to 255", accepts: (x) => x >= 0 && x <= 255 && Number.isInteger(x) };

/** Any number of magnitude ≤ 1e18. */
export const finite = number(ANY);
/** From 1e-18 to 1e18: sizes. */
export const positive = number(POSITIVE);
/** From 0 to 1. */
export const fraction = number(FRACTION);

/**
 * A number that satisfies a rule of its own.
 *
 * @param expected - completes "expected …, got -1".
 */
export function numberThat(expected: string, accepts: (x: number) => boolean): v.GenericSchema<number> {
  return number({ expected, accepts });
}

/** `[x, y, z]`, any finite numbers. */
export const vec3 = triple(finite, "[x, y, z]");
/** `[x, y, z]`, each > 0. */
export const sizes = triple(positive, "[x, y, z]");
/** `[x, y, z]`, not all zero; the length is not 1 in general. */
export const direction = v.pipe(
  vec3,
  v.check(
    (vector) => Math.hypot(...vector) >= MIN_SIZE,
    (issue) => `expected a vector that is not zero, got ${show(issue.input)}`,
  ),
);
/** `[r, g, b]`, linear Rec. 709, each from 0 to 1: reflectances. */
export const reflectance = triple(fraction, "[r, g, b]");
/** `[r, g, b]`, linear Rec. 709, each ≥ 0: radiances and powers. */
export const light = triple(number(NON_NEGATIVE), "[r, g, b]");

/** Many numbers: a plain array, as in JSON, or a typed one. */
export type Numbers =
  | readonly number[]
  | Float32Array
  | Float64Array
  | Uint32Array
  | Uint16Array
  | Uint8Array
  | Uint8ClampedArray;

/** Coordinates, in doubles: what they are relative to is subtracted before they are rounded. */
export const coordinates = numbers(ANY, Float64Array);
/** Directions and texture coordinates. */
export const floats = numbers(ANY, Float32Array);
/** Integers ≥ 0. */
export const indices = numbers(INDEX, Uint32Array);
/** Integers from 0 to 255. */
export const bytes = numbers(BYTE, Uint8Array);

type TypedArray = Float64Array | Float32Array | Uint32Array | Uint8Array;

/** A list of numbers of any length, which becomes a new typed array. */
function numbers<Out extends TypedArray>(
  rule: Rule,
  Typed: new (length: number) => Out,
): v.GenericSchema<Numbers, Out> {
  return v.pipe(
    v.custom<Numbers>(isNumbers, (issue) => `expected an array, got ${show(issue.input)}`),
    v.rawTransform(({ dataset: { value: input }, addIssue, NEVER }) => {
      let faulty = 0;
      for (let i = 0; i < input.length && !isHopeless(faulty, addIssue); i++) {
        const value: unknown = input[i];
        const expected = problemWith(value, rule);
        if (expected === undefined) continue;
        addIssue({ message: `expected ${expected}, got ${show(value)}`, path: [pathItem(input, i)] });
        faulty++;
      }
      if (faulty > 0) return NEVER;
      const typed = new Typed(input.length);
      typed.set(input);
      return typed;
    }),
  );
}

function isNumbers(input: unknown): input is Numbers {
  return Array.isArray(input) || (ArrayBuffer.isView(input) && !(input instanceof DataView));
}

function number(rule: Rule): v.GenericSchema<number> {
  return v.custom<number>(
    (input) => problemWith(input, rule) === undefined,
    (issue) => `expected ${problemWith(issue.input, rule)}, got ${show(issue.input)}`,
  );
}

/** What was expected in place of `input`, or `undefined` if it is fine. */
function problemWith(input: unknown, { expected, accepts, minimum = 0 }: Rule): string | undefined {
  if (typeof input !== "number" || !Number.isFinite(input) || !accepts(input)) return expected;
  if (Math.abs(input) > MAX_MAGNITUDE) return `a magnitude of at most ${MAX_MAGNITUDE} (its square must fit in f32)`;
  if (Math.abs(input) < minimum) return `a number of at least ${minimum} (its square must fit in f32)`;
  return undefined;
}
