import type { ESTree } from "vite";
import { declarationOf, parseSource } from "./docstrings";

/** What the docstrings of a schema's source say: of the schema itself, of its fields by name, and of what is in it. */
export type SchemaDocs = {
  readonly text?: string;
  readonly fields: ReadonlyMap<string, SchemaDocs>;
  readonly item?: SchemaDocs;
};

export const NO_DOCS: SchemaDocs = { fields: new Map() };

const CONTAINERS = ["list", "pair", "triple", "dictionary"];

/**
 * The docstrings of every constant at the top of a TypeScript file that holds a schema: its own, and those of the fields of
 * the object literal in it.
 *
 * @param known - the constants of files it imports, for fields whose schema is one of those.
 */
export function readSchemaDocs(
  source: string,
  known: ReadonlyMap<string, SchemaDocs> = new Map(),
): ReadonlyMap<string, SchemaDocs> {
  const { body, docstringOf } = parseSource(source);
  const constants = new Map(known);

  /** Of the first object literal in nested calls, or of the constant that stands in its place. */
  const docsOf = (node: ESTree.Node | null | undefined): SchemaDocs => {
    if (node?.type === "Identifier") return constants.get(node.name) ?? NO_DOCS;
    if (node?.type === "CallExpression") {
      const docs = docsOf(node.arguments[0]);
      const isContainer = node.callee.type === "Identifier" && CONTAINERS.includes(node.callee.name);
      return isContainer ? { ...NO_DOCS, item: docs } : docs;
    }
    if (node?.type !== "ObjectExpression") return NO_DOCS;
    const fields = node.properties.flatMap((property) => {
      if (property.type !== "Property" || property.key.type !== "Identifier") return [];
      return [[property.key.name, withText(docsOf(property.value), docstringOf(property)?.text)] as const];
    });
    return { fields: new Map(fields) };
  };

  for (const statement of body) {
    const declaration = declarationOf(statement);
    if (declaration.type !== "VariableDeclaration") continue;
    for (const { id, init } of declaration.declarations) {
      if (id.type === "Identifier") constants.set(id.name, withText(docsOf(init), docstringOf(statement)?.text));
    }
  }
  return constants;
}

function withText(docs: SchemaDocs, text: string | undefined): SchemaDocs {
  return text === undefined ? docs : { ...docs, text };
}
