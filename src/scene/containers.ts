// Objects, lists and dictionaries that report everything that is wrong with them.
//
// valibot's own `strictObject`, `variant` and `record` stop at the first unknown key, take an array for an object, and
// drop keys such as "constructor" without a word. These build on its public actions instead, and infer the same types.

import * as v from "valibot";
import { oneOf, show, suggest } from "./describe";
import { hasShape } from "./shape";

/** Past this many faulty entries the rest of a list is not looked at: a million holes are one mistake. */
export const MAX_FAULTY_ENTRIES = 1000;
export const HOPELESS = `has ${MAX_FAULTY_ENTRIES} faulty entries; the rest was not checked`;

type Input<Entries extends v.ObjectEntries> = Readonly<v.InferInput<v.StrictObjectSchema<Entries, undefined>>>;
type Output<Entries extends v.ObjectEntries> = Readonly<v.InferOutput<v.StrictObjectSchema<Entries, undefined>>>;
type AddIssue = (info: { message: string; path?: [v.IssuePathItem, ...v.IssuePathItem[]] }) => void;

/** Adds an issue to the object being parsed, at one of its fields or further in. */
export type AddFieldIssue<Key> = (path: readonly [Key, ...(string | number)[]], message: string) => void;

/**
 * An object with exactly these fields. A field that is `undefined` counts as absent.
 *
 * @param entries - a schema per field; `v.optional(…, default)` where it may be absent.
 * @param check - looks at several fields together; a field that is itself at fault is `undefined` there.
 */
export function strictObject<const Entries extends v.ObjectEntries>(
  entries: Entries,
  check?: (fields: Partial<Output<Entries>>, addIssue: AddFieldIssue<keyof Entries & string>) => void,
): v.GenericSchema<Input<Entries>, Output<Entries>> {
  const known = Object.keys(entries);
  return v.pipe(
    v.custom<Input<Entries>>(isObject, (issue) => `expected an object, got ${show(issue.input)}`),
    v.rawTransform(({ dataset: { value: input }, addIssue }) => {
      const fields: Partial<Output<Entries>> = {};
      for (const [key, schema] of Object.entries(entries)) {
        const parsed = parseEntry(schema, input, key, addIssue);
        if (parsed.success && parsed.output !== undefined) Object.assign(fields, { [key]: parsed.output });
      }
      for (const key of Object.keys(input)) {
        if (Object.hasOwn(entries, key)) continue;
        const hint = suggest(key, known) || `; the keys here are ${known.map((name) => `"${name}"`).join(", ")}`;
        addIssue({ message: `unknown key${hint}`, path: [pathItem(input, key)] });
      }
      check?.(fields, ([first, ...rest], message) => {
        addIssue({ message, path: [pathItem(input, first), ...rest.map((key) => pathItem(input, key))] });
      });
      return fields as Output<Entries>; // complete: otherwise there are issues, and valibot drops it
    }),
    hasShape({ kind: "object", entries }),
  );
}

/**
 * One of several objects, told apart by their `type`.
 *
 * @param options - the schema of each type.
 */
export function byType<const Options extends Readonly<Record<string, v.GenericSchema>>>(
  options: Options,
): v.GenericSchema<v.InferInput<Options[keyof Options]>, v.InferOutput<Options[keyof Options]>> {
  const types = Object.keys(options);
  return v.pipe(
    v.custom<v.InferInput<Options[keyof Options]>>(isObject, (issue) => `expected an object, got ${show(issue.input)}`),
    v.rawTransform(({ dataset: { value: input }, addIssue, NEVER }) => {
      const type: unknown = Reflect.get(Object(input), "type");
      if (typeof type !== "string" || !Object.hasOwn(options, type)) {
        const message = `expected ${oneOf(types)}, got ${show(type)}${suggest(type, types)}`;
        addIssue({ message, path: [pathItem(input, "type")] });
        return NEVER;
      }
      const parsed = v.safeParse(options[type]!, input);
      if (parsed.success) return parsed.output;
      for (const issue of parsed.issues) addIssue({ message: issue.message, ...(issue.path && { path: issue.path }) });
      return NEVER;
    }),
    hasShape({ kind: "byType", options }),
  );
}

/**
 * Exactly three of something.
 *
 * @param expected - how a correct value looks, for the error: `[x, y, z]`.
 */
export function triple<In, Out>(
  item: v.GenericSchema<In, Out>,
  expected: string,
): v.GenericSchema<readonly [In, In, In], readonly [Out, Out, Out]> {
  return v.pipe(
    v.custom<readonly [In, In, In]>(
      (input) => Array.isArray(input) && input.length === 3,
      (issue) => `expected ${expected}, got ${show(issue.input)}`,
    ),
    v.rawTransform(({ dataset: { value: input }, addIssue, NEVER }) => {
      const items: Out[] = [];
      for (let i = 0; i < 3; i++) {
        const parsed = parseEntry(item, input, i, addIssue);
        if (parsed.success) items.push(parsed.output);
      }
      const [a, b, c] = items;
      return items.length === 3 ? ([a, b, c] as [Out, Out, Out]) : NEVER;
    }),
    hasShape({ kind: "triple", item }),
  );
}

/** An array of any length. The result is a new array. */
export function list<In, Out>(item: v.GenericSchema<In, Out>): v.GenericSchema<readonly In[], readonly Out[]> {
  return v.pipe(
    v.custom<readonly In[]>(Array.isArray, (issue) => `expected an array, got ${show(issue.input)}`),
    v.rawTransform(({ dataset: { value: input }, addIssue }) => {
      const items: Out[] = [];
      for (let i = 0, faulty = 0; i < input.length && !isHopeless(faulty, addIssue); i++) {
        const parsed = parseEntry(item, input, i, addIssue);
        if (parsed.success) items.push(parsed.output);
        else faulty++;
      }
      return items;
    }),
    hasShape({ kind: "list", item }),
  );
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
    v.rawTransform(({ dataset: { value: input }, addIssue }) => {
      const values: Record<string, Out> = Object.create(null);
      let faulty = 0;
      for (const name of Object.keys(input)) {
        if (isHopeless(faulty, addIssue)) break;
        const parsed = parseEntry(item, input, name, addIssue);
        if (parsed.success) values[name] = parsed.output;
        else faulty++;
      }
      return values;
    }),
    hasShape({ kind: "dictionary", item }),
  );
}

/** Parses `container[key]` and hands its issues on, with their paths from the container. */
function parseEntry<In, Out>(
  schema: v.GenericSchema<In, Out>,
  container: unknown,
  key: string | number,
  addIssue: AddIssue,
): v.SafeParseResult<v.GenericSchema<In, Out>> {
  const parsed = v.safeParse(schema, Reflect.get(Object(container), key));
  for (const { message, path } of parsed.issues ?? []) {
    addIssue({ message, path: [pathItem(container, key), ...(path ?? [])] });
  }
  return parsed;
}

/** Whether the rest of a list is not worth looking at; says so. */
export function isHopeless(faultyCount: number, addIssue: AddIssue): boolean {
  if (faultyCount < MAX_FAULTY_ENTRIES) return false;
  addIssue({ message: HOPELESS });
  return true;
}

/** One step of the way to a value, as valibot writes it. */
export function pathItem(input: unknown, key: string | number): v.UnknownPathItem {
  return { type: "unknown", origin: "value", input, key, value: undefined };
}

/** Whether `input` can hold named fields: an object, and not an array. */
export function isObject(input: unknown): input is object {
  return typeof input === "object" && input !== null && !Array.isArray(input);
}
