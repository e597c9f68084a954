import type { SyntaxNode } from "@lezer/common";
import { child, keyOf, stringOf, valueIn } from "./jsonPosition";

/** As much of JSON Schema (draft 7) as the scene's uses. */
export type JsonSchema = {
  readonly type?: string;
  readonly description?: string;
  readonly default?: unknown;
  readonly const?: unknown;
  readonly enum?: readonly unknown[];
  readonly properties?: { readonly [key: string]: JsonSchema };
  readonly additionalProperties?: JsonSchema | boolean;
  readonly required?: readonly string[];
  readonly items?: JsonSchema;
  readonly minItems?: number;
  readonly anyOf?: readonly JsonSchema[];
};

/** What the schema says of the value at `node`, going by its place; `undefined` where it says nothing. */
export function schemaOf(node: SyntaxNode, root: JsonSchema, text: string): JsonSchema | undefined {
  const { parent } = node;
  if (parent === null || parent.name === "JsonText") return root;
  if (parent.name === "Array") return schemaOf(parent, root, text)?.items;
  if (parent.name === "Property" && parent.parent !== null) {
    return schemaOfKey(parent.parent, keyOf(parent, text), root, text);
  }
  return schemaOf(parent, root, text);
}

/** What the schema says of the value under `key` in an `Object`. */
export function schemaOfKey(object: SyntaxNode, key: string, root: JsonSchema, text: string): JsonSchema | undefined {
  const schema = schemaOf(object, root, text);
  const fields = schema && fieldsOf(object, schema, text);
  if (fields && Object.hasOwn(fields, key)) return fields[key];
  return typeof schema?.additionalProperties === "object" ? schema.additionalProperties : undefined;
}

/** The keys an `Object` may have: of a union, those of its `type`, and of that alone until it has one. */
export function fieldsOf(
  object: SyntaxNode,
  schema: JsonSchema,
  text: string,
): { readonly [key: string]: JsonSchema } | undefined {
  if (schema.anyOf === undefined) return schema.properties;
  const [first, second] = schema.anyOf;
  if (first?.type === "string") return second?.properties; // an object in place of a string
  const property = child(object, "type", text);
  const value = property && valueIn(property);
  const type = value && stringOf(value, text);
  const chosen = schema.anyOf.find(({ properties }) => properties?.type?.const === type);
  const types = { enum: schema.anyOf.map(({ properties }) => properties?.type?.const) };
  return chosen ? { ...chosen.properties, type: { ...types, description: chosen.description ?? "" } } : { type: types };
}
