import type { Completion, CompletionContext, CompletionResult } from "@codemirror/autocomplete";

import type { SyntaxNode, Tree } from "@lezer/common";
import { child, keyOf, rootValue, valueIn } from "./jsonPosition";
import { fieldsOf, type JsonSchema, schemaOf, schemaOfKey } from "./schemaWalk";
import { wholeTree } from "./wholeTree";

/** Suggests keys and values, as the schema has them and the names the scene itself defines. */
export function completeScene(schema: JsonSchema): (context: CompletionContext) => CompletionResult | null {
  return (context) => {
    const text = context.state.doc.toString();

    const tree = wholeTree(context.state);
    const node = tree.resolveInner(context.pos, -1);
    if (node.name === "PropertyName") return suggestKeys(node, node.parent?.parent, schema, text);
    const property = node.name === "Property" ? node : node.parent;
    if (node.name === "String" && property?.name === "Property") {
      return suggestValues(node, property, schema, text, tree);
    }
    if (!context.explicit) return null;
    if (node.name === "Object") return suggestKeys({ from: context.pos, to: context.pos }, node, schema, text);
    if (property?.name !== "Property" || valueIn(property) !== undefined) return null;
    return suggestValues({ from: context.pos, to: context.pos }, property, schema, text, tree);
  };
}

/** What a suggestion takes the place of; a syntax node is one. */
type Place = { readonly from: number; readonly to: number };

function suggestKeys(
  place: Place,
  object: SyntaxNode | null | undefined,
  root: JsonSchema,
  text: string,
): CompletionResult | null {
  const schema = object && schemaOf(object, root, text);
  const fields = object && schema && fieldsOf(object, schema, text);
  if (!object || !fields) return null;
  const present = object.getChildren("Property").filter(({ from }) => from !== place.from);
  const taken = new Set(present.map((property) => keyOf(property, text)));
  const following = text.slice(place.to).trimStart();
  const options = Object.entries(fields)
    .filter(([key]) => key !== "$schema" && !taken.has(key))
    .map(([key, field], order): Completion => {
      const label = JSON.stringify(key);
      const value = following.startsWith(":") ? "" : `: ${sampleOf(field)}${following.startsWith('"') ? "," : ""}`;
      return { label, apply: label + value, type: "property", boost: -order, ...described(field) };
    });
  return resultAt(place, options);
}

function suggestValues(
  place: Place,
  property: SyntaxNode,
  root: JsonSchema,
  text: string,
  tree: Tree,
): CompletionResult | null {
  const key = keyOf(property, text);
  const field = property.parent ? schemaOfKey(property.parent, key, root, text) : undefined;
  if (field === undefined) return null;
  const values = field.enum ?? (field.type === "boolean" ? [true, false] : namesFor(key, text, tree));
  const options = values.map((value, order): Completion => {
    const label = JSON.stringify(value);
    return { label, type: "constant", boost: -order };
  });
  return options.length === 0 ? null : resultAt(place, options);
}

/** Where there is nothing yet there is nothing to choose by. */
function resultAt({ from, to }: Place, options: readonly Completion[]): CompletionResult {
  return { from, to, options, filter: from !== to };
}

/** What a scene's own names are for: `material` names one of `materials`, `baseColorTexture` and its `texture` one of `textures`. */
function namesFor(key: string, text: string, tree: Tree): string[] {
  const list = key === "material" ? "materials" : /texture$/i.test(key) ? "textures" : undefined;
  const root = rootValue(tree);
  const property = list && root && child(root, list, text);
  const names = property && valueIn(property)?.getChildren("Property");
  return names?.map((name) => keyOf(name, text)) ?? [];
}

/** A value to start from. */
function sampleOf(schema: JsonSchema): string {
  if (schema.default !== undefined) return JSON.stringify(schema.default).replaceAll(",", ", ");
  const isString = [schema, schema.anyOf?.[0]].some((each) => each?.type === "string");
  if (schema.enum !== undefined || isString) return '""';
  if (schema.type === "array") {
    return schema.minItems === undefined
      ? "[]"
      : `[${Array(schema.minItems)
          .fill(sampleOf(schema.items ?? {}))
          .join(", ")}]`;
  }
  if (schema.type === "boolean") return "false";
  return schema.type === "number" || schema.type === "integer" ? "1" : "{}";
}

function described({ description, default: initial }: JsonSchema): Partial<Completion> {
  const detail = initial === undefined ? {} : { detail: `= ${JSON.stringify(initial)}` };
  return { ...detail, ...(description ? { info: description } : {}) };
}
