import { type ESTree, parseSync } from "vite";

/** What a docstring says: its description, one line per paragraph, and its tags in order. */
export type Docstring = { readonly text: string; readonly tags: readonly Tag[] };

/** `@slot poster - Shown until there is a picture.` */
export type Tag = { readonly name: string; readonly text: string };

/** A TypeScript file as a tree, and the docstrings in it. */
export type Source = {
  readonly body: readonly ESTree.Node[];
  /** The docstring in front of a node, if there is one. */
  docstringOf(node: ESTree.Node): Docstring | undefined;
  /** The source of a node: `number | undefined`. */
  textOf(node: ESTree.Node): string;
};

/** @throws {SyntaxError} if it is not TypeScript. */
export function parseSource(source: string): Source {
  const { program, comments, errors } = parseSync("source.ts", source);
  if (errors.length > 0) throw new SyntaxError(errors.map(({ message }) => message).join("\n"));
  const docstrings = comments.filter(({ type, value }) => type === "Block" && value.startsWith("*"));
  return {
    // What is exported has its docstring in front of the keyword.
    body: program.body,
    docstringOf: ({ start }) => {
      const comment = docstrings.find((each) => each.end <= start && source.slice(each.end, start).trim() === "");
      return comment && parseDocstring(comment.value);
    },
    textOf: ({ start, end }) => source.slice(start, end),
  };
}

/** What a statement declares: itself, or what it exports. */
export function declarationOf(statement: ESTree.Node): ESTree.Node {
  return statement.type === "ExportNamedDeclaration" && statement.declaration ? statement.declaration : statement;
}

/** The module from which a file imports a name. */
export function importedFrom({ body }: Source, name: string): string | undefined {
  for (const statement of body) {
    if (statement.type !== "ImportDeclaration") continue;
    if (statement.specifiers.some(({ local }) => local.name === name)) return statement.source.value;
  }
  return undefined;
}

function parseDocstring(comment: string): Docstring {
  const lines = comment.split("\n").map((line) => line.replace(/^\s*\*+ ?/, "").trim());
  const [text = "", ...tags] = lines.join("\n").split(/^@/m);
  return {
    text: unwrap(text),
    tags: tags.map((tag) => ({ name: /^\w+/.exec(tag)?.[0] ?? "", text: unwrap(tag.replace(/^\w+/, "")) })),
  };
}

function unwrap(text: string): string {
  const paragraphs = text.trim().split(/\n{2,}/);
  return paragraphs.map((paragraph) => paragraph.replaceAll("\n", " ")).join("\n\n");
}
