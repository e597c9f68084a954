import * as v from "valibot";
import { type Shape, shapeOf } from "../src/scene/shape";
import { NO_DOCS, type SchemaDocs } from "./schemaDocs";

export type JsonSchema = { readonly [keyword: string]: unknown };

/**
 * JSON Schema (draft 7) of what a valibot schema of ours takes as input, with defaults, and descriptions from docstrings. No
 * references: every definition stands where it is used, which editors follow best.
 *
 * Rules that look at several fields together are not in it.
 *
 * @throws {TypeError} for a schema about which it knows nothing; give it a shape.
 */
export function toJsonSchema(schema: v.GenericSchema, docs: SchemaDocs = NO_DOCS): JsonSchema {
  const description = docs.text === undefined ? {} : { description: docs.text };
  const defaultValue: unknown = v.getDefault(schema);
  const given = defaultValue === undefined ? {} : { default: defaultValue };
  return { ...description, ...keywords(schema, docs), ...given };
}

function keywords(schema: v.GenericSchema, docs: SchemaDocs): JsonSchema {
  const shape = shapeOf(schema);
  if (shape !== undefined) return ofShape(shape, docs);
  if (is(schema, "optional")) return keywords((schema as v.OptionalSchema<v.GenericSchema, unknown>).wrapped, docs);
  if (is(schema, "picklist")) return { enum: (schema as v.PicklistSchema<readonly string[], undefined>).options };
  if (is(schema, "literal")) return { const: (schema as v.LiteralSchema<string, undefined>).literal };
  if (is(schema, "string") || is(schema, "boolean")) return { type: schema.type };
  throw new TypeError(`No JSON Schema is known for a valibot schema of type "${schema.type}"; give it a shape.`);
}

function ofShape(shape: Shape, docs: SchemaDocs): JsonSchema {
  switch (shape.kind) {
    case "number":
      return numberKeywords(shape);
    case "object": {
      const entries = Object.entries(shape.entries) as [string, v.GenericSchema][];
      return {
        type: "object",
        properties: Object.fromEntries(entries.map(([key, entry]) => [key, toJsonSchema(entry, docs.fields.get(key))])),
        required: entries.filter(([, entry]) => !is(entry, "optional")).map(([key]) => key),
        additionalProperties: false,
      };
    }
    case "byType":
      return {
        type: "object",
        required: ["type"],
        anyOf: Object.entries(shape.options).map(([type, option]) => toJsonSchema(option, docs.fields.get(type))),
      };
    case "list":
      return { type: "array", items: toJsonSchema(shape.item, docs.item) };
    case "tuple": {
      const contains = shape.isNonZero === true ? { contains: { not: { const: 0 } } } : {};
      const { length } = shape;
      return {
        type: "array",
        items: toJsonSchema(shape.item, docs.item),
        minItems: length,
        maxItems: length,
        ...contains,
      };
    }
    case "stringOr":
      return { anyOf: [{ type: "string" }, toJsonSchema(shape.object, { fields: docs.fields })] };
    case "dictionary":
      return { type: "object", additionalProperties: toJsonSchema(shape.item, docs.item) };
  }
}

/** Of two bounds on one side only the tighter one is said. */
function numberKeywords({ min, max, above, below, isInteger }: Shape & { kind: "number" }): JsonSchema {
  const isAbove = above !== undefined && !(min !== undefined && min > above);
  const isBelow = below !== undefined && !(max !== undefined && max < below);
  return {
    type: isInteger === true ? "integer" : "number",
    ...(isAbove ? { exclusiveMinimum: above } : min === undefined ? {} : { minimum: min }),
    ...(isBelow ? { exclusiveMaximum: below } : max === undefined ? {} : { maximum: max }),
  };
}

function is(schema: v.GenericSchema, type: string): boolean {
  return schema.type === type;
}
