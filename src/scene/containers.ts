// Objects, lists and dictionaries that report everything that is wrong with them, and read each of their values once: a proxy or
// a getter could answer differently the next time.
//
// valibot's own `strictObject`, `variant` and `record` stop at the first unknown key, take an array for an object, and
// drop keys such as "constructor" without a word. These build on its public actions instead, and infer the same types.
//
// What is at fault is told to the `Report`, and is `undefined` in the output, which is thrown away then. So checks that look at
// more than one value see all that is sound.

import * as v from "valibot";
import { oneOf, show, suggest } from "./describe";
import { Report } from "./report";
import { hasShape, shapeOf } from "./shape";

/** Entries of a list of objects or lights. A scene of these takes gigabytes; an array can claim four thousand times as many. */
const MAX_ENTRIES = 2 ** 20;

type Input<Entries extends v.ObjectEntries> = Readonly<v.InferInput<v.StrictObjectSchema<Entries, undefined>>>;
type Output<Entries extends v.ObjectEntries> = Readonly<v.InferOutput<v.StrictObjectSchema<Entries, undefined>>>;

/** Adds an issue to the object being parsed, at one of its fields or further in. */
export type AddFieldIssue<Key> = (path: readonly [Key, ...(string | number)[]], message: string) => void;

/**
 * An object with exactly these fields. A field that is `undefined` counts as absent.
 *
 * @param entries - a schema per field; `v.optional(…, default)` where it may be absent.
 * @param check - looks at several fields together; a field that is itself at fault is there, and `undefined`.
 */
export function strictObject<const Entries extends v.ObjectEntries>(
  entries: Entries,
  check?: (fields: Partial<Output<Entries>>, addIssue: AddFieldIssue<keyof Entries & string>) => void,
): v.GenericSchema<Input<Entries>, Output<Entries>> {
  const known = Object.keys(entries);
  const choice = `; the keys here are ${known.map((name) => `"${name}"`).join(", ")}`;
  return v.pipe(
    v.custom<Input<Entries>>(isObject, (issue) => `expected an object, got ${show(issue.input)}`),
    v.rawTransform(({ dataset: { value }, config }) => {
      const report = Report.of(config);
      const input: object = value instanceof Typed ? value.object : value;
      const fields: Record<string, unknown> = {};
      for (const [key, schema] of Object.entries(entries)) {
        const given: unknown = value instanceof Typed && key === "type" ? value.type : Reflect.get(input, key);
        const parsed = report.parse(schema as v.GenericSchema, given, key);
        if (parsed !== undefined || given !== undefined) fields[key] = parsed;
      }
      for (const key of Object.keys(input)) {
        if (!Object.hasOwn(entries, key)) report.add(() => `unknown key${suggest(key, known) || choice}`, key);
      }
      check?.(fields as Partial<Output<Entries>>, (path, message) => report.add(message, ...path));
      return fields as Output<Entries>;
    }),
    hasShape({ kind: "object", entries }),
  );
}

/** What an object of a schema is without any of its fields; of one whose fields may all be absent. */
export function defaultsOf<Output>(schema: v.GenericSchema<object, Output>): Output {
  const shape = shapeOf(schema);
  const entries = shape?.kind === "object" ? Object.entries(shape.entries) : [];
  const fields = entries.map(([name, entry]) => [name, v.getDefault(entry as v.GenericSchema)] as const);
  return Object.fromEntries(fields.filter(([, value]) => value !== undefined)) as Output;
}

/** An object whose `type` has been read. */
class Typed {
  readonly object: object;
  readonly type: string;

  constructor(object: object, type: string) {
    this.object = object;
    this.type = type;
  }
}

/**
 * One of several objects, told apart by their `type`.
 *
 * @param options - the schema of each type, a `strictObject`.
 */
export function byType<const Options extends Readonly<Record<string, v.GenericSchema>>>(
  options: Options,
): v.GenericSchema<v.InferInput<Options[keyof Options]>, v.InferOutput<Options[keyof Options]>> {
  const types = Object.keys(options);
  return v.pipe(
    v.custom<v.InferInput<Options[keyof Options]>>(isObject, (issue) => `expected an object, got ${show(issue.input)}`),
    v.rawTransform(({ dataset: { value: input }, config }) => {
      const report = Report.of(config);
      const type: unknown = Reflect.get(input as object, "type");
      if (typeof type === "string" && Object.hasOwn(options, type)) {
        return report.parseWhole(options[type]!, new Typed(input as object, type));
      }
      report.add(() => `expected ${oneOf(types)}, got ${show(type)}${suggest(type, types)}`, "type");
      return undefined;
    }),
    hasShape({ kind: "byType", options }),
  ) as v.GenericSchema<v.InferInput<Options[keyof Options]>, v.InferOutput<Options[keyof Options]>>;
}

/**
 * A string, or an object with more to say.
 *
 * @param object - a `strictObject`.
 * @param expected - what the string is and the object, for the error.
 */
export function stringOr<In extends object, Out>(
  object: v.GenericSchema<In, Out>,
  expected: string,
): v.GenericSchema<string | In, string | Out> {
  return v.pipe(
    v.custom<string | In>(
      (input) => typeof input === "string" || isObject(input),
      (issue) => `expected ${expected}, got ${show(issue.input)}`,
    ),
    v.rawTransform(({ dataset: { value: input }, config }) =>
      typeof input === "string" ? input : Report.of(config).parseWhole(object, input),
    ),
    hasShape({ kind: "stringOr", object }),
  ) as v.GenericSchema<string | In, string | Out>;
}

/** Exactly two of something; see `triple`. */
export function pair<In, Out>(
  item: v.GenericSchema<In, Out>,
  expected: string,
): v.GenericSchema<readonly [In, In], readonly [Out, Out]> {
  return tuple<In, Out, readonly [In, In], readonly [Out, Out]>(2, item, expected);
}

/**
 * Exactly three of something.
 *
 * @param expected - how a correct value looks, for the error: `[x, y, z]`.
 * @param problem - what was expected instead of this one, if that is sound and nevertheless wrong.
 */
export function triple<In, Out>(
  item: v.GenericSchema<In, Out>,
  expected: string,
  problem?: (triple: readonly [Out, Out, Out]) => string | undefined,
): v.GenericSchema<readonly [In, In, In], readonly [Out, Out, Out]> {
  return tuple<In, Out, readonly [In, In, In], readonly [Out, Out, Out]>(3, item, expected, problem);
}

function tuple<In, Out, Ins extends readonly In[], Outs extends readonly Out[]>(
  length: number,
  item: v.GenericSchema<In, Out>,
  expected: string,
  problem: (tuple: Outs) => string | undefined = () => undefined,
): v.GenericSchema<Ins, Outs> {
  return v.pipe(
    v.custom<Ins>(
      (input) => Array.isArray(input) && input.length === length,
      (issue) => `expected ${expected}, got ${show(issue.input)}`,
    ),
    v.rawTransform(({ dataset: { value: input }, config }) => {
      const report = Report.of(config);
      const items = Array.from({ length }, (_, i) => report.parse(item, input[i], i));
      if (items.includes(undefined)) return undefined;
      const parsed = items as readonly Out[] as Outs;
      const wanted = problem(parsed);
      if (wanted === undefined) return parsed;
      report.add(() => `expected ${wanted}, got ${show(parsed)}`);
      return undefined;
    }),
    hasShape({ kind: "tuple", length, item }),
  ) as v.GenericSchema<Ins, Outs>;
}

/** An array of any length up to a million. The result is a new array. */
export function list<In, Out>(item: v.GenericSchema<In, Out>): v.GenericSchema<readonly In[], readonly Out[]> {
  return v.pipe(
    v.custom<readonly In[]>(Array.isArray, (issue) => `expected an array, got ${show(issue.input)}`),
    v.rawTransform(({ dataset: { value: input }, config }) => {
      const report = Report.of(config);
      const length = lengthOf(input, MAX_ENTRIES, report);
      const items: (Out | undefined)[] = [];
      for (let i = 0; i < length; i++) items.push(report.parse(item, input[i], i));
      return items as Out[];
    }),
    hasShape({ kind: "list", item }),
  );
}

/** The length of an array, which a proxy may have made up; 0 if it is too much, which is reported. */
export function lengthOf(array: readonly unknown[], max: number, report: Report): number {
  const { length } = array;
  if (Number.isInteger(length) && length >= 0 && length <= max) return length;
  report.add(() => `expected at most ${max} entries, got ${show(length)}`);
  return 0;
}

/**
 * Values by name, whatever the name: `"constructor"` and `"__proto__"` are as good as any. The result has no prototype, so
 * that it has no names but its own.
 */
export function dictionary<In, Out>(
  item: v.GenericSchema<In, Out>,
): v.GenericSchema<Readonly<Record<string, In>>, Readonly<Record<string, Out>>> {
  return v.pipe(
    v.custom<Readonly<Record<string, In>>>(isObject, (issue) => `expected an object, got ${show(issue.input)}`),
    v.rawTransform(({ dataset: { value: input }, config }) => {
      const report = Report.of(config);
      const values: Record<string, Out | undefined> = Object.create(null);
      for (const name of Object.keys(input)) values[name] = report.parse(item, input[name], name);
      return values as Record<string, Out>;
    }),
    hasShape({ kind: "dictionary", item }),
  );
}

/** Whether `input` can hold named fields: an object, and not an array. */
function isObject(input: unknown): input is object {
  return typeof input === "object" && input !== null && !Array.isArray(input);
}
