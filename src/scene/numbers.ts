import * as v from "valibot";
import { lengthOf, pair, triple } from "./containers";
import { show } from "./describe";
import { isKept, keep } from "./keptBytes";
import { Report } from "./report";
import { hasShape, type Range } from "./shape";

// The shader computes in f32, whose range is 1.2e-38 … 3.4e38, and it squares what the scene holds: distances, radii, and
// sums of three such squares. Between these two, every square is a normal f32 with two decades to spare.
const MAX_MAGNITUDE = 1e18;
const MIN_SIZE = 1e-18;

/**
 * What a number must satisfy, beyond being finite and within ±1e18. `expected` completes "expected …, got -1"; `least` is the
 * smallest magnitude that fits the shader, where zero does not.
 */
type Rule = Range & { readonly expected: string; readonly least?: number };

const ANY: Rule = { expected: "a finite number" };
const POSITIVE: Rule = { expected: "a finite number > 0", above: 0, least: MIN_SIZE };
const NON_NEGATIVE: Rule = { expected: "a finite number ≥ 0", min: 0 };
const FRACTION: Rule = { expected: "a number from 0 to 1", min: 0, max: 1 };
const INDEX: Rule = { expected: "an integer from 0 to 4294967294", min: 0, max: 2 ** 32 - 2, isInteger: true };
const BYTE: Rule = { expected: "an integer from 0 to 255", min: 0, max: 255, isInteger: true };

/** Any number of magnitude ≤ 1e18. */
export const finite = number(ANY);
/** From 1e-18 to 1e18: sizes. */
export const positive = number(POSITIVE);
/** A finite number ≥ 0. */
export const nonNegative = number(NON_NEGATIVE);
/** From 0 to 1. */
export const fraction = number(FRACTION);

/**
 * A number within a range of its own.
 *
 * @param expected - completes "expected …, got -1".
 */
export function numberThat(expected: string, range: Range): v.GenericSchema<number> {
  return number({ ...range, expected });
}

/** `[u, v]`, any finite numbers. */
export const vec2 = pair(finite, "[u, v]");
/** `[x, y, z]`, any finite numbers. */
export const vec3 = triple(finite, "[x, y, z]");
/** `[x, y, z]`, each > 0. */
export const sizes = triple(positive, "[x, y, z]");
/** `[x, y, z]`, not all zero; the length is not 1 in general. */
export const direction = v.pipe(
  triple(finite, "[x, y, z]", (vector) => (Math.hypot(...vector) < MIN_SIZE ? "a vector that is not zero" : undefined)),
  hasShape({ kind: "tuple", length: 3, item: finite, isNonZero: true }),
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
/** Numbers from 0 to 1. */
export const fractions = numbers(FRACTION, Float32Array);
/** Integers ≥ 0. */
export const indices = numbers(INDEX, Uint32Array);
/** Integers from 0 to 255. Those that are kept are not copied, and those that come out are. */
export const bytes = numbers(BYTE, Uint8Array, keep);

type TypedArray = Float64Array | Float32Array | Uint32Array | Uint8Array;

/** Numbers in an array that is not typed. Engines hold no longer one but as a table of its entries, which may be few. */
const MAX_UNTYPED = 2 ** 26;

/**
 * A list of numbers of any length, which becomes a new typed array.
 *
 * @param rule - one without open bounds.
 */
function numbers<Out extends TypedArray>(
  rule: Rule,
  Typed: new (from: number | ArrayLike<number>) => Out,
  finish: (typed: Out) => Out = (typed) => typed,
): v.GenericSchema<Numbers, Out> {
  const { min, max, isInteger = false } = rangeOf(rule);
  const isSafe = (kind: string | undefined) => min <= 0 && max >= (LARGEST[kind ?? ""] ?? Number.POSITIVE_INFINITY);
  return v.pipe(
    v.custom<Numbers>(isNumbers, (issue) => `expected an array, got ${show(issue.input)}`),
    v.rawTransform(({ dataset: { value: input }, config }): Out | undefined => {
      const kind = kindOf(input);
      if (isSafe(kind)) return kind === Typed.name && isKept(input) ? (input as Out) : finish(new Typed(input));
      const report = Report.of(config);
      const length = kind === undefined ? lengthOf(input as readonly number[], MAX_UNTYPED, report) : input.length;
      const typed = new Typed(length);
      let isSound = true;
      for (let i = 0; i < length; i++) {
        const value: unknown = input[i];
        // To ask `problemWith` of each of a mesh's millions takes three times as long.
        const isInRange = typeof value === "number" && value >= min && value <= max;
        if (isInRange && (!isInteger || Number.isInteger(value))) typed[i] = value;
        else {
          report.add(() => `expected ${problemWith(value, rule)}, got ${show(value)}`, i);
          isSound = false;
        }
      }
      return isSound ? finish(typed) : undefined;
    }),
    hasShape({ kind: "list", item: number(rule) }),
  ) as v.GenericSchema<Numbers, Out | undefined> as v.GenericSchema<Numbers, Out>;
}

/** What is in these arrays is an integer from 0 to this, whoever wrote it: there is nothing to check. */
const LARGEST: Readonly<Record<string, number>> = { Uint8Array: 255, Uint8ClampedArray: 255, Uint16Array: 65535 };

const typedArrays = Object.getPrototypeOf(Uint8Array.prototype);
const kindGetter = Object.getOwnPropertyDescriptor(typedArrays, Symbol.toStringTag)!.get!;

/** `"Uint8Array"` for one, even if it pretends to be another; `undefined` for what is no typed array. */
function kindOf(input: unknown): string | undefined {
  return kindGetter.call(input);
}

function isNumbers(input: unknown): input is Numbers {
  return Array.isArray(input) || kindOf(input) !== undefined;
}

function number(rule: Rule): v.GenericSchema<number> {
  return v.pipe(
    v.custom<number>(
      (input) => problemWith(input, rule) === undefined,
      (issue) => `expected ${problemWith(issue.input, rule)}, got ${show(issue.input)}`,
    ),
    hasShape({ kind: "number", ...rangeOf(rule) }),
  );
}

/** Every bound of a rule, those that all numbers have included. */
function rangeOf({ expected: _, least, ...range }: Rule) {
  return { ...range, min: least ?? range.min ?? -MAX_MAGNITUDE, max: range.max ?? MAX_MAGNITUDE };
}

/** What was expected in place of `input`, or `undefined` if it is fine. */
function problemWith(input: unknown, rule: Rule): string | undefined {
  const { expected, least = 0 } = rule;
  if (typeof input !== "number" || !Number.isFinite(input) || !isWithin(input, rule)) return expected;
  if (Math.abs(input) > MAX_MAGNITUDE) return `a magnitude of at most ${MAX_MAGNITUDE} (its square must fit in f32)`;
  if (Math.abs(input) < least) return `a number of at least ${least} (its square must fit in f32)`;
  return undefined;
}

function isWithin(x: number, { min, max, above, below, isInteger }: Range): boolean {
  if (isInteger === true && !Number.isInteger(x)) return false;
  if ((min !== undefined && x < min) || (max !== undefined && x > max)) return false;
  return !((above !== undefined && x <= above) || (below !== undefined && x >= below));
}
