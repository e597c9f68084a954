import { type ESTree, parseSync } from "vite";

/** What the docstrings of a schema's source say: of the schema itself, of its fields by name, and of what is in it. */
export type Docs = { readonly text?: string; readonly fields: ReadonlyMap<string, Docs>; readonly item?: Docs };

type Comment = ReturnType<typeof parseSync>["comments"][number];

const CONTAINERS = ["list", "triple", "dictionary"];

export const NO_DOCS: Docs = { fields: new Map() };

/**
 * The docstrings of every constant at the top of a TypeScript file that holds a schema: its own, and those of the fields of
 * the object literal in it.
 *
 * @param known - the constants of files it imports, for fields whose schema is one of those.
 */
export function readDocs(source: string, known: ReadonlyMap<string, Docs> = new Map()): ReadonlyMap<string, Docs> {
  const { program, comments, errors } = parseSync("schema.ts", source);
  if (errors.length > 0) throw new SyntaxError(errors.map(({ message }) => message).join("\n"));
  const docstrings = comments.filter(({ type, value }) => type === "Block" && value.startsWith("*"));
  const constants = new Map(known);

  const textBefore = (node: { start: number }) => {
    const comment = docstrings.find(
      ({ end, start }) => start < node.start && source.slice(end, node.start).trim() === "",
    );
    return comment && textOf(comment);
  };
  /** Of the first object literal in nested calls, or of the constant that stands in its place. */
  const docsOf = (node: ESTree.Node | undefined): Docs => {
    if (node?.type === "Identifier") return constants.get(node.name) ?? NO_DOCS;
    if (node?.type === "CallExpression") {
      const docs = docsOf(node.arguments[0]);
      const isContainer = node.callee.type === "Identifier" && CONTAINERS.includes(node.callee.name);
      return isContainer ? { ...NO_DOCS, item: docs } : docs;
    }
    if (node?.type !== "ObjectExpression") return NO_DOCS;
    const fields = node.properties.flatMap((property) => {
      if (property.type !== "Property" || property.key.type !== "Identifier") return [];
      return [[property.key.name, withText(docsOf(property.value), textBefore(property))] as const];
    });
    return { fields: new Map(fields) };
  };

  for (const statement of program.body) {
    const declaration = statement.type === "ExportNamedDeclaration" ? statement.declaration : statement;
    if (declaration?.type !== "VariableDeclaration") continue;
    for (const { id, init } of declaration.declarations) {
      if (id.type !== "Identifier") continue;
      constants.set(id.name, withText(docsOf(init ?? undefined), textBefore(statement)));
    }
  }
  return constants;
}

function withText(docs: Docs, text: string | undefined): Docs {
  return text === undefined ? docs : { ...docs, text };
}

/** The description in a docstring, without its tags; one line per paragraph. */
function textOf({ value }: Comment): string {
  const lines = value.split("\n").map((line) => line.replace(/^\s*\*+ ?/, "").trim());
  const end = lines.findIndex((line) => line.startsWith("@"));
  const paragraphs = lines
    .slice(0, end < 0 ? undefined : end)
    .join("\n")
    .trim()
    .split(/\n{2,}/);
  return paragraphs.map((paragraph) => paragraph.replaceAll("\n", " ")).join("\n\n");
}
